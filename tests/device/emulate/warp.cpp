// A warp: lanes that have parted run the part that is furthest behind, and meet again where their parts reach the same block of code.
#include <cstdio>

#include "lanes.hpp"
#include "options.hpp"

namespace emulate {

namespace {

std::uint32_t guarded(const Warp& w, std::uint32_t guard, bool negated, std::uint32_t mask) {
  if (guard == nowhere) return mask;
  const std::uint32_t p = *reinterpret_cast<const std::uint32_t*>(w.bases[0] + guard);
  return mask & (negated ? ~p : p);
}

/// Runs a warp until it meets a barrier of its block or ends.
class Runner {
 public:
  explicit Runner(Warp& w) : w_(w), g_(*w.group), k_(*g_.kernel) {}
  void run() {
    while (!w_.fragments.empty() && !g_.stopped) {
      int best = -1;
      for (std::size_t f = 0; f < w_.fragments.size(); ++f)
        if (!w_.fragments[f].waiting && (best < 0 || w_.fragments[f].block < w_.fragments[best].block))
          best = static_cast<int>(f);
      if (best < 0) {
        unresolved();
        if (w_.at_barrier) return;
        continue;
      }
      Warp::Fragment now = w_.fragments[best];
      w_.fragments.erase(w_.fragments.begin() + best);
      for (std::size_t f = w_.fragments.size(); f-- > 0;)
        if (w_.fragments[f].block == now.block) {
          now.mask |= w_.fragments[f].mask;
          w_.fragments.erase(w_.fragments.begin() + static_cast<long>(f));
        }
      if (!follow(now)) return;
    }
  }

