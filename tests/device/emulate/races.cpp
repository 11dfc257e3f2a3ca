// Races in shared memory: each word knows who has written and read it last, and since which barrier.
#include <algorithm>
#include <cstdio>

#include "access.hpp"
#include "options.hpp"

namespace emulate {

namespace {

/// A conflict was found: says which.
__attribute__((noinline)) void conflict(Warp& w, const Instruction& i, int lane, std::uint32_t k, const char* wrong,
                                        std::uint32_t other) {
  const Group& g = *w.group;
  char text[500];
  if (other < 64)
    std::snprintf(text, sizeof text,
                  "%s (byte %u of shared memory; the other is warp %u; last written by lane %u of warp %u at line %u "
                  "of the PTX: %s)",
                  wrong, k * 4, other, unsigned(g.shadow[k].writer_lane), unsigned(g.shadow[k].writer),
                  g.write_lines[k], g.kernel->module->locate(static_cast<int>(g.write_lines[k])).c_str());
  else
    std::snprintf(text, sizeof text, "%s (byte %u of shared memory)", wrong, k * 4);
  fault(w, lane, i.line, text);
}

}  // namespace

void check_shared(Warp& w, const Instruction& i, std::uint32_t mask, const std::uint64_t* offset, unsigned bytes) {
  Group& g = *w.group;
  const std::uint32_t own = 1u << w.index, epoch = g.epoch, first_epoch = g.first_epoch;
  const auto index = static_cast<std::uint8_t>(w.index);
  const bool writes = i.is_store || i.is_atomic, reads = !i.is_store, exact = bytes >= 4;
  std::uint64_t before = ~0ull;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    if (!writes && offset[l] == before) continue;
    before = offset[l];
    const auto first = static_cast<std::uint32_t>(offset[l] >> 2),
               last = static_cast<std::uint32_t>((offset[l] + bytes - 1) >> 2);
    for (std::uint32_t k = first; k <= last; ++k) {
      Shadow& s = g.shadow[k];
      const bool quiet = !exact || (i.is_atomic && s.atomic);
      if (reads && s.written < first_epoch) {
        if (options().uninitialised && exact)
          conflict(w, i, l, k, "reads shared memory that no thread of the block has written", 64);
      } else if (s.written == epoch && s.writer != index && !quiet) {
        conflict(w, i, l, k,
                 writes ? "RACE: writes shared memory that another warp writes, with no barrier between"
                        : "RACE: reads shared memory that another warp writes, with no barrier between",
                 s.writer);
      }
      if (writes) {
        if (s.read == epoch && (s.readers & ~own) && !quiet)
          conflict(w, i, l, k, "RACE: writes shared memory that another warp reads, with no barrier between",
                   static_cast<std::uint32_t>(std::countr_zero(s.readers & ~own)));
        s.written = epoch;
        s.writer = index;
        s.writer_lane = static_cast<std::uint8_t>(l);
        s.atomic = i.is_atomic;
        g.write_lines[k] = static_cast<std::uint32_t>(i.line);
      } else {
        if (s.read != epoch) s.read = epoch, s.readers = 0;
        s.readers |= own;
      }
    }
  }
}

void check_lanes(Warp& w, const Instruction& i, std::uint32_t mask, const std::uint64_t* offset, unsigned bytes) {
  Group& g = *w.group;
  if (bytes < 4 || i.is_atomic) return;
  for (std::uint32_t m = mask; m; m &= m - 1) {
    const int l = std::countr_zero(m);
    for (auto k = static_cast<std::uint32_t>(offset[l] >> 2);
         k <= static_cast<std::uint32_t>((offset[l] + bytes - 1) >> 2); ++k) {
      const Shadow& s = g.shadow[k];
      LaneShadow& t = g.lane_shadow[k];
      const bool written = s.written == g.epoch && s.writer == w.index && t.written_sync == w.sync && !s.atomic;
      if (written && s.writer_lane != l && !i.is_store)
        conflict(w, i, l, k,
                 "race within a warp: reads shared memory that another lane writes, with no __syncwarp between",
                 static_cast<std::uint32_t>(w.index));
      const bool read = s.read == g.epoch && t.reader == static_cast<std::uint32_t>(w.index) && t.read_sync == w.sync;
      if (i.is_store) {
        if (read && (t.readers & ~(1u << l)))
          conflict(w, i, l, k,
                   "race within a warp: writes shared memory that another lane reads, with no __syncwarp between",
                   static_cast<std::uint32_t>(w.index));
        t.written_sync = w.sync;
        t.readers = 0;
        g.shadow[k].written = g.epoch;
        g.shadow[k].writer = static_cast<std::uint8_t>(w.index);
        g.shadow[k].writer_lane = static_cast<std::uint8_t>(l);
        g.shadow[k].atomic = 0;
      } else {
        if (!read) t.readers = 0;
        t.reader = static_cast<std::uint32_t>(w.index);
        t.read_sync = w.sync;
        t.readers |= 1u << l;
      }
    }
  }
}

}  // namespace emulate
