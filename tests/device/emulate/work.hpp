// Work that the host gives the device. It is done at once, as late as is allowed (EMU_LATE=1), or recorded in a graph.
#pragma once

#include <cuda_runtime_api.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace emulate {

using Task = std::function<void()>;

struct Graph {
  std::vector<std::shared_ptr<const Task>> tasks;
};

struct Stream {
  Graph* recording = nullptr;
};

/// Does a task now or later, or adds it to the graph that the stream records.
void give(cudaStream_t stream, Task task);
/// Does all tasks that wait, in the order in which the host gave them.
void finish_all();
bool recording();
cudaError_t failed(cudaError_t error);
/// The error of a call that may not be made while launches are recorded, or success.
cudaError_t unless_recording(const char* call);
/// Counts an event for the report.
void count(const std::string& what, long number = 1);

}  // namespace emulate
