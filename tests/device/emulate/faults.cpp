// Faults of kernels: each is printed once for a place in the code.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>

#include "machine.hpp"
#include "options.hpp"

namespace emulate {

namespace {

std::atomic<std::uint64_t> found_faults{0};

}  // namespace

std::uint64_t faults() { return found_faults; }

void fault(const Warp& w, int lane, int line, const std::string& what) {
  static std::mutex mutex;
  static std::map<std::string, int> said;
  static std::map<std::string, int> of_kernel;
  ++found_faults;
  const std::lock_guard lock(mutex);
  const Group& g = *w.group;
  const std::string key = g.kernel->name + ":" + std::to_string(line) + ":" + what.substr(0, 20);
  if (++said[key] > 1 || ++of_kernel[g.kernel->name] > options().most) return;
  std::uint32_t at[3];
  thread_of(g, 32 * w.index + lane, at);
  std::fprintf(stderr,
               "emulate: FAULT: %s\n  block (%u,%u,%u) of (%u,%u,%u), thread (%u,%u,%u) of (%u,%u,%u), warp %d lane "
               "%d, launch %llu\n  at line %d of the PTX: %s\n  kernel %s\n  mangled %s\n",
               what.c_str(), g.at[0], g.at[1], g.at[2], g.launch->grid[0], g.launch->grid[1], g.launch->grid[2], at[0],
               at[1], at[2], g.launch->team[0], g.launch->team[1], g.launch->team[2], w.index, lane,
               static_cast<unsigned long long>(g.launch->number), line, g.kernel->module->locate(line).c_str(),
               g.kernel->shown.c_str(), g.kernel->name.c_str());
  if (options().stop) {
    std::fflush(nullptr);
    std::_Exit(86);
  }
}

}  // namespace emulate
