// Exit code 0 where the kernels give what the host computes.
#include <cuda_runtime.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

__constant__ double table[32];
__device__ int counter;
struct Big {
  double a[4];
  int n;
};
__host__ __device__ double mixed(double x, int i) {
  const unsigned u = static_cast<unsigned>(i) * 2654435761u;
  const long long s = static_cast<long long>(i - 50) * 1234567891011ll;
  double r = x * 1.25 - 3 / (x + 2) + sqrt(x) + static_cast<double>(u >> 7) * 1e-9 + static_cast<double>(s % 97) +
             static_cast<double>(s / 1000003);
  r += static_cast<float>(x) * 0.5f + static_cast<int>(x * 7.9) + (i % 3 == 0 ? exp(-x) : log(x + 1)) + fmin(x, 3.) +
       fabs(x - 5) + floor(-x) + ceil(x) + rint(x);
  for (int k = 0; k < i % 7; ++k) r = r * 0.5 + k;
  switch (i % 5) {
    case 0:
      r += 1;
      break;
    case 1:
      r *= 2;
      break;
    case 2:
      r -= x;
      break;
    case 3:
      r = r > 0 ? r : -r;
      break;
    default:
      r += static_cast<double>(static_cast<short>(i * 771)) + static_cast<unsigned char>(i * 3);
  }
  return r;
}
__device__ __noinline__ double slow(double x, Big b, int n) {
  double s = 0;
  for (int i = 0; i < n; ++i) s += b.a[i & 3] * x + pow(x, 1.5) + i;
  return s;
}
__global__ void compute(double* p, float* q, int n, Big b) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i >= n) return;
  p[i] = mixed(p[i], i) + slow(p[i], b, i % 4) + table[i % 32] + sin(p[i]);
  q[i] = sinf(q[i]) + 1.f / (q[i] + 1);
}
__global__ void sums(const double* p, double* result, int n) {
  __shared__ double warps[8];
  extern __shared__ double room[];
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  double v = i < n ? p[i] : 0;
  room[threadIdx.x] = v;
  __syncthreads();
  v = room[blockDim.x - 1 - threadIdx.x];
  for (int o = 16; o; o /= 2) v += __shfl_xor_sync(~0u, v, o);
  if (threadIdx.x % 32 == 0) warps[threadIdx.x / 32] = v;
  __syncthreads();
  if (threadIdx.x == 0) {
    double s = 0;
    for (int k = 0; k < blockDim.x / 32; ++k) s += warps[k];
    atomicAdd(result, s);
    atomicAdd(&counter, 1);
  }
  if (i == 0) printf("from the device: %d %s %.3f\n", n, "text", 2.5);
}
#define CHECK(call) \
  if (cudaError_t e = (call)) std::printf("%s: %s\n", #call, cudaGetErrorString(e)), std::exit(1)
int main() {
  const int n = 1000;
  std::vector<double> p(n), back(n);
  std::vector<float> q(n), q_back(n);
  for (int i = 0; i < n; ++i) p[i] = 0.01 * i + 0.1, q[i] = 0.02f * i;
  double t[32];
  for (int i = 0; i < 32; ++i) t[i] = i * 0.5;
  CHECK(cudaMemcpyToSymbol(table, t, sizeof t));
  double *dp, *result;
  float* dq;
  CHECK(cudaMalloc(&dp, n * 8));
  CHECK(cudaMalloc(&dq, n * 4));
  CHECK(cudaMalloc(&result, 8));
  CHECK(cudaMemset(result, 0, 8));
  CHECK(cudaMemcpy(dp, p.data(), n * 8, cudaMemcpyHostToDevice));
  CHECK(cudaMemcpy(dq, q.data(), n * 4, cudaMemcpyHostToDevice));
  const Big b{{1, 2, 3, 4}, 5};
  compute<<<(n + 95) / 96, 96>>>(dp, dq, n, b);
  sums<<<(n + 255) / 256, 256, 256 * 8>>>(dp, result, n);
  CHECK(cudaGetLastError());
  CHECK(cudaDeviceSynchronize());
  CHECK(cudaMemcpy(back.data(), dp, n * 8, cudaMemcpyDeviceToHost));
  CHECK(cudaMemcpy(q_back.data(), dq, n * 4, cudaMemcpyDeviceToHost));
  double total = 0, worst = 0, worst_q = 0, s = 0;
  int blocks = 0;
  CHECK(cudaMemcpy(&s, result, 8, cudaMemcpyDeviceToHost));
  CHECK(cudaMemcpyFromSymbol(&blocks, counter, 4));
  for (int i = 0; i < n; ++i) {
    double e = 0;
    for (int k = 0; k < i % 4; ++k) e += b.a[k & 3] * p[i] + std::pow(p[i], 1.5) + k;
    e += mixed(p[i], i) + t[i % 32] + std::sin(p[i]);
    const double off = std::fabs(back[i] - e) / (1 + std::fabs(e));
    if (off > 1e-12 && worst <= 1e-12) std::printf("first at %d: %.17g, host %.17g\n", i, back[i], e);
    worst = std::fmax(worst, off);
    worst_q = std::fmax(worst_q, std::fabs(q_back[i] - (std::sin(q[i]) + 1.f / (q[i] + 1))));
    total += back[i];
  }
  const double off = std::fabs(total - s) / std::fabs(total);
  const bool good = worst < 1e-12 && worst_q < 1e-5 && off < 1e-12 && blocks == 4;
  std::printf("%s: worst %.3g, single %.3g, sum off %.3g, %d blocks\n", good ? "OK" : "WRONG", worst, worst_q, off,
              blocks);
  return good ? 0 : 1;
}
