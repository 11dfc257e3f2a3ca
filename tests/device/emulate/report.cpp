#include "report.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>

#include "memory.hpp"
#include "options.hpp"
#include "work.hpp"

namespace emulate {

namespace {

std::mutex mutex;
std::map<std::string, long>& calls() {
  static auto* all = new std::map<std::string, long>;
  return *all;
}
std::map<const Kernel*, Total>& totals() {
  static auto* all = new std::map<const Kernel*, Total>;
  return *all;
}

void print(const Total& total, std::FILE* out) {
  const Kernel& k = *total.kernel;
  std::uint64_t classes[int(Class::count)] = {}, all = 0, lanes = 0;
  const std::size_t known = std::min(k.blocks.size(), total.counts.runs.size());
  for (std::size_t b = 0; b < known; ++b) {
    for (int c = 0; c < int(Class::count); ++c) classes[c] += total.counts.runs[b] * k.blocks[b].classes[c];
    std::uint64_t length = 0;
    for (const auto c : k.blocks[b].classes) length += c;
    all += total.counts.runs[b] * length;
    lanes += total.counts.lanes[b] * length;
  }
  const Counts& c = total.counts;
  std::fprintf(out, "kernel %s\n", k.shown.c_str());
  std::fprintf(out,
               "  launches %llu  teams %llu  threads %llu  shared_bytes %lld  registers %d  stack %lld  seconds %.3f\n",
               static_cast<unsigned long long>(total.launches), static_cast<unsigned long long>(total.teams),
               static_cast<unsigned long long>(total.threads), static_cast<long long>(total.shared),
               k.needs.known ? k.needs.registers : 0, static_cast<long long>(k.needs.stack), total.seconds);
  std::fprintf(out, "  warp_instructions %llu  lanes %.2f  parted %llu ", static_cast<unsigned long long>(all),
               all ? double(lanes) / double(all) : 0., static_cast<unsigned long long>(c.diverged));
  for (int n = 0; n < int(Class::count); ++n)
    if (classes[n])
      std::fprintf(out, " %s %llu", name_of(static_cast<Class>(n)), static_cast<unsigned long long>(classes[n]));
  std::fprintf(out,
               "\n  global: accesses %llu  sectors_read %llu  sectors_written %llu  bytes_read %llu  bytes_written "
               "%llu  atomics %llu; shared: accesses %llu  cycles %llu  least %llu  atomics %llu; local: %llu\n",
               static_cast<unsigned long long>(c.accesses_global), static_cast<unsigned long long>(c.sectors_read),
               static_cast<unsigned long long>(c.sectors_written), static_cast<unsigned long long>(c.bytes_read),
               static_cast<unsigned long long>(c.bytes_written), static_cast<unsigned long long>(c.atomics_global),
               static_cast<unsigned long long>(c.shared_accesses), static_cast<unsigned long long>(c.shared_cycles),
               static_cast<unsigned long long>(c.shared_least), static_cast<unsigned long long>(c.atomics_shared),
               static_cast<unsigned long long>(c.local_accesses));
  if (options().report < 2) return;
  // Where the instructions come from.
  std::map<std::string, std::uint64_t> places;
  for (std::size_t b = 0; b < known; ++b) {
    if (!total.counts.runs[b]) continue;
    for (std::uint32_t n = k.blocks[b].begin; n < k.blocks[b].end; ++n)
      places[k.module->locate(k.code[n].line)] += total.counts.runs[b];
  }
  std::vector<std::pair<std::uint64_t, std::string>> order;
  for (const auto& [place, number] : places) order.emplace_back(number, place);
  std::sort(order.rbegin(), order.rend());
  for (std::size_t b = 0; b < known; ++b) {
    const End& last = k.blocks[b].last;
    if (last.kind != End::barrier) continue;
    std::fprintf(out, "  barrier %d at line %d of the PTX: %s: passed %llu\n", last.ordinal, last.line,
                 k.module->locate(last.line).c_str(), static_cast<unsigned long long>(total.counts.runs[b]));
  }
  for (std::size_t n = 0; n < order.size() && n < 16; ++n)
    std::fprintf(out, "  at %5.1f %% %s\n", 100. * double(order[n].first) / double(std::max<std::uint64_t>(all, 1)),
                 order[n].second.c_str());
}

}  // namespace

void count(const std::string& what, long number) {
  const std::lock_guard lock(mutex);
  calls()[what] += number;
}

Total& total_of(const Kernel& kernel) {
  const std::lock_guard lock(mutex);
  Total& total = totals()[&kernel];
  total.kernel = &kernel;
  return total;
}

void Total::add(const Launch& launch, double seconds_taken) {
  ++launches;
  const std::uint64_t here = std::uint64_t(launch.grid[0]) * launch.grid[1] * launch.grid[2];
  teams += here;
  threads += here * launch.team[0] * launch.team[1] * launch.team[2];
  shared = std::max(shared, launch.kernel->static_shared + launch.dynamic_shared);
  seconds += seconds_taken;
}

void print_report() {
  static bool done = false;
  if (done) return;
  done = true;
  finish_all();
  if (options().report) {
    const std::string file = Options::text("EMU_REPORT_FILE");
    std::FILE* out = file.empty() ? stderr : std::fopen(file.c_str(), "w");
    if (!out) out = stderr;
    std::vector<const Total*> order;
    for (const auto& [kernel, total] : totals()) order.push_back(&total);
    std::sort(order.begin(), order.end(), [](const Total* a, const Total* b) { return a->seconds > b->seconds; });
    for (const Total* total : order)
      if (total->kernel->shown.find(options().only) != std::string::npos) print(*total, out);
    for (const auto& [what, number] : calls()) std::fprintf(out, "calls: %s %ld\n", what.c_str(), number);
    std::fprintf(out, "memory: %zu bytes at most\n", memory().peak());
    if (out != stderr) std::fclose(out);
  }
  long of_host = 0;
  for (const auto& [what, number] : calls())
    if (what.starts_with("faults") || what.starts_with("forbidden") || what.starts_with("impossible"))
      of_host += number;
  if (faults() == 0 && of_host == 0) return;
  std::fflush(stdout);
  std::fprintf(stderr, "emulate: %llu faults of kernels, %ld of the host\n", static_cast<unsigned long long>(faults()),
               of_host);
  if (Options::number("EMU_EXIT", 1)) {
    std::fflush(nullptr);
    _exit(86);
  }
}

}  // namespace emulate
