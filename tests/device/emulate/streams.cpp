// The runtime's calls for memory, streams, events and graphs.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <set>

#include "fatbinary.hpp"
#include "memory.hpp"
#include "options.hpp"
#include "work.hpp"

namespace emulate {

namespace {

std::recursive_mutex everything;
cudaError_t last_error = cudaSuccess;
Stream default_stream;
std::set<Stream*>& streams() {
  static auto* all = new std::set<Stream*>{&default_stream};
  return *all;
}
Stream& stream_of(cudaStream_t stream) {
  if (!stream || stream == cudaStreamLegacy || stream == cudaStreamPerThread) return default_stream;
  return *reinterpret_cast<Stream*>(stream);
}
int recorders = 0;
std::vector<Task>& waiting() {
  static auto* all = new std::vector<Task>;
  return *all;
}
bool late() {
  static const bool wanted = Options::number("EMU_LATE", 0) != 0;
  return wanted;
}

struct Event {};

bool good_copy(const void* place, std::size_t bytes, const char* call) {
  const auto address = reinterpret_cast<std::uint64_t>(place);
  if (bytes == 0 || !memory().inside(address) || memory().live_range(address, bytes)) return true;
  std::fprintf(stderr, "emulate: FAULT of the host: %s of %zu bytes: %s\n", call, bytes,
               memory().describe(address).c_str());
  count("faults of the host");
  return false;
}

}  // namespace

void give(cudaStream_t stream, Task task) {
  const std::lock_guard lock(everything);
  Stream& s = stream_of(stream);
  if (s.recording) {
    s.recording->tasks.push_back(std::make_shared<const Task>(std::move(task)));
    return;
  }
  if (late())
    waiting().push_back(std::move(task));
  else
    task();
}
void finish_all() {
  const std::lock_guard lock(everything);
  const auto all = std::move(waiting());
  waiting().clear();
  for (const auto& task : all) task();
}
bool recording() { return recorders > 0; }
cudaError_t failed(cudaError_t error) {
  last_error = error;
  return error;
}
cudaError_t unless_recording(const char* call) {
  if (!recording()) return cudaSuccess;
  count(std::string("forbidden while recording: ") + call);
  std::fprintf(stderr, "emulate: FAULT of the host: %s while launches are recorded\n", call);
  return failed(cudaErrorStreamCaptureUnsupported);
}

namespace {

cudaError_t copy(void* to, const void* from, std::size_t bytes, cudaStream_t stream, const char* call) {
  count("copies");
  if (!good_copy(to, bytes, call) || !good_copy(from, bytes, call)) return failed(cudaErrorInvalidValue);
  // Pageable memory of the host is read before such a call returns, and written too.
  const auto pageable = [](const void* place) {
    const auto address = reinterpret_cast<std::uint64_t>(place);
    return !memory().inside(address) && !memory().pinned(address, 1);
  };
  const bool now = !stream_of(stream).recording;
  if (now && late() && pageable(from)) {
    const auto* bytes_of = static_cast<const char*>(from);
    give(stream, [=, copied = std::vector<char>(bytes_of, bytes_of + bytes)] {
      std::memcpy(memory().host(to), copied.data(), bytes);
    });
  } else {
    give(stream, [=] { std::memmove(memory().host(to), memory().host(from), bytes); });
  }
  if (now && pageable(to)) finish_all();
  return cudaSuccess;
}
cudaError_t wait(const char* call) {
  const cudaError_t error = unless_recording(call);
  if (error) return error;
  count("waits");
  finish_all();
  return cudaSuccess;
}
cudaError_t host_memory(void** place, std::size_t bytes, const char* call) {
  const cudaError_t error = unless_recording(call);
  if (error) return error;
  *place = std::aligned_alloc(256, (bytes + 511) / 256 * 256);
  if (options().fill >= 0) std::memset(*place, options().fill, bytes);
  memory().add_pinned(*place, bytes);
  return cudaSuccess;
}

}  // namespace

}  // namespace emulate

using namespace emulate;

