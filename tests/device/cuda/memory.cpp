// A CUDA runtime without a device: memory of the device is memory of the host, copies copy, and streams, events and
// graphs are handles.
#include <cstring>

#include "counts.hpp"

namespace {

/// An object of the runtime that the program only passes on.
template <class Handle>
cudaError_t make(Handle* handle) {
  *handle = reinterpret_cast<Handle>(std::malloc(8));
  return cudaSuccess;
}
template <class Handle>
cudaError_t end(Handle handle) {
  std::free(reinterpret_cast<void*>(handle));
  return cudaSuccess;
}
cudaError_t allocate(void** place, std::size_t bytes) {
  *place = std::calloc(bytes > 0 ? bytes : 1, 1);
  return *place ? cudaSuccess : failed(cudaErrorMemoryAllocation);
}
cudaError_t copy(void* to, const void* from, std::size_t bytes) {
  ++counts.copies;
  if (!recording) std::memmove(to, from, bytes);
  return cudaSuccess;
}

}  // namespace

extern "C" {

// --- memory ----------------------------------------------------------------------------------------------------------
cudaError_t cudaMalloc(void** place, std::size_t bytes) {
  const cudaError_t error = unless_recording();
  return error ? error : allocate(place, bytes);
}
cudaError_t cudaFree(void* place) {
  const cudaError_t error = unless_recording();
  return error ? error : end(place);
}
cudaError_t cudaMallocManaged(void** place, std::size_t bytes, unsigned) { return cudaMalloc(place, bytes); }
cudaError_t cudaMallocHost(void** place, std::size_t bytes) { return cudaMalloc(place, bytes); }
cudaError_t cudaHostAlloc(void** place, std::size_t bytes, unsigned) { return cudaMalloc(place, bytes); }
cudaError_t cudaFreeHost(void* place) { return cudaFree(place); }
cudaError_t cudaMemGetInfo(std::size_t* free, std::size_t* total) {
  *free = *total = memory_of_device;
  return cudaSuccess;
}
cudaError_t cudaMemcpy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind) {
  const cudaError_t error = wait();
  return error ? error : copy(to, from, bytes);
}
cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind, cudaStream_t) {
  return copy(to, from, bytes);
}
cudaError_t cudaMemcpyToSymbol(const void*, const void*, std::size_t, std::size_t, cudaMemcpyKind) { return wait(); }
cudaError_t cudaMemcpyToSymbolAsync(const void*, const void*, std::size_t, std::size_t, cudaMemcpyKind, cudaStream_t) {
  return cudaSuccess;
}
cudaError_t cudaMemset(void* place, int value, std::size_t bytes) {
  if (!recording) std::memset(place, value, bytes);
  return cudaSuccess;
}
cudaError_t cudaMemsetAsync(void* place, int value, std::size_t bytes, cudaStream_t) {
  return cudaMemset(place, value, bytes);
}
cudaError_t cudaMemPrefetchAsync(const void*, std::size_t, cudaMemLocation, unsigned, cudaStream_t) {
  return cudaSuccess;
}
cudaError_t cudaPointerGetAttributes(cudaPointerAttributes* found, const void* place) {
  *found = {};
  found->type = cudaMemoryTypeDevice;
  found->devicePointer = const_cast<void*>(place);
  return cudaSuccess;
}

// --- streams, events, graphs -----------------------------------------------------------------------------------------
cudaError_t cudaDeviceSynchronize() { return wait(); }
cudaError_t cudaStreamSynchronize(cudaStream_t) { return wait(); }
cudaError_t cudaStreamCreate(cudaStream_t* stream) { return make(stream); }
cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned) { return make(stream); }
cudaError_t cudaStreamDestroy(cudaStream_t stream) { return end(stream); }
cudaError_t cudaEventCreate(cudaEvent_t* event) { return make(event); }
cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned) { return make(event); }
cudaError_t cudaEventRecord(cudaEvent_t, cudaStream_t) { return cudaSuccess; }
cudaError_t cudaEventSynchronize(cudaEvent_t) { return wait(); }
cudaError_t cudaEventDestroy(cudaEvent_t event) { return end(event); }
cudaError_t cudaStreamBeginCapture(cudaStream_t, cudaStreamCaptureMode) {
  recording = true;
  return cudaSuccess;
}
cudaError_t cudaStreamEndCapture(cudaStream_t, cudaGraph_t* graph) {
  recording = false;
  return make(graph);
}
cudaError_t cudaGraphCreate(cudaGraph_t* graph, unsigned) { return make(graph); }
cudaError_t cudaGraphDestroy(cudaGraph_t graph) { return end(graph); }
cudaError_t cudaGraphInstantiate(cudaGraphExec_t* graph, cudaGraph_t, unsigned long long) { return make(graph); }
cudaError_t cudaGraphExecDestroy(cudaGraphExec_t graph) { return end(graph); }
cudaError_t cudaGraphLaunch(cudaGraphExec_t, cudaStream_t) {
  ++counts.graphs;
  return cudaSuccess;
}
cudaError_t cudaGraphAddEmptyNode(cudaGraphNode_t*, cudaGraph_t, const cudaGraphNode_t*, std::size_t) {
  return cudaSuccess;
}
cudaError_t cudaGraphAddChildGraphNode(cudaGraphNode_t*, cudaGraph_t, const cudaGraphNode_t*, std::size_t,
                                       cudaGraph_t) {
  return cudaSuccess;
}
cudaError_t cudaGraphAddDependencies(cudaGraph_t, const cudaGraphNode_t*, const cudaGraphNode_t*,
                                     const cudaGraphEdgeData*, std::size_t) {
  return cudaSuccess;
}

}  // extern "C"
