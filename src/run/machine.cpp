#include "run/machine.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

#ifdef KOKKOS_ENABLE_OPENMP
#include <omp.h>
#endif

#include "case/error.hpp"
#include "field/ranks.hpp"
#include "kernels/algebra/pack.hpp"
#include "machine/threads.hpp"
#include "memory/array.hpp"
#include "memory/team_scratch.hpp"

namespace softwet {
namespace {

/// Whether there is a device where the build needs one: Kokkos ends the program where there is none.
bool has_device() {
  [[maybe_unused]] int count = 0;
#if defined(KOKKOS_ENABLE_CUDA)
  return cudaGetDeviceCount(&count) == cudaSuccess && count > 0;
#elif defined(KOKKOS_ENABLE_HIP)
  return hipGetDeviceCount(&count) == hipSuccess && count > 0;
#else
  return true;
#endif
}

}  // namespace

ParallelRuntime::ParallelRuntime(int threads) {
  check_environment_of_kokkos();
  if (!has_device())
    throw Error(Exit::machine_failed,
                std::string("the backend ") + Exec::name() +
                    " finds no device; run softwet where there is one, or build it for the processor (preset release)");
  const int count = number_of_threads(threads, core_count());
  Kokkos::InitializationSettings settings;
  settings.set_disable_warnings(true);
  settings.set_num_threads(count);
#ifdef KOKKOS_ENABLE_OPENMP
  static_assert(most_threads == Kokkos::Impl::OpenMPTraits::MAX_THREAD_COUNT);
  omp_set_num_threads(count);  // else Kokkos begins with as many as OpenMP would start on its own
#endif
  try {
    Kokkos::initialize(settings);
  } catch (const std::exception& error) {
    throw Error(Exit::machine_failed, std::string("the backend ") + Exec::name() + " does not start: " + error.what() +
                                          "; 'softwet info' prints what this build needs");
  }
  reserve_team_scratch();
}

ParallelRuntime::~ParallelRuntime() { Kokkos::finalize(); }

std::string backend_name() { return Exec::name(); }

int core_count() {
#ifdef KOKKOS_ENABLE_OPENMP
  return omp_get_num_procs();  // also where OpenMP has already bound this thread to one of them
#else
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
#endif
}

void run_on_all_cores() {
#ifdef KOKKOS_ENABLE_OPENMP
  cpu_set_t cores;
  CPU_ZERO(&cores);
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> of_place(omp_get_place_num_procs(place));
    omp_get_place_proc_ids(place, of_place.data());
    for (int core : of_place)
      if (core < CPU_SETSIZE) CPU_SET(core, &cores);
  }
  if (CPU_COUNT(&cores) > 0) sched_setaffinity(0, sizeof cores, &cores);  // else the thread stays where it is
#endif
}

int thread_count() { return Kokkos::DefaultHostExecutionSpace().concurrency(); }

int worker_count() { return on_host ? thread_count() : 1; }
const char* worker_name() { return on_host ? "core" : "device"; }

double device_bytes_to_be_had() {
#if defined(KOKKOS_ENABLE_CUDA)
  std::size_t left = 0, all = 0;
  if (cudaMemGetInfo(&left, &all) == cudaSuccess) return static_cast<double>(left);
#elif defined(KOKKOS_ENABLE_HIP)
  std::size_t left = 0, all = 0;
  if (hipMemGetInfo(&left, &all) == hipSuccess) return static_cast<double>(left);
#endif
  return std::numeric_limits<double>::infinity();
}

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

std::string instruction_set() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__AVX__)
  return "AVX";
#elif defined(__ARM_FEATURE_SVE)
  return "SVE";
#elif defined(__ARM_NEON)
  return "NEON";
#elif defined(__SSE2__)
  return "SSE2";
#else
  return "generic";
#endif
}

int lanes() { return on_host ? Lanes<Pack<double>>::count : 1; }

double peak_memory_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) != 0) continue;
    double kib = 0;
    std::istringstream(line.substr(6)) >> kib;
    return kib / 1024;
  }
  return 0;
}

std::vector<double> peak_memory_of_processes() {
  std::vector<double> memory(ranks::count(), 0.0);
  memory[ranks::mine()] = peak_memory_mib();
  ranks::add(memory.data(), ranks::count());
  return memory;
}

}  // namespace softwet