extern "C" {

// --- memory ------------------------------------------------------------------------------------------------------------
cudaError_t cudaMalloc(void** place, std::size_t bytes) {
  const cudaError_t error = unless_recording("cudaMalloc");
  if (error) return error;
  static long number = 0;
  const std::uint64_t address = memory().allocate(bytes, "allocation " + std::to_string(++number));
  if (!address) return failed(cudaErrorMemoryAllocation);
  *place = reinterpret_cast<void*>(address);
  return cudaSuccess;
}
cudaError_t cudaFree(void* place) {
  const cudaError_t error = unless_recording("cudaFree");
  if (error || !place) return error;
  finish_all();
  if (memory().inside(reinterpret_cast<std::uint64_t>(place))) {
    if (memory().release(reinterpret_cast<std::uint64_t>(place))) return cudaSuccess;
  } else if (memory().remove_pinned(place)) {
    std::free(place);
    return cudaSuccess;
  }
  std::fprintf(stderr, "emulate: FAULT of the host: cudaFree of %s\n",
               memory().describe(reinterpret_cast<std::uint64_t>(place)).c_str());
  count("faults of the host");
  return failed(cudaErrorInvalidValue);
}
cudaError_t cudaMallocAsync(void** place, std::size_t bytes, cudaStream_t) { return cudaMalloc(place, bytes); }
cudaError_t cudaFreeAsync(void* place, cudaStream_t) { return cudaFree(place); }
cudaError_t cudaMallocManaged(void** place, std::size_t bytes, unsigned) {
  return host_memory(place, bytes, "cudaMallocManaged");
}
cudaError_t cudaMallocHost(void** place, std::size_t bytes) { return host_memory(place, bytes, "cudaMallocHost"); }
cudaError_t cudaHostAlloc(void** place, std::size_t bytes, unsigned) {
  return host_memory(place, bytes, "cudaHostAlloc");
}
cudaError_t cudaFreeHost(void* place) { return cudaFree(place); }
cudaError_t cudaMemGetInfo(std::size_t* free, std::size_t* total) {
  *total = options().memory;
  *free = options().memory - memory().in_use();
  return cudaSuccess;
}
cudaError_t cudaMemcpy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind) {
  const cudaError_t error = wait("cudaMemcpy");
  if (error) return error;
  const cudaError_t copied = copy(to, from, bytes, nullptr, "cudaMemcpy");
  finish_all();
  return copied;
}
cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind, cudaStream_t stream) {
  return copy(to, from, bytes, stream, "cudaMemcpyAsync");
}
cudaError_t cudaMemset(void* place, int value, std::size_t bytes) {
  if (!good_copy(place, bytes, "cudaMemset")) return failed(cudaErrorInvalidValue);
  give(nullptr, [=] { std::memset(memory().host(place), value, bytes); });
  return cudaSuccess;
}
cudaError_t cudaMemsetAsync(void* place, int value, std::size_t bytes, cudaStream_t stream) {
  if (!good_copy(place, bytes, "cudaMemsetAsync")) return failed(cudaErrorInvalidValue);
  give(stream, [=] { std::memset(memory().host(place), value, bytes); });
  return cudaSuccess;
}
cudaError_t cudaMemPrefetchAsync(const void*, std::size_t, cudaMemLocation, unsigned, cudaStream_t) {
  return cudaSuccess;
}
cudaError_t cudaMemAdvise(const void*, std::size_t, cudaMemoryAdvise, cudaMemLocation) { return cudaSuccess; }
cudaError_t cudaPointerGetAttributes(cudaPointerAttributes* found, const void* place) {
  *found = {};
  const auto address = reinterpret_cast<std::uint64_t>(place);
  found->type = memory().inside(address)      ? cudaMemoryTypeDevice
                : memory().pinned(address, 1) ? cudaMemoryTypeHost
                                              : cudaMemoryTypeUnregistered;
  if (found->type != cudaMemoryTypeUnregistered) found->devicePointer = const_cast<void*>(place);
  if (found->type != cudaMemoryTypeDevice) found->hostPointer = const_cast<void*>(place);
  return cudaSuccess;
}

// --- streams and events ------------------------------------------------------------------------------------------------
cudaError_t cudaDeviceSynchronize() { return wait("cudaDeviceSynchronize"); }
cudaError_t cudaStreamSynchronize(cudaStream_t) {
  const cudaError_t error = unless_recording("cudaStreamSynchronize");
  if (error) return error;
  count("waits");
  finish_all();
  return cudaSuccess;
}
cudaError_t cudaStreamCreate(cudaStream_t* stream) {
  auto* made = new Stream;
  streams().insert(made);
  *stream = reinterpret_cast<cudaStream_t>(made);
  return cudaSuccess;
}
cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned) { return cudaStreamCreate(stream); }
cudaError_t cudaStreamDestroy(cudaStream_t stream) {
  finish_all();
  streams().erase(&stream_of(stream));
  if (&stream_of(stream) != &default_stream) delete &stream_of(stream);
  return cudaSuccess;
}
cudaError_t cudaStreamWaitEvent(cudaStream_t, cudaEvent_t, unsigned) { return cudaSuccess; }
cudaError_t cudaEventCreate(cudaEvent_t* event) {
  *event = reinterpret_cast<cudaEvent_t>(new Event);
  return cudaSuccess;
}
cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned) { return cudaEventCreate(event); }
cudaError_t cudaEventRecord(cudaEvent_t, cudaStream_t) { return cudaSuccess; }
cudaError_t cudaEventSynchronize(cudaEvent_t) {
  const cudaError_t error = unless_recording("cudaEventSynchronize");
  if (error) return error;
  count("waits");
  finish_all();
  return cudaSuccess;
}
cudaError_t cudaEventQuery(cudaEvent_t event) { return cudaEventSynchronize(event); }
cudaError_t cudaEventElapsedTime(float* time, cudaEvent_t, cudaEvent_t) {
  *time = 0;
  return cudaSuccess;
}
cudaError_t cudaEventDestroy(cudaEvent_t event) {
  delete reinterpret_cast<Event*>(event);
  return cudaSuccess;
}

