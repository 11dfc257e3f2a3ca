// How much an access of a warp moves: sectors of global memory, cycles of the banks of shared memory.
#include <algorithm>
#include <bit>

#include "access.hpp"

namespace emulate {

int sectors(const std::uint64_t* address, std::uint32_t mask, unsigned bytes) {
  std::uint64_t seen[64];
  int count = 0;
  std::uint64_t last = ~0ull;
  bool sorted = true;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const std::uint64_t first = address[std::countr_zero(m)] >> 5,
                        end = (address[std::countr_zero(m)] + bytes - 1) >> 5;
    for (std::uint64_t s = first; s <= end; ++s) {
      if (s == last) continue;
      if (count > 0 && s < last) sorted = false;
      last = s;
      if (count < 64) seen[count++] = s;
    }
  }
  if (sorted) return count;
  std::sort(seen, seen + count);
  return static_cast<int>(std::unique(seen, seen + count) - seen);
}

int bank_cycles(const std::uint64_t* offset, std::uint32_t mask, unsigned bytes, int& least) {
  const int lanes = bytes <= 4 ? 32 : bytes == 8 ? 16 : 8, words = bytes <= 4 ? 1 : static_cast<int>(bytes / 4);
  int cycles = 0;
  least = 0;
  for (int begin = 0; begin < 32; begin += lanes) {
    std::uint32_t m = (mask >> begin) & (lanes == 32 ? ~0u : (1u << lanes) - 1);
    if (!m) continue;
    std::uint32_t word[32][32];
    std::uint8_t count[32] = {};
    int most = 1;
    for (; m; m &= m - 1) {
      const auto first = static_cast<std::uint32_t>(offset[begin + std::countr_zero(m)] >> 2);
      for (int k = 0; k < words; ++k) {
        const std::uint32_t x = first + k, bank = x & 31;
        int c = 0;
        while (c < count[bank] && word[bank][c] != x) ++c;
        if (c < count[bank]) continue;
        word[bank][count[bank]++] = x;
        most = std::max<int>(most, count[bank]);
      }
    }
    cycles += most;
    ++least;
  }
  return cycles;
}

}  // namespace emulate
