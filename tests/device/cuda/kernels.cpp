// A CUDA runtime without a device: kernels. They do nothing but being counted, so a program that nvcc compiled runs all
// its code of the host. Numbers that it prints mean nothing.
//
// Requests that a device refuses are refused here too: launches that ask for more than a multiprocessor has, and calls
// that are forbidden while launches are recorded. The chip has the limits of an H100. Variables of the environment:
//   SOFTWET_STUB_REPORT   file for the counts, one line "name number" each
//   SOFTWET_STUB_KERNELS  what kernels need, one line "name registers shared_bytes" each; without it each has 32
//     registers
//   SOFTWET_STUB_SHARED   bytes of shared memory of a multiprocessor, for a smaller chip
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <string>

#include "counts.hpp"

Counts::~Counts() {
  const char* file = std::getenv("SOFTWET_STUB_REPORT");
  if (!file) return;
  std::ofstream(file) << "launches " << launches << "\nrecorded " << recorded << "\ngraphs " << graphs << "\ncopies "
                      << copies << "\nwaits " << waits << "\nforbidden " << forbidden << "\nimpossible " << impossible
                      << "\n";
}

namespace {

struct Needs {
  int registers = 32;
  std::size_t shared = 0;
};

constexpr int registers_of_multiprocessor = 65536, threads_of_team = 1024, warp = 32;
constexpr std::size_t shared_of_team = 48 << 10;

std::size_t shared_of_multiprocessor() {
  const char* given = std::getenv("SOFTWET_STUB_SHARED");
  return given ? std::strtoull(given, nullptr, 10) : 228 << 10;
}

/// The needs of kernels by their names in the program.
class Kernels {
 public:
  Kernels() {
    const char* file = std::getenv("SOFTWET_STUB_KERNELS");
    std::ifstream in(file ? file : "");
    std::string name;
    for (Needs needs; in >> name >> needs.registers >> needs.shared;) needs_[name] = needs;
  }
  void add(const void* function, const char* name) { names_[function] = name; }
  Needs needs(const void* function) const {
    const auto found = needs_.find(name(function));
    return found == needs_.end() ? Needs{} : found->second;
  }
  std::string name(const void* function) const {
    const auto found = names_.find(function);
    return found == names_.end() ? "" : found->second;
  }

 private:
  std::map<std::string, Needs> needs_;
  std::map<const void*, std::string> names_;
};
Kernels& kernels() {
  static Kernels all;
  return all;
}

/// Whether one team fits on a multiprocessor. Registers are given to warps, in steps of 8 for each thread.
bool fits(const Needs& needs, dim3 team, std::size_t shared) {
  const std::size_t threads = std::size_t(team.x) * team.y * team.z, warps = (threads + warp - 1) / warp;
  return threads > 0 && threads <= threads_of_team && needs.shared + shared <= shared_of_team &&
         warps * warp * ((needs.registers + 7) / 8 * 8) <= registers_of_multiprocessor;
}

struct Launch {
  dim3 grid, team;
  std::size_t shared;
  cudaStream_t stream;
} next_launch;

}  // namespace

