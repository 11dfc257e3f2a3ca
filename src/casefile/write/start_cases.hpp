// Short cases to start from: what differs from the defaults, with comments.
#pragma once

#include <string>
#include <vector>

namespace softwet {

/// Names of the scenes that start_case knows.
std::vector<std::string> start_cases();

/// The case of that scene, about thirty lines long. Throws Error when no case can have the name.
std::string start_case(const std::string& scene, const std::string& name);

}  // namespace softwet
