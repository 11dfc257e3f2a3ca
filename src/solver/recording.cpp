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

#else

std::function<void()> record(std::function<void()> launches) { return launches; }

#endif

}  // namespace softwet
