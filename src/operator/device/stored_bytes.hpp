// Small tables that a device keeps for as long as they are asked for.
#pragma once

#include "memory/array.hpp"

namespace softwet {

inline constexpr std::size_t most_stored_bytes = 27 * 1024;

/// Where the device has a copy of these bytes, most_stored_bytes at most. It is made if there is none yet, and the host
/// waits for that. The copy stays until enough others have been asked for, so that tables which come again and again
/// are copied once. Memory is allocated by the first call alone.
const std::byte* stored_bytes(const std::byte* bytes, std::size_t count);

/// Number of copies made so far, and of those that took the place of another one.
long copies_of_bytes();
long replaced_copies_of_bytes();

}  // namespace softwet
