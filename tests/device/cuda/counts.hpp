// What the parts of the CUDA runtime without a device share: the counts, and whether launches are being recorded.
#pragma once

#include <cuda_runtime_api.h>

#include <cstdlib>

/// What the program has asked for; written when it ends.
struct Counts {
  long launches = 0, recorded = 0, graphs = 0, copies = 0, waits = 0, forbidden = 0, impossible = 0;
  ~Counts();
};
inline Counts counts;
inline bool recording = false;
inline cudaError_t last_error = cudaSuccess;
inline constexpr std::size_t memory_of_device = std::size_t(8) << 30;

inline cudaError_t failed(cudaError_t error) {
  last_error = error;
  return error;
}
/// For calls that may not be made while launches are recorded.
inline cudaError_t unless_recording() {
  if (!recording) return cudaSuccess;
  ++counts.forbidden;
  return failed(cudaErrorStreamCaptureUnsupported);
}
inline cudaError_t wait() {
  ++counts.waits;
  return unless_recording();
}
