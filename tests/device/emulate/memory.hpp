// Memory of the device. The program gets addresses in a range that the host may not touch, so a host that reads memory of the device
// crashes where it does so; kernels find the bytes at a constant distance. A table says how many bytes of each 256 are live.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace emulate {

class DeviceMemory {
 public:
  DeviceMemory();
  /// The address that the program gets; 0: there is no room. Faults show `what`.
  std::uint64_t allocate(std::size_t bytes, const std::string& what);
  bool release(std::uint64_t address);
  bool inside(std::uint64_t address) const { return address - begin_ < size_; }
  /// Where the bytes are in the memory of the host.
  char* host(std::uint64_t address) const { return reinterpret_cast<char*>(address + distance_); }
  void* host(const void* pointer) const {
    const auto address = reinterpret_cast<std::uint64_t>(pointer);
    return inside(address) ? host(address) : const_cast<void*>(pointer);
  }
  bool live(std::uint64_t address, unsigned bytes) const {
    const std::uint64_t at = address - begin_;
    if (at >= size_ - 256) return false;
    const unsigned within = at & (grain - 1);
    return within + bytes <= valid_[at / grain];
  }
  /// The live allocation around an address: [first, second), or nothing.
  std::pair<std::uint64_t, std::uint64_t> around(std::uint64_t address) const;
  /// Changes whenever memory is freed.
  std::uint64_t generation() const { return generation_; }
  std::uint64_t distance() const { return distance_; }
  bool live_range(std::uint64_t address, std::size_t bytes) const;
  std::string describe(std::uint64_t address) const;
  std::size_t in_use() const { return in_use_; }
  std::size_t peak() const { return peak_; }

  // Memory of the host that kernels may read and write: cudaMallocHost, cudaMallocManaged.
  void add_pinned(void* place, std::size_t bytes);
  bool remove_pinned(void* place);
  bool pinned(std::uint64_t address, unsigned bytes) const;

 private:
  static constexpr unsigned grain = 256;
  struct Block {
    std::size_t bytes, reserved;
    std::string what;
  };
  std::uint64_t begin_ = 0, size_ = 0, distance_ = 0, top_ = 0;
  std::uint16_t* valid_ = nullptr;
  std::uint64_t generation_ = 1;
  std::size_t in_use_ = 0, peak_ = 0;
  std::map<std::uint64_t, Block> blocks_, freed_;   // by address
  std::multimap<std::size_t, std::uint64_t> free_;  // by size
  std::map<std::uint64_t, std::size_t> pinned_;
  mutable std::recursive_mutex mutex_;
};

DeviceMemory& memory();

}  // namespace emulate