// --- graphs ------------------------------------------------------------------------------------------------------------
cudaError_t cudaStreamBeginCapture(cudaStream_t stream, cudaStreamCaptureMode) {
  Stream& s = stream_of(stream);
  if (s.recording) return failed(cudaErrorStreamCaptureUnsupported);
  s.recording = new Graph;
  ++recorders;
  return cudaSuccess;
}
cudaError_t cudaStreamEndCapture(cudaStream_t stream, cudaGraph_t* graph) {
  Stream& s = stream_of(stream);
  if (!s.recording) return failed(cudaErrorIllegalState);
  *graph = reinterpret_cast<cudaGraph_t>(s.recording);
  s.recording = nullptr;
  --recorders;
  return cudaSuccess;
}
cudaError_t cudaStreamIsCapturing(cudaStream_t stream, cudaStreamCaptureStatus* status) {
  *status = stream_of(stream).recording ? cudaStreamCaptureStatusActive : cudaStreamCaptureStatusNone;
  return cudaSuccess;
}
cudaError_t cudaGraphCreate(cudaGraph_t* graph, unsigned) {
  *graph = reinterpret_cast<cudaGraph_t>(new Graph);
  return cudaSuccess;
}
cudaError_t cudaGraphDestroy(cudaGraph_t graph) {
  delete reinterpret_cast<Graph*>(graph);
  return cudaSuccess;
}
cudaError_t cudaGraphInstantiate(cudaGraphExec_t* made, cudaGraph_t graph, unsigned long long) {
  *made = reinterpret_cast<cudaGraphExec_t>(new Graph(*reinterpret_cast<Graph*>(graph)));
  return cudaSuccess;
}
cudaError_t cudaGraphExecDestroy(cudaGraphExec_t graph) {
  finish_all();
  delete reinterpret_cast<Graph*>(graph);
  return cudaSuccess;
}
cudaError_t cudaGraphLaunch(cudaGraphExec_t graph, cudaStream_t stream) {
  count("graphs");
  for (const auto& task : reinterpret_cast<Graph*>(graph)->tasks) give(stream, [task] { (*task)(); });
  return cudaSuccess;
}
cudaError_t cudaGraphUpload(cudaGraphExec_t, cudaStream_t) { return cudaSuccess; }
// Nodes are done in the order in which they were added.
cudaError_t cudaGraphAddEmptyNode(cudaGraphNode_t* node, cudaGraph_t, const cudaGraphNode_t*, std::size_t) {
  *node = reinterpret_cast<cudaGraphNode_t>(1);
  return cudaSuccess;
}
cudaError_t cudaGraphAddChildGraphNode(cudaGraphNode_t* node, cudaGraph_t graph, const cudaGraphNode_t*, std::size_t,
                                       cudaGraph_t child) {
  *node = reinterpret_cast<cudaGraphNode_t>(1);
  auto& tasks = reinterpret_cast<Graph*>(graph)->tasks;
  const auto& more = reinterpret_cast<Graph*>(child)->tasks;
  tasks.insert(tasks.end(), more.begin(), more.end());
  return cudaSuccess;
}
cudaError_t cudaGraphAddDependencies(cudaGraph_t, const cudaGraphNode_t*, const cudaGraphNode_t*,
                                     const cudaGraphEdgeData*, std::size_t) {
  return cudaSuccess;
}

cudaError_t cudaGetLastError() {
  const cudaError_t error = last_error;
  last_error = cudaSuccess;
  return error;
}
cudaError_t cudaPeekAtLastError() { return last_error; }

}  // extern "C"
