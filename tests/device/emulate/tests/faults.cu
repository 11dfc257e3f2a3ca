// Each kernel has one fault, which is named by the argument; the emulator must find it.
#include <cuda_runtime.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>
__global__ void outside(double* p, int n) { p[threadIdx.x + n - 16] = 1; }
__global__ void race(double* p) {
  __shared__ double s[64];
  s[threadIdx.x] = threadIdx.x;
  p[threadIdx.x] = s[63 - threadIdx.x];
}
__global__ void overwritten(double* p) {
  __shared__ double s[64];
  s[threadIdx.x] = threadIdx.x;
  __syncthreads();
  p[threadIdx.x] = s[63 - threadIdx.x];
  s[threadIdx.x] = 0;
  __syncthreads();
  p[threadIdx.x] += s[threadIdx.x];
}
__global__ void lanes(double* p) {
  __shared__ volatile double s[32];
  s[threadIdx.x] = threadIdx.x;
  p[threadIdx.x] = s[31 - threadIdx.x];
}
__global__ void unwritten(double* p) {
  __shared__ double s[64];
  if (threadIdx.x < 40) s[threadIdx.x] = 1;
  __syncthreads();
  p[threadIdx.x] = s[63 - threadIdx.x];
}
__global__ void barrier(double* p) {
  if (threadIdx.x < 40) {
    p[threadIdx.x] = 1;
    __syncthreads();
    p[threadIdx.x] += 1;
  } else {
    p[threadIdx.x] = 2;
  }
}
__global__ void big_shared(double* p) {
  extern __shared__ double s[];
  s[threadIdx.x] = 1;
  __syncthreads();
  p[threadIdx.x] = s[threadIdx.x];
}
__global__ void misaligned(double* p) { *reinterpret_cast<double2*>(p + 1) = {1, 2}; }
__global__ void good(double* p) {
  __shared__ double s[64];
  s[threadIdx.x] = threadIdx.x;
  __syncthreads();
  const double v = s[63 - threadIdx.x];
  __syncthreads();
  s[threadIdx.x] = v;
  __syncwarp();
  if (threadIdx.x % 3 == 0)
    p[threadIdx.x] = s[threadIdx.x ^ 1];
  else if (threadIdx.x % 3 == 1)
    p[threadIdx.x] = __shfl_xor_sync(__activemask(), v, 0);
}
int main(int, char** words) {
  double* p;
  cudaMalloc(&p, 64 * 8);
  const char* what = words[1];
  if (!std::strcmp(what, "outside")) outside<<<1, 32>>>(p, 64);
  if (!std::strcmp(what, "race")) race<<<1, 64>>>(p);
  if (!std::strcmp(what, "overwritten")) overwritten<<<1, 64>>>(p);
  if (!std::strcmp(what, "lanes")) lanes<<<1, 32>>>(p);
  if (!std::strcmp(what, "unwritten")) unwritten<<<1, 64>>>(p);
  if (!std::strcmp(what, "barrier")) barrier<<<1, 64>>>(p);
  if (!std::strcmp(what, "big_shared")) big_shared<<<1, 64, 63 * 8>>>(p);
  if (!std::strcmp(what, "misaligned")) misaligned<<<1, 1>>>(p);
  if (!std::strcmp(what, "freed")) cudaFree(p), good<<<1, 64>>>(p);
  if (!std::strcmp(what, "good")) good<<<1, 64>>>(p);
  if (!std::strcmp(what, "host")) std::printf("%g\n", p[3]);
  return cudaDeviceSynchronize();
}
