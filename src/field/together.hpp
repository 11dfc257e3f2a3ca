// Work that may fail on one process alone: all go on, or all end alike.
#pragma once

#include <functional>

namespace softwet {

/// Runs `work`, in which no process sends anything to another, and waits for all of them. Where it has failed on some,
/// all throw what the first of these has thrown.
/// @throws Error  of the work; with several processes, machine_failed in the place of other exceptions
void together(const std::function<void()>& work);

/// Runs the work of the first process, such as all writing of files, in the same way.
void on_root(const std::function<void()>& work);

}  // namespace softwet
