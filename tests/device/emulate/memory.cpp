#include "memory.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstring>

#include "options.hpp"
#include "ptx.hpp"

namespace emulate {

DeviceMemory& memory() {
  static auto* all = new DeviceMemory;  // outlives the destructors of the program
  return *all;
}

DeviceMemory::DeviceMemory() : size_(std::uint64_t(64) << 30) {
  constexpr int flags = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
  void* names = mmap(nullptr, size_, PROT_NONE, flags, -1, 0);
  void* bytes = mmap(nullptr, size_, PROT_READ | PROT_WRITE, flags, -1, 0);
  void* table = mmap(nullptr, size_ / grain * 2, PROT_READ | PROT_WRITE, flags, -1, 0);
  if (names == MAP_FAILED || bytes == MAP_FAILED || table == MAP_FAILED)
    throw Problem("no address space for the device's memory");
  begin_ = reinterpret_cast<std::uint64_t>(names);
  distance_ = reinterpret_cast<std::uint64_t>(bytes) - begin_;
  valid_ = static_cast<std::uint16_t*>(table);
  top_ = begin_ + 4096;
}

std::uint64_t DeviceMemory::allocate(std::size_t bytes, const std::string& what) {
  const std::lock_guard lock(mutex_);
  if (in_use_ + bytes > options().memory) return 0;
  const std::size_t reserved = (bytes + 2 * grain) / grain * grain;  // at least one byte that is not live behind it
  std::uint64_t address = 0;
  if (const auto old = free_.lower_bound(reserved); old != free_.end() && old->first <= 2 * reserved) {
    address = old->second;
    const std::size_t all = old->first;
    free_.erase(old);
    freed_.erase(address);
    blocks_[address] = {bytes, all, what};
  } else {
    if (top_ + reserved > begin_ + size_) return 0;
    address = top_;
    top_ += reserved;
    blocks_[address] = {bytes, reserved, what};
  }
  in_use_ += bytes;
  peak_ = std::max(peak_, in_use_);
  for (std::size_t b = 0; b < bytes; b += grain)
    valid_[(address - begin_ + b) / grain] = static_cast<std::uint16_t>(std::min<std::size_t>(grain, bytes - b));
  if (options().fill >= 0) std::memset(host(address), options().fill, bytes);
  return address;
}

bool DeviceMemory::release(std::uint64_t address) {
  const std::lock_guard lock(mutex_);
  const auto found = blocks_.find(address);
  if (found == blocks_.end()) return false;
  std::memset(valid_ + (address - begin_) / grain, 0, found->second.reserved / grain * 2);
  ++generation_;
  in_use_ -= found->second.bytes;
  free_.emplace(found->second.reserved, address);
  freed_[address] = found->second;
  if (found->second.reserved > (1 << 20)) madvise(host(address), found->second.reserved, MADV_DONTNEED);
  blocks_.erase(found);
  return true;
}

std::pair<std::uint64_t, std::uint64_t> DeviceMemory::around(std::uint64_t address) const {
  const std::lock_guard lock(mutex_);
  auto after = blocks_.upper_bound(address);
  if (after == blocks_.begin()) return {0, 0};
  --after;
  if (address >= after->first + after->second.bytes) return {0, 0};
  return {after->first, after->first + after->second.bytes};
}

bool DeviceMemory::live_range(std::uint64_t address, std::size_t bytes) const {
  const std::lock_guard lock(mutex_);
  auto after = blocks_.upper_bound(address);
  if (after == blocks_.begin()) return false;
  --after;
  return address + bytes <= after->first + after->second.bytes;
}

std::string DeviceMemory::describe(std::uint64_t address) const {
  const std::lock_guard lock(mutex_);
  char text[400];
  if (!inside(address)) {
    std::snprintf(text, sizeof text, "0x%llx is no memory of the device%s", static_cast<unsigned long long>(address),
                  address < 65536 ? " (null)" : "");
    return text;
  }
  const auto relate = [&](const std::map<std::uint64_t, Block>& all, const char* kind) -> bool {
    auto after = all.upper_bound(address);
    if (after == all.begin()) return false;
    --after;
    const std::uint64_t at = address - after->first;
    if (at >= after->second.reserved + 65536) return false;
    if (at < after->second.bytes)
      std::snprintf(text, sizeof text, "byte %llu of %s %zu bytes (%s)", static_cast<unsigned long long>(at), kind,
                    after->second.bytes, after->second.what.c_str());
    else
      std::snprintf(text, sizeof text, "%llu bytes behind the end of %s %zu bytes (%s)",
                    static_cast<unsigned long long>(at - after->second.bytes), kind, after->second.bytes,
                    after->second.what.c_str());
    return true;
  };
  if (relate(freed_, "freed") && freed_.upper_bound(address) != freed_.begin()) {
    auto block = freed_.upper_bound(address);
    --block;
    if (address < block->first + block->second.reserved) return text;
  }
  if (relate(blocks_, "live")) return text;
  std::snprintf(text, sizeof text, "0x%llx is in no allocation", static_cast<unsigned long long>(address));
  return text;
}

void DeviceMemory::add_pinned(void* place, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  pinned_[reinterpret_cast<std::uint64_t>(place)] = bytes;
}

bool DeviceMemory::remove_pinned(void* place) {
  const std::lock_guard lock(mutex_);
  return pinned_.erase(reinterpret_cast<std::uint64_t>(place)) > 0;
}

bool DeviceMemory::pinned(std::uint64_t address, unsigned bytes) const {
  const std::lock_guard lock(mutex_);
  auto after = pinned_.upper_bound(address);
  if (after == pinned_.begin()) return false;
  --after;
  return address + bytes <= after->first + after->second;
}

}  // namespace emulate
