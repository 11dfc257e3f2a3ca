// Replaces operator new of the test program by one that counts. It is a library of its own: sources that see both this
// and its callers are warned of a mismatch that is none, and compilers for a device refuse its exception.
#include "allocations.hpp"

#include <cstdlib>
#include <new>

namespace softwet::testing_tools {
std::atomic<long> large_allocations = 0;
}

namespace {
void* counted(std::size_t size) {
  if (size > 256) ++softwet::testing_tools::large_allocations;
  return std::malloc(size > 0 ? size : 1);
}
}  // namespace

void* operator new(std::size_t size) {
  if (void* memory = counted(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
