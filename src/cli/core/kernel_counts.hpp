// What a stretch of the program asks of the device: kernels, and moments at which the host waits.
#pragma once

namespace softwet {

struct KernelCounts {
  long kernels = 0;      ///< started
  long copies = 0;       ///< to the host or from it
  long waits = 0;        ///< moments at which the host waits until a device has finished, except in a copy
  long allocations = 0;  ///< of arrays
};

/// Counts, by the callbacks of Kokkos for tools, from its construction on until `stop`. A tool that is loaded for the
/// run (KOKKOS_TOOLS_LIBS) gets no calls meanwhile. One at a time.
class KernelCounter {
 public:
  KernelCounter();
  ~KernelCounter() { stop(); }
  KernelCounter(const KernelCounter&) = delete;
  KernelCounter& operator=(const KernelCounter&) = delete;
  KernelCounts stop();

 private:
  bool counting_ = true;
};

}  // namespace softwet