extern "C" {

// --- kernels ---------------------------------------------------------------------------------------------------------
void** __cudaRegisterFatBinary(void*) {
  static void* handle;
  return &handle;
}
void __cudaRegisterFatBinaryEnd(void**) {}
void __cudaUnregisterFatBinary(void**) {}
void __cudaRegisterFunction(void**, const char* host, char*, const char* device, int, void*, void*, void*, void*,
                            int*) {
  kernels().add(host, device);
}
void __cudaRegisterVar(void**, char*, char*, const char*, int, std::size_t, int, int) {}
unsigned __cudaPushCallConfiguration(dim3 grid, dim3 team, std::size_t shared, void* stream) {
  next_launch = {grid, team, shared, static_cast<cudaStream_t>(stream)};
  return 0;
}
cudaError_t __cudaPopCallConfiguration(dim3* grid, dim3* team, std::size_t* shared, void* stream) {
  *grid = next_launch.grid;
  *team = next_launch.team;
  *shared = next_launch.shared;
  *static_cast<cudaStream_t*>(stream) = next_launch.stream;
  return cudaSuccess;
}
cudaError_t __cudaGetKernel(cudaKernel_t* kernel, const void* function) {
  *kernel = reinterpret_cast<cudaKernel_t>(const_cast<void*>(function));
  return cudaSuccess;
}
cudaError_t cudaLaunchKernel(const void* function, dim3 grid, dim3 team, void** arguments, std::size_t shared,
                             cudaStream_t) {
  ++counts.launches;
  counts.recorded += recording;
  if (grid.x == 0 || !fits(kernels().needs(function), team, shared)) {
    ++counts.impossible;
    std::fprintf(stderr, "stub: impossible: %s\n", kernels().name(function).c_str());
    return failed(cudaErrorLaunchOutOfResources);
  }
  // Kokkos asks the device which processor its code was made for.
  if (kernels().name(function).find("query_cuda_kernel_arch") != std::string::npos)
    **static_cast<int**>(arguments[0]) = 900;
  return cudaSuccess;
}
cudaError_t __cudaLaunchKernel(cudaKernel_t kernel, dim3 grid, dim3 team, void** arguments, std::size_t shared,
                               cudaStream_t stream) {
  return cudaLaunchKernel(reinterpret_cast<const void*>(kernel), grid, team, arguments, shared, stream);
}
cudaError_t cudaFuncGetAttributes(cudaFuncAttributes* found, const void* function) {
  const Needs needs = kernels().needs(function);
  *found = {};
  found->maxThreadsPerBlock = threads_of_team;
  found->numRegs = needs.registers;
  found->sharedSizeBytes = needs.shared;
  found->binaryVersion = found->ptxVersion = 90;
  found->maxDynamicSharedSizeBytes = shared_of_team;
  found->preferredShmemCarveout = -1;
  return cudaSuccess;
}
cudaError_t cudaFuncSetAttribute(const void*, cudaFuncAttribute, int) { return cudaSuccess; }
cudaError_t cudaFuncSetCacheConfig(const void*, cudaFuncCache) { return cudaSuccess; }

// --- the device ------------------------------------------------------------------------------------------------------
cudaError_t cudaGetDeviceCount(int* count) {
  *count = 1;
  return cudaSuccess;
}
cudaError_t cudaSetDevice(int) { return cudaSuccess; }
cudaError_t cudaGetDevice(int* device) {
  *device = 0;
  return cudaSuccess;
}
cudaError_t cudaGetDeviceProperties(cudaDeviceProp* chip, int) {
  *chip = {};
  std::strcpy(chip->name, "no device");
  chip->major = 9;
  chip->multiProcessorCount = 132;
  chip->warpSize = warp;
  chip->totalGlobalMem = memory_of_device;
  chip->totalConstMem = 65536;
  chip->sharedMemPerBlock = shared_of_team;
  chip->sharedMemPerMultiprocessor = shared_of_multiprocessor();
  chip->sharedMemPerBlockOptin = 227 << 10;
  chip->reservedSharedMemPerBlock = 1024;
  chip->regsPerBlock = chip->regsPerMultiprocessor = registers_of_multiprocessor;
  chip->maxThreadsPerBlock = threads_of_team;
  chip->maxThreadsPerMultiProcessor = 2048;
  chip->maxBlocksPerMultiProcessor = 32;
  chip->concurrentKernels = chip->unifiedAddressing = chip->managedMemory = chip->concurrentManagedAccess = 1;
  for (int d = 0; d < 3; ++d) {
    chip->maxThreadsDim[d] = d == 2 ? 64 : threads_of_team;
    chip->maxGridSize[d] = d > 0 ? 65535 : 2147483647;
  }
  return cudaSuccess;
}
int cuCtxGetDevice(int* device) { return cudaGetDevice(device); }
int cuCtxPushCurrent_v2(void*) { return 0; }
int cuStreamGetCtx(void*, void** context) {
  *context = nullptr;
  return 0;
}
cudaError_t cudaGetLastError() {
  const cudaError_t error = last_error;
  last_error = cudaSuccess;
  return error;
}
cudaError_t cudaPeekAtLastError() { return last_error; }
const char* cudaGetErrorName(cudaError_t error) {
  return error == cudaErrorStreamCaptureUnsupported ? "cudaErrorStreamCaptureUnsupported" : "cudaError";
}
const char* cudaGetErrorString(cudaError_t error) { return cudaGetErrorName(error); }

}  // extern "C"
