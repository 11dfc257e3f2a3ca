// Large arrays of the host in large pages of memory, where the system has them.
#pragma once

#include <cstdint>
#include <string>

#include "memory/array.hpp"

namespace softwet {

/// Asks for large pages in a piece of host memory that has not been touched yet. Without effect where there are none.
void advise_large_pages(void* begin, std::size_t bytes);

/// An array whose entries are not initialised. Sweeps over many streams at once, and first writes, are faster in large
/// pages: fewer addresses have to be looked up, and fewer pages handed out.
template <class View>
View large_array(const std::string& label, std::int64_t entries) {
  const View view(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), entries);
  if (on_host) advise_large_pages(view.data(), entries * sizeof(typename View::value_type));
  return view;
}

}  // namespace softwet
