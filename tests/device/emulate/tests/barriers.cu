// A kernel with barriers of which each but one is needed. Without one of the needed ones the emulator must find a fault, whatever the order of
// warps; without the other one it finds none, and the result is the same.
#include <cuda_runtime.h>

#include <cstdio>

constexpr int threads = 96;

// Barriers 0, 1 and 3 are needed. Barrier 2 is not, since each thread reads only what it has written itself.
__global__ void sweep(const double* in, double* out) {
  __shared__ double first[threads], second[threads];
  const int i = threadIdx.x;
  first[i] = in[i];
  __syncthreads();  // 0: first is read from another thread
  second[i] = first[(i + 40) % threads];
  __syncthreads();  // 1: first is written again, which another thread reads above
  first[i] = 2 * second[i];
  __syncthreads();  // 2
  first[i] += second[i];
  __syncthreads();  // 3: first is read from another thread
  out[i] = first[threads - 1 - i];
}

int main() {
  double in[threads], out[threads], *from = nullptr, *to = nullptr;
  for (int i = 0; i < threads; ++i) in[i] = i * i;
  if (cudaMalloc(&from, sizeof in) || cudaMalloc(&to, sizeof out)) return 1;
  cudaMemcpy(from, in, sizeof in, cudaMemcpyHostToDevice);
  sweep<<<1, threads>>>(from, to);
  cudaMemcpy(out, to, sizeof out, cudaMemcpyDeviceToHost);
  for (int i = 0; i < threads; ++i)
    if (out[i] != 3 * in[(threads - 1 - i + 40) % threads]) return 1;
  std::puts("right");
}
