// What a path leads to: the file or folder that is open already, or something that is not a file.
#pragma once

#include <cstddef>
#include <string>

namespace softwet {

/// Whether the path leads to the file open as `descriptor`: not where that was moved, removed, or replaced by another.
/// True where the system gives no answer.
bool leads_to(const std::string& path, int descriptor);

/// "a folder", "a pipe", "a device", "a socket": what the path leads to where that is not a regular file, which a
/// program may wait for without end or read without end. Empty for a regular file, and where there is nothing.
std::string no_regular_file(const std::string& path);

/// "a part of it has 300 bytes, ...": why the file system refuses the length of a path; empty where it does not. @param
/// room  bytes for names of files below it
std::string too_long(const std::string& path, std::size_t room = 0);

}  // namespace softwet
