// Starting from the result of another run.
#pragma once

#include <functional>
#include <string>

#include "case/case.hpp"

namespace softwet {

/// The case with the last state of the run that initial.from names, from its case.toml and checkpoint.h5, or with its
/// state at initial.time, from its field files; the case itself where it names none. Each process reads the files.
/// Throws Error (invalid_input) where they cannot be read, and where the box or the height of the wall differs.
/// @param warn  hears what is lost on the way (run/host/earlier_losses.hpp)
Case with_earlier_run(const Case&, const std::function<void(const std::string&)>& warn = {});

}  // namespace softwet
