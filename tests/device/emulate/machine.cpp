// Blocks of threads: warps run until they meet a barrier, one after another, in an order that EMU_SEED chooses.
#include "machine.hpp"

#include <atomic>
#include <cstring>
#include <mutex>
#include <numeric>
#include <thread>

#include "lanes.hpp"
#include "options.hpp"

namespace emulate {

namespace {

struct AlignedBytes {
  std::vector<char> bytes;
  char* get(std::size_t size, std::size_t align = 1024) {
    if (bytes.size() < size + align) bytes.assign(size + align, 0);
    const auto at = reinterpret_cast<std::uint64_t>(bytes.data());
    return bytes.data() + ((at + align - 1) / align * align - at);
  }
};

std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// What a thread of the host needs to run blocks.
class Worker {
 public:
  Worker(const Launch& launch, bool counting) : launch_(launch), k_(*launch.kernel) {
    Group& g = g_;
    g.launch = &launch;
    g.kernel = &k_;
    g.counting = counting;
    g.shared_bytes = k_.static_shared + launch.dynamic_shared;
    g.params = launch.params.data();
    g.counts = &counts;
    g.check = options().check;
    counts.runs.assign(k_.blocks.size(), 0);
    counts.lanes.assign(k_.blocks.size(), 0);
    threads_ = static_cast<int>(launch.team[0] * launch.team[1] * launch.team[2]);
    const int warps = (threads_ + 31) / 32;
    g.shared = stores().shared.get(static_cast<std::size_t>(g.shared_bytes) + 64);
    g.local_all = k_.local_bytes * warps * 32;
    g.local = stores().local.get(static_cast<std::size_t>(g.local_all) + 64);
    if (g.check) {
      g.shadow.swap(stores().shadow);
      g.lane_shadow.swap(stores().lane_shadow);
      g.write_lines.swap(stores().write_lines);
      const auto words = static_cast<std::size_t>(g.shared_bytes / 4 + 4);
      if (g.shadow.size() < words) g.shadow.resize(words), g.lane_shadow.resize(words), g.write_lines.resize(words);
    }
    g.epoch = stores().epoch;
    const std::size_t stride = k_.register_bytes + special_count * 128;
    char* registers = stores().registers.get(stride * warps);
    g.warps.resize(warps);
    for (int n = 0; n < warps; ++n) {
      Warp& w = g.warps[n];
      w.group = &g;
      w.index = n;
      w.bases[0] = registers + stride * n;
      w.bases[1] = const_cast<char*>(reinterpret_cast<const char*>(k_.constants.data()));
      w.bases[2] = w.bases[0] + k_.register_bytes;
      const int here = std::min(32, threads_ - 32 * n);
      w.existing = here == 32 ? ~0u : (1u << here) - 1;
      for (int l = 0; l < 32; ++l) w.local[l] = g.local + (32 * n + l) * k_.local_bytes;
      specials(w);
    }
  }
  ~Worker() {
    if (options().check) {
      g_.shadow.swap(stores().shadow);
      g_.lane_shadow.swap(stores().lane_shadow);
      g_.write_lines.swap(stores().write_lines);
    }
    stores().epoch = g_.epoch + 1;
  }
  void block(std::uint64_t number) {
    Group& g = g_;
    g.number = number;
    g.at[0] = static_cast<std::uint32_t>(number % launch_.grid[0]);
    g.at[1] = static_cast<std::uint32_t>(number / launch_.grid[0] % launch_.grid[1]);
    g.at[2] = static_cast<std::uint32_t>(number / launch_.grid[0] / launch_.grid[1]);
    g.stopped = false;
    if (options().fill >= 0) std::memset(g.shared, options().fill, static_cast<std::size_t>(g.shared_bytes));
    if (g.check && g.epoch > 0xf0000000u) {
      std::fill(g.shadow.begin(), g.shadow.end(), Shadow{});
      g.epoch = 1;
    }
    g.first_epoch = ++g.epoch;
    for (Warp& w : g.warps) {
      for (int d = 0; d < 3; ++d) fill(w, ctaid_x + d, g.at[d]);
      fill(w, smid, static_cast<std::uint32_t>(number % 132));
      w.live = w.existing;
      w.fragments.assign(1, {0, w.existing, false});
      w.at_barrier = false;
      w.sync = 1;
      w.carry = 0;
    }
    run();
  }
  Counts counts;

