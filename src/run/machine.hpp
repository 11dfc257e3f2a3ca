// The machine a run uses: starting and ending the parallel runtime, and facts for run.json.
#pragma once

#include <Kokkos_Core.hpp>
#include <string>
#include <vector>

namespace softwet {

/// Starts Kokkos with a number of threads (0: `number_of_threads`) and keeps the BLAS on one, so that no sum depends on
/// it. Ends Kokkos with its scope. Throws Error: invalid_input where the option or the environment asks for what cannot
/// be, machine_failed.
class ParallelRuntime {
 public:
  explicit ParallelRuntime(int threads);
  ParallelRuntime(const ParallelRuntime&) = delete;
  ParallelRuntime& operator=(const ParallelRuntime&) = delete;
  ~ParallelRuntime();
};

std::string backend_name();  ///< "OpenMP", "Cuda"
int core_count();            ///< that this process may use; a control group may grant less of their time
int thread_count();          ///< of this process, on the processor
/// Lets the calling thread run on all cores of this process. OpenMP may hold the main thread on one, which those that
/// it starts share.
void run_on_all_cores();
int worker_count();         ///< that rates are given for: threads on a processor, one for a device
const char* worker_name();  ///< "core", "device"
std::string host_name();
std::string instruction_set();                   ///< the widest vector instructions this build uses, "AVX-512"
int lanes();                                     ///< elements per SIMD pack, 1 on a device
double device_bytes_to_be_had();                 ///< what is free on the device; infinity on a processor
double peak_memory_mib();                        ///< largest resident memory of this process so far
std::vector<double> peak_memory_of_processes();  ///< the same of each; all call it together

}  // namespace softwet