 private:
  /// False where the warp stops at a barrier.
  bool follow(Warp::Fragment now) {
    int b = now.block;
    std::uint32_t mask = now.mask;
    const Instruction* code = k_.code.data();
    for (;;) {
      const BasicBlock& block = k_.blocks[b];
      if (g_.counting) {
        ++g_.counts->runs[b];
        g_.counts->lanes[b] += static_cast<unsigned>(std::popcount(mask));
      }
      for (const Instruction *i = code + block.begin, *end = code + block.end; i != end; ++i) {
        std::uint32_t m = mask;
        if (i->guard != nowhere) {
          m = guarded(w_, i->guard, i->guard_negated, m);
          if (!m) continue;
        }
        (m == ~0u ? i->full : i->part)(w_, *i, m);
      }
      const End& last = block.last;
      int next = b + 1;
      switch (last.kind) {
        case End::fall:
          break;
        case End::branch: {
          const std::uint32_t taken = guarded(w_, last.guard, last.guard_negated, mask), rest = mask & ~taken;
          if (!rest) {
            next = last.target;
          } else if (taken) {
            w_.fragments.push_back({last.target, taken, false});
            mask = rest;
            if (g_.counting) ++g_.counts->diverged;
            w_.fragments.push_back({next, mask, false});
            return true;
          }
          break;
        }
        case End::exit: {
          const std::uint32_t leaving = guarded(w_, last.guard, last.guard_negated, mask);
          w_.live &= ~leaving;
          mask &= ~leaving;
          if (leaving)
            for (auto& f : w_.fragments) f.waiting = false;
          if (!mask) return true;
          break;
        }
        case End::table: {
          const auto* index = source<std::uint32_t>(w_, last.value);
          for (std::uint32_t m = mask; m;) {
            const std::uint32_t at = index[std::countr_zero(m)];
            std::uint32_t same = 0;
            for (std::uint32_t r = m; r; r &= r - 1)
              if (index[std::countr_zero(r)] == at) same |= 1u << std::countr_zero(r);
            m &= ~same;
            if (at >= last.targets.size()) {
              fault(w_, std::countr_zero(same), last.line, "a jump behind the end of its table");
              w_.live &= ~same;
            } else {
              w_.fragments.push_back({last.targets[at], same, false});
            }
          }
          return true;
        }
        case End::trap:
          fault(w_, std::countr_zero(mask), last.line, "trap");
          g_.stopped = true;
          return false;
        case End::call_host:
          call_host(w_, last, mask);
          if (g_.stopped) return false;
          break;
        case End::warp_sync: {
          const std::uint32_t asking = guarded(w_, last.guard, last.guard_negated, mask);
          if (!asking) break;
          // Lanes may name unlike groups: each waits for its own.
          const auto* members = source<std::uint32_t>(w_, last.members);
          std::uint32_t named = 0, outside = 0;
          for (std::uint32_t m = asking; m; m &= m - 1) {
            const int l = std::countr_zero(m);
            named |= members[l];
            if (!(members[l] >> l & 1)) outside |= 1u << l;
          }
          if (named & w_.live & ~asking) {
            wait(b, mask);
            return true;
          }
          if (g_.check && outside)
            fault(w_, std::countr_zero(outside), last.line,
                  std::string(last.sync.opcode) + " by a lane that its mask of members lacks");
          for (std::uint32_t rest = asking; rest;) {
            std::uint32_t group = 0;
            for (std::uint32_t m = rest; m; m &= m - 1)
              if (members[std::countr_zero(m)] == members[std::countr_zero(rest)]) group |= 1u << std::countr_zero(m);
            warp_sync(w_, last, group);
            rest &= ~group;
          }
          break;
        }
        case End::barrier: {
          const std::uint32_t asking = guarded(w_, last.guard, last.guard_negated, mask);
          if (!asking) break;
          if (last.ordinal == options().drop && k_.shown.find(options().drop_in) != std::string::npos) break;
          if (asking != w_.live) {
            wait(b, mask);
            return true;
          }
          arrive(b, asking);
          return false;
        }
      }
      if (!w_.fragments.empty()) {
        w_.fragments.push_back({next, mask, false});
        return true;
      }
      b = next;
    }
  }
  void wait(int block, std::uint32_t mask) {
    w_.fragments.push_back({block, mask, true});
    if (g_.counting) --g_.counts->runs[block], g_.counts->lanes[block] -= static_cast<unsigned>(std::popcount(mask));
  }
  void arrive(int block, std::uint32_t mask) {
    const End& last = k_.blocks[block].last;
    w_.at_barrier = true;
    w_.barrier_block = block;
    w_.barrier_mask = mask;
    w_.barrier = static_cast<int>(source<std::uint32_t>(w_, last.id)[std::countr_zero(mask)]);
    w_.barrier_threads =
        last.has_threads ? static_cast<int>(source<std::uint32_t>(w_, last.threads)[std::countr_zero(mask)]) : -1;
    w_.fragments.push_back({block + 1, mask, false});
    ++w_.sync;
  }
  /// All parts of the warp wait for each other.
  void unresolved() {
    bool meet = true, barriers = true;
    std::uint32_t all = 0;
    for (const auto& f : w_.fragments) {
      const End& last = k_.blocks[f.block].last;
      meet = meet && last.kind == End::warp_sync && last.sync.op == 20;
      barriers = barriers && last.kind == End::barrier;
      all |= f.mask;
    }
    const auto& first = w_.fragments.front();
    const End& last = k_.blocks[first.block].last;
    const std::string text = barriers ? "DIVERGENT BARRIER: lanes of a warp wait at unlike barriers (mask " +
                                            hex(first.mask) + " of " + hex(w_.live) + ")"
                                      : "DIVERGENT: lanes wait for others that do not come (mask " + hex(first.mask) +
                                            " of " + hex(w_.live) + ")";
    if (!meet) fault(w_, std::countr_zero(first.mask), last.line, text);
    if (barriers) {  // as a device does: all have come
      for (auto& f : w_.fragments) f.block += 1;
      w_.at_barrier = true;
      w_.barrier = 0;
      w_.barrier_threads = -1;
      w_.barrier_mask = all;
      w_.barrier_block = -1;
    } else {
      for (auto& f : w_.fragments) {
        const End& its = k_.blocks[f.block].last;
        if (its.kind == End::warp_sync) {
          if (its.sync.op != 20) warp_sync(w_, its, f.mask);
          f.block += 1;
        } else if (its.kind == End::barrier) {
          continue;
        }
        f.waiting = false;
      }
    }
    for (auto& f : w_.fragments) f.waiting = false;
    if (meet || !barriers) ++w_.sync;
  }
  static std::string hex(std::uint32_t x) {
    char text[16];
    std::snprintf(text, sizeof text, "%08x", x);
    return text;
  }
  Warp& w_;
  Group& g_;
  const Kernel& k_;
};

}  // namespace

void run_warp(Warp& warp) { Runner(warp).run(); }

}  // namespace emulate
