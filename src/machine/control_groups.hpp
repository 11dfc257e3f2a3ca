// The control groups of this process (a container, a job of a cluster) and those above them, as Linux lists them.
#pragma once

#include <functional>
#include <string>

namespace softwet {

enum class GroupVersion { one, two };

/// The least number that `of_folder` finds in the folders of the groups of this process and of those above them.
/// Infinity where there are none. A container may see its own group alone, at the top.
/// @param root        what stands before /proc and /sys: a folder in tests
/// @param controller  "memory", "cpu": the name in version 1, where each controller has a tree of its own
double least_of_groups(const std::string& root, const std::string& controller,
                       const std::function<double(const std::string& folder, GroupVersion)>& of_folder);

}  // namespace softwet
