// What a run or a state of rest came to, for the terminal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/physical.hpp"
#include "io/table_row.hpp"

namespace softwet {

/// Lines of at most 80 characters: where the first droplet is and how fast, its contact line, its angles, ridge and
/// dimple, volume and mass, the energy and the largest speeds, with their units, and how many more droplets there are.
/// What does not exist is left out.
/// @param row  the last one of history.csv
/// @param laboratory  in whose units the numbers are; none: in those of the case
std::vector<std::string> result_lines(const Case&, const TableRow& row, const std::optional<Scales>& laboratory = {});

/// What to do next with the folder of a result: "tools/report DIR", and what ParaView opens.
/// @param fields  whether there are field files
std::vector<std::string> next_lines(const Case&, const std::string& folder, bool fields);

}  // namespace softwet
