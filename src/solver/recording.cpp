#include "solver/recording.hpp"

#include "memory/array.hpp"

#if defined(KOKKOS_ENABLE_CUDA) || defined(KOKKOS_ENABLE_HIP)
#include <Kokkos_Graph.hpp>
#endif

namespace softwet {

#if defined(KOKKOS_ENABLE_CUDA) || defined(KOKKOS_ENABLE_HIP)

std::function<void()> record(std::function<void()> launches) {
  auto graph = Kokkos::Experimental::create_graph(Exec(), [&](const auto& root) {
    const auto all = [&launches](const Exec&) { launches(); };
#if defined(KOKKOS_ENABLE_CUDA)
    root.cuda_capture(Exec(), all);
#else
    root.hip_capture(Exec(), all);
#endif
  });
  graph.instantiate();
  return [graph] { graph.submit(Exec()); };
}

const void* memory_of_sums() {
#if defined(KOKKOS_ENABLE_CUDA)
  return Kokkos::Impl::cuda_internal_scratch_space(Exec(), 0);
#else
  return Kokkos::Impl::hip_internal_scratch_space(Exec(), 0);
#endif
}

#else

std::function<void()> record(std::function<void()> launches) { return launches; }

const void* memory_of_sums() { return nullptr; }

#endif

}  // namespace softwet
