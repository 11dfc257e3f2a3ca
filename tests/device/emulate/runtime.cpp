// The runtime's calls for kernels, their variables and the device; and what is printed at the end.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <map>
#include <mutex>

#include "fatbinary.hpp"
#include "memory.hpp"
#include "options.hpp"
#include "report.hpp"
#include "work.hpp"

namespace emulate {

namespace {

struct Known {
  Fatbinary* binary = nullptr;
  std::string name;
  int dynamic_shared = 48 << 10;  // as cudaFuncSetAttribute has allowed
};
std::map<const void*, Known>& functions() {
  static auto* all = new std::map<const void*, Known>;
  return *all;
}
std::map<const void*, Known>& variables() {
  static auto* all = new std::map<const void*, Known>;
  return *all;
}

struct Configuration {
  dim3 grid, team;
  std::size_t shared;
  cudaStream_t stream;
};
thread_local Configuration next_launch;

[[noreturn]] void stop(const std::exception& problem) {
  std::fflush(stdout);
  std::fprintf(stderr, "emulate: cannot go on: %s\n", problem.what());
  std::fflush(stderr);
  std::_Exit(87);
}

constexpr int registers_of_multiprocessor = 65536, threads_of_team = 1024;

void run(const Launch& launch) {
  const auto start = std::chrono::steady_clock::now();
  Total* total = options().report ? &total_of(*launch.kernel) : nullptr;
  if (options().trace)
    std::fprintf(stderr, "emulate: launch %llu: %u x %u x %u teams of %u x %u x %u, %lld + %lld bytes: %.200s\n",
                 static_cast<unsigned long long>(launch.number), launch.grid[0], launch.grid[1], launch.grid[2],
                 launch.team[0], launch.team[1], launch.team[2], static_cast<long long>(launch.kernel->static_shared),
                 static_cast<long long>(launch.dynamic_shared), launch.kernel->shown.c_str());
  // Kokkos asks the device which processor its code was made for.
  const bool asked = launch.kernel->name.find("query_cuda_kernel_arch") != std::string::npos;
  try {
    if (options().execute || asked) execute(launch, total ? &total->counts : nullptr);
  } catch (const std::exception& problem) {
    stop(problem);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (total) total->add(launch, seconds);
}

/// Needs of all kernels of the program, whether they were launched or not.
void print_needs() {
  const std::string file = Options::text("EMU_NEEDS_FILE");
  std::FILE* out = file.empty() ? nullptr : std::fopen(file.c_str(), "w");
  if (!out) return;
  for (const auto& [function, known] : functions()) {
    const Needs needs = known.binary->needs(known.name);
    std::fprintf(out, "%d %lld %s\n", needs.known ? needs.registers : 0, static_cast<long long>(needs.stack),
                 demangled(known.name).c_str());
  }
  std::fclose(out);
}

}  // namespace

}  // namespace emulate

using namespace emulate;

extern "C" {

// --- kernels -----------------------------------------------------------------------------------------------------------
void** __cudaRegisterFatBinary(void* wrapper) {
  try {
    return reinterpret_cast<void**>(new Fatbinary(wrapper));
  } catch (const std::exception& problem) {
    stop(problem);
  }
}
void __cudaRegisterFatBinaryEnd(void**) {}
void __cudaUnregisterFatBinary(void**) {
  static bool done = false;
  if (!done) print_needs();
  done = true;
  print_report();
}
void __cudaRegisterFunction(void** binary, const char* host, char*, const char* device, int, void*, void*, void*, void*,
                            int*) {
  functions()[host] = {reinterpret_cast<Fatbinary*>(binary), device};
}
void __cudaRegisterVar(void** binary, char* host, char*, const char* device, int, std::size_t, int, int) {
  variables()[host] = {reinterpret_cast<Fatbinary*>(binary), device};
}
char __cudaInitModule(void**) { return 1; }
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
                             cudaStream_t stream) {
  const auto found = functions().find(function);
  if (found == functions().end()) return failed(cudaErrorInvalidDeviceFunction);
  const Known& known = found->second;
  try {
    const Kernel& kernel = known.binary->kernel(known.name);
    const Needs& needs = kernel.needs;
    const std::size_t threads = std::size_t(team.x) * team.y * team.z, warps = (threads + 31) / 32;
    const std::size_t static_shared = static_cast<std::size_t>(std::max(needs.shared, kernel.static_shared));
    const bool fits = threads > 0 && threads <= threads_of_team && grid.x > 0 && grid.y > 0 && grid.z > 0 &&
                      grid.y < 65536 && grid.z < 65536 && team.z <= 64 &&
                      (!kernel.max_threads || static_cast<int>(threads) <= kernel.max_threads) &&
                      static_shared + shared <= static_cast<std::size_t>(std::max(48 << 10, known.dynamic_shared)) &&
                      warps * 32 * ((needs.registers + 7) / 8 * 8) <= registers_of_multiprocessor;
    if (!fits) {
      count("impossible launches");
      std::fprintf(stderr,
                   "emulate: FAULT of the host: a launch of %u x %u x %u teams of %zu threads (%d at most) with %zu + "
                   "%zu bytes of shared memory and %d registers: %s\n",
                   grid.x, grid.y, grid.z, threads, kernel.max_threads, static_shared, shared, needs.registers,
                   kernel.shown.c_str());
      return failed(cudaErrorLaunchOutOfResources);
    }
    count("launches");
    if (recording()) count("launches recorded");
    auto launch = std::make_shared<Launch>();
    static std::atomic<std::uint64_t> number{0};
    launch->kernel = &kernel;
    launch->grid[0] = grid.x, launch->grid[1] = grid.y, launch->grid[2] = grid.z;
    launch->team[0] = team.x, launch->team[1] = team.y, launch->team[2] = team.z;
    launch->dynamic_shared = static_cast<std::int64_t>(shared);
    launch->number = ++number;
    launch->params.resize(static_cast<std::size_t>(kernel.param_bytes) + 64);
    for (std::size_t k = 0; k < kernel.params.size(); ++k)
      std::memcpy(launch->params.data() + kernel.params[k].first, arguments[k],
                  static_cast<std::size_t>(kernel.params[k].second));
    give(stream, [launch] { run(*launch); });
  } catch (const std::exception& problem) {
    stop(problem);
  }
  return cudaSuccess;
}
cudaError_t __cudaLaunchKernel(cudaKernel_t kernel, dim3 grid, dim3 team, void** arguments, std::size_t shared,
                               cudaStream_t stream) {
  return cudaLaunchKernel(reinterpret_cast<const void*>(kernel), grid, team, arguments, shared, stream);
}
cudaError_t cudaFuncGetAttributes(cudaFuncAttributes* found, const void* function) {
  *found = {};
  const auto known = functions().find(function);
  if (known == functions().end()) return failed(cudaErrorInvalidDeviceFunction);
  try {
    const Kernel& kernel = known->second.binary->kernel(known->second.name);
    const Needs& needs = kernel.needs;
    const int by_registers = registers_of_multiprocessor / ((needs.registers + 7) / 8 * 8) / 32 * 32;
    found->maxThreadsPerBlock =
        std::min({threads_of_team, by_registers, kernel.max_threads ? kernel.max_threads : threads_of_team});
    found->numRegs = needs.registers;
    found->sharedSizeBytes = static_cast<std::size_t>(std::max(needs.shared, kernel.static_shared));
    found->localSizeBytes = static_cast<std::size_t>(needs.stack);
    found->binaryVersion = found->ptxVersion = 90;
    found->maxDynamicSharedSizeBytes =
        std::max(48 << 10, known->second.dynamic_shared) - static_cast<int>(found->sharedSizeBytes);
    found->preferredShmemCarveout = -1;
  } catch (const std::exception& problem) {
    stop(problem);
  }
  return cudaSuccess;
}
cudaError_t cudaFuncSetAttribute(const void* function, cudaFuncAttribute attribute, int value) {
  if (attribute == cudaFuncAttributeMaxDynamicSharedMemorySize) functions()[function].dynamic_shared = value;
  return cudaSuccess;
}
cudaError_t cudaFuncSetCacheConfig(const void*, cudaFuncCache) { return cudaSuccess; }
cudaError_t cudaDeviceSetLimit(cudaLimit, std::size_t) { return cudaSuccess; }

static cudaError_t copy_to_variable(const void* variable, const void* from, std::size_t bytes, std::size_t offset,
                                    cudaStream_t stream) {
  const auto known = variables().find(variable);
  if (known == variables().end()) return failed(cudaErrorInvalidSymbol);
  try {
    const std::uint64_t address = known->second.binary->variable(known->second.name);
    // A variable that no kernel of this module reads is not in its PTX.
    if (!address) return cudaSuccess;
    return cudaMemcpyAsync(reinterpret_cast<void*>(address + offset), from, bytes, cudaMemcpyDefault, stream);
  } catch (const std::exception& problem) {
    stop(problem);
  }
}
cudaError_t cudaMemcpyToSymbol(const void* variable, const void* from, std::size_t bytes, std::size_t offset,
                               cudaMemcpyKind) {
  if (const cudaError_t error = unless_recording("cudaMemcpyToSymbol")) return error;
  finish_all();
  const cudaError_t error = copy_to_variable(variable, from, bytes, offset, nullptr);
  finish_all();
  return error;
}
cudaError_t cudaMemcpyToSymbolAsync(const void* variable, const void* from, std::size_t bytes, std::size_t offset,
                                    cudaMemcpyKind, cudaStream_t stream) {
  return copy_to_variable(variable, from, bytes, offset, stream);
}
cudaError_t cudaMemcpyFromSymbol(void* to, const void* variable, std::size_t bytes, std::size_t offset,
                                 cudaMemcpyKind) {
  const auto known = variables().find(variable);
  if (known == variables().end()) return failed(cudaErrorInvalidSymbol);
  finish_all();
  const std::uint64_t address = known->second.binary->variable(known->second.name);
  if (!address) return failed(cudaErrorInvalidSymbol);
  return cudaMemcpy(to, reinterpret_cast<const void*>(address + offset), bytes, cudaMemcpyDefault);
}
cudaError_t cudaGetSymbolAddress(void** place, const void* variable) {
  const auto known = variables().find(variable);
  if (known == variables().end()) return failed(cudaErrorInvalidSymbol);
  *place = reinterpret_cast<void*>(known->second.binary->variable(known->second.name));
  return *place ? cudaSuccess : failed(cudaErrorInvalidSymbol);
}

// --- the device --------------------------------------------------------------------------------------------------------
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
  std::strcpy(chip->name, "emulated H100");
  chip->major = 9;
  chip->multiProcessorCount = 132;
  chip->warpSize = 32;
  chip->totalGlobalMem = options().memory;
  chip->totalConstMem = 65536;
  chip->sharedMemPerBlock = 48 << 10;
  chip->sharedMemPerMultiprocessor = static_cast<std::size_t>(options().shared);
  chip->sharedMemPerBlockOptin = chip->sharedMemPerMultiprocessor - 1024;
  chip->reservedSharedMemPerBlock = 1024;
  chip->regsPerBlock = chip->regsPerMultiprocessor = registers_of_multiprocessor;
  chip->maxThreadsPerBlock = threads_of_team;
  chip->maxThreadsPerMultiProcessor = 2048;
  chip->maxBlocksPerMultiProcessor = 32;
  chip->l2CacheSize = 50 << 20;
  chip->memoryBusWidth = 5120;
  chip->concurrentKernels = chip->unifiedAddressing = chip->managedMemory = chip->concurrentManagedAccess =
      chip->canMapHostMemory = chip->cooperativeLaunch = 1;
  for (int d = 0; d < 3; ++d) {
    chip->maxThreadsDim[d] = d == 2 ? 64 : threads_of_team;
    chip->maxGridSize[d] = d > 0 ? 65535 : 2147483647;
  }
  return cudaSuccess;
}
cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr, int) {
  *value = 0;
  return cudaSuccess;
}
cudaError_t cudaDriverGetVersion(int* version) {
  *version = CUDART_VERSION;
  return cudaSuccess;
}
cudaError_t cudaRuntimeGetVersion(int* version) {
  *version = CUDART_VERSION;
  return cudaSuccess;
}
int cuCtxGetDevice(int* device) { return cudaGetDevice(device); }
int cuCtxPushCurrent_v2(void*) { return 0; }
int cuStreamGetCtx(void*, void** context) {
  *context = nullptr;
  return 0;
}
const char* cudaGetErrorName(cudaError_t error) {
  switch (error) {
    case cudaErrorStreamCaptureUnsupported:
      return "cudaErrorStreamCaptureUnsupported";
    case cudaErrorLaunchOutOfResources:
      return "cudaErrorLaunchOutOfResources";
    case cudaErrorInvalidValue:
      return "cudaErrorInvalidValue";
    case cudaErrorMemoryAllocation:
      return "cudaErrorMemoryAllocation";
    case cudaErrorInvalidDeviceFunction:
      return "cudaErrorInvalidDeviceFunction";
    default:
      return "cudaError";
  }
}
const char* cudaGetErrorString(cudaError_t error) { return cudaGetErrorName(error); }

}  // extern "C"