 private:
  struct Stores {
    AlignedBytes shared, local, registers;
    std::vector<Shadow> shadow;
    std::vector<LaneShadow> lane_shadow;
    std::vector<std::uint32_t> write_lines;
    std::uint32_t epoch = 1;
  };
  static Stores& stores() {
    static thread_local Stores all;
    return all;
  }
  static void fill(Warp& w, std::uint32_t special, std::uint32_t value) {
    auto* at = reinterpret_cast<std::uint32_t*>(w.bases[2] + special * 128);
    for (int l = 0; l < 32; ++l) at[l] = value;
  }
  void specials(Warp& w) {
    std::memset(w.bases[2], 0, special_count * 128);
    const auto lanes = [&](std::uint32_t special) {
      return reinterpret_cast<std::uint32_t*>(w.bases[2] + special * 128);
    };
    for (int l = 0; l < 32; ++l) {
      std::uint32_t at[3];
      thread_of(g_, 32 * w.index + l, at);
      for (int d = 0; d < 3; ++d) lanes(tid_x + d)[l] = at[d];
      lanes(laneid)[l] = static_cast<std::uint32_t>(l);
      lanes(lanemask_eq)[l] = 1u << l;
      lanes(lanemask_lt)[l] = (1u << l) - 1;
      lanes(lanemask_le)[l] = (1u << l) | ((1u << l) - 1);
      lanes(lanemask_ge)[l] = ~((1u << l) - 1);
      lanes(lanemask_gt)[l] = ~((1u << l) | ((1u << l) - 1));
    }
    for (int d = 0; d < 3; ++d) fill(w, ntid_x + d, launch_.team[d]), fill(w, nctaid_x + d, launch_.grid[d]);
    fill(w, warpid, static_cast<std::uint32_t>(w.index));
    fill(w, nwarpid, static_cast<std::uint32_t>(g_.warps.size()));
    fill(w, nsmid, 132);
    fill(w, dynamic_shared, static_cast<std::uint32_t>(launch_.dynamic_shared));
    fill(w, total_shared, static_cast<std::uint32_t>(g_.shared_bytes));
  }
  void run() {
    Group& g = g_;
    const int warps = static_cast<int>(g.warps.size());
    std::vector<int> order(warps);
    std::iota(order.begin(), order.end(), 0);
    std::uint64_t state = options().seed ? mixed(options().seed ^ mixed(launch_.number) ^ mixed(g.number * 77 + 1)) : 0;
    for (;;) {
      if (state)
        for (int n = warps - 1; n > 0; --n) {
          state = mixed(state);
          std::swap(order[n], order[state % static_cast<unsigned>(n + 1)]);
        }
      bool progress = false;
      for (int n : order) {
        Warp& w = g.warps[n];
        if (w.at_barrier || w.fragments.empty()) continue;
        progress = true;
        run_warp(w);
        if (g.stopped) return;
      }
      bool all_done = true;
      for (Warp& w : g.warps) all_done = all_done && w.fragments.empty();
      if (all_done) return;
      if (release()) continue;
      if (!progress) {
        for (Warp& w : g.warps)
          if (w.at_barrier) {
            fault(w, std::countr_zero(w.barrier_mask), line_of(w),
                  "DEADLOCK: waits at a barrier that the block does not complete");
            break;
          }
        return;
      }
    }
  }
  int line_of(const Warp& w) const { return w.barrier_block < 0 ? 0 : k_.blocks[w.barrier_block].last.line; }
  bool release() {
    Group& g = g_;
    bool any = false;
    for (int id = 0; id < 16; ++id) {
      int waiting = 0, expected = -1, ended = 0, running = 0, others = 0;
      Warp* first = nullptr;
      for (Warp& w : g.warps) {
        if (w.at_barrier && w.barrier == id) {
          ++waiting;
          if (!first) first = &w;
          expected = std::max(expected, w.barrier_threads);
        } else if (w.at_barrier) {
          ++others;
        } else if (w.fragments.empty()) {
          ++ended;
        } else {
          ++running;
        }
      }
      if (!waiting) continue;
      const bool whole = expected < 0 || expected >= threads_;
      if (whole ? running + others > 0 : waiting * 32 < expected) continue;
      if (whole && g.check) {
        if (ended)
          fault(*first, std::countr_zero(first->barrier_mask), line_of(*first),
                "DIVERGENT BARRIER: " + std::to_string(ended) + " warps of the block have ended, others wait");
        for (const Warp& w : g.warps)
          if (w.at_barrier && w.barrier_block != first->barrier_block && w.barrier_block >= 0 &&
              first->barrier_block >= 0 && options().check >= 2)
            fault(w, std::countr_zero(w.barrier_mask), line_of(w),
                  "warps of a block meet at unlike barriers (the other at line " + std::to_string(line_of(*first)) +
                      ": " + k_.module->locate(line_of(*first)) + ")");
        for (const Warp& w : g.warps)
          if (w.at_barrier && w.barrier_mask != w.existing)
            fault(w, std::countr_zero(w.barrier_mask), line_of(w),
                  "DIVERGENT BARRIER: lanes of the warp have ended, others wait");
      }
      if (whole)
        ++g.epoch;
      else
        g.check = 0;  // not followed: barriers of some warps
      reduce(id);
      for (Warp& w : g.warps)
        if (w.at_barrier && w.barrier == id) w.at_barrier = false;
      any = true;
    }
    return any;
  }
  void reduce(int id) {
    std::uint32_t total = 0, threads = 0;
    bool wanted = false;
    for (Warp& w : g_.warps) {
      if (!w.at_barrier || w.barrier != id || w.barrier_block < 0) continue;
      const End& last = k_.blocks[w.barrier_block].last;
      if (last.reduction < 0) continue;
      wanted = true;
      const std::uint32_t p = predicate(w, last.value);
      total += static_cast<std::uint32_t>(std::popcount((last.value_negated ? ~p : p) & w.barrier_mask));
      threads += static_cast<std::uint32_t>(std::popcount(w.barrier_mask));
    }
    if (!wanted) return;
    for (Warp& w : g_.warps) {
      if (!w.at_barrier || w.barrier != id || w.barrier_block < 0) continue;
      const End& last = k_.blocks[w.barrier_block].last;
      if (last.reduction < 0 || last.result == nowhere) continue;
      if (last.reduction == 0) {
        auto* d = target<std::uint32_t>(w, last.result);
        for (std::uint32_t m = w.barrier_mask; m; m &= m - 1) d[std::countr_zero(m)] = total;
      } else {
        put_predicate(w, last.result, (last.reduction == 1 ? total == threads : total > 0) ? ~0u : 0u, w.barrier_mask);
      }
    }
  }
  const Launch& launch_;
  const Kernel& k_;
  Group g_;
  int threads_ = 0;
};

}  // namespace

void thread_of(const Group& g, int thread, std::uint32_t* at) {
  at[0] = thread % g.launch->team[0];
  at[1] = thread / g.launch->team[0] % g.launch->team[1];
  at[2] = thread / g.launch->team[0] / g.launch->team[1];
}

void Counts::add(const Counts& other) {
  if (runs.size() < other.runs.size()) runs.resize(other.runs.size()), lanes.resize(other.runs.size());
  for (std::size_t b = 0; b < other.runs.size(); ++b) runs[b] += other.runs[b], lanes[b] += other.lanes[b];
  for (const auto member :
       {&Counts::sectors_read, &Counts::sectors_written, &Counts::bytes_read, &Counts::bytes_written,
        &Counts::accesses_global, &Counts::shared_accesses, &Counts::shared_cycles, &Counts::shared_least,
        &Counts::atomics_global, &Counts::atomics_shared, &Counts::local_accesses, &Counts::diverged})
    this->*member += other.*member;
}

void execute(const Launch& launch, Counts* counts) {
  const std::uint64_t blocks = std::uint64_t(launch.grid[0]) * launch.grid[1] * launch.grid[2];
  std::uint64_t step = 1, first = 0;
  if (options().seed && blocks > 2) {
    first = mixed(options().seed + launch.number) % blocks;
    step = mixed(options().seed * 3 + launch.number) % blocks | 1;
    while (std::gcd(step, blocks) != 1) step += 2;
  }
  std::atomic<std::uint64_t> next{0};
  std::mutex mutex;
  const auto work = [&] {
    Worker worker(launch, counts != nullptr);
    for (std::uint64_t n; (n = next++) < blocks;)
      worker.block(static_cast<std::uint64_t>((static_cast<unsigned __int128>(n) * step + first) % blocks));
    if (counts) {
      const std::lock_guard lock(mutex);
      counts->add(worker.counts);
    }
  };
  const std::uint64_t threads =
      std::min<std::uint64_t>(static_cast<std::uint64_t>(options().threads), (blocks + 1) / 2);
  std::vector<std::thread> others;
  for (std::uint64_t t = 1; t < threads; ++t) others.emplace_back(work);
  work();
  for (auto& other : others) other.join();
}

}  // namespace emulate
