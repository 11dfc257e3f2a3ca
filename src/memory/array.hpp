// Arrays in the memory of the execution space, and host copies of them.
#pragma once

#include <Kokkos_Core.hpp>
#include <cstdint>
#include <string>
#include <vector>

// Lambdas run on the device alone. nvcc hides lambdas for host and device behind a wrapper, which calls a null pointer
// where a lambda is in an inline function or a template that several sources compile.
#if defined(KOKKOS_ENABLE_CUDA) || defined(KOKKOS_ENABLE_HIP)
#undef KOKKOS_LAMBDA
#define KOKKOS_LAMBDA [=] __device__
#endif

namespace softwet {

using Exec = Kokkos::DefaultExecutionSpace;
template <class Real>
using ArrayOf = Kokkos::View<Real*, Exec>;
template <class Real>
using ConstArrayOf = Kokkos::View<const Real*, Exec>;
using Array = ArrayOf<double>;
using ConstArray = ConstArrayOf<double>;
/// Memory of the host that a device copies to by itself.
using HostArray = Kokkos::View<double*, Kokkos::SharedHostPinnedSpace>;

/// True where kernels run on the host.
inline constexpr bool on_host = Kokkos::SpaceAccessibility<Kokkos::HostSpace, Exec::memory_space>::accessible;

/// Room on the host for what an array has; where kernels run there it is the array.
inline HostArray mirror_of(const Array& array) {
  if constexpr (on_host) return HostArray(array.data(), array.extent(0));
  return HostArray(Kokkos::view_alloc(array.label(), Kokkos::WithoutInitializing), array.extent(0));
}

/// True with the algorithms of a processor: columns of elements in SIMD packs, factors, pieces of lines. False with the
/// algorithms of a device: one thread for each point or entry. These run on the host too, where a build asks for it
/// (SOFTWET_DEVICE_ALGORITHMS), so that all of them can be tested without a device.
#ifdef SOFTWET_DEVICE_ALGORITHMS
inline constexpr bool host_algorithms = false;
#else
inline constexpr bool host_algorithms = on_host;
#endif

/// Policies that start kernels. Their hint makes a kernel's numbers travel with its launch. Without it Kokkos 5 puts
/// numbers of more than 512 bytes into constant memory on AMD's GPUs, and at the next such launch the host waits until
/// the previous kernel has ended. On NVIDIA's GPUs they travel with the launch in any case.
using WithLaunch = Kokkos::Experimental::WorkItemProperty::HintLightWeight_t;
using Items = Kokkos::RangePolicy<Exec, WithLaunch>;
using LongItems = Kokkos::RangePolicy<Exec, WithLaunch, Kokkos::IndexType<std::int64_t>>;
template <class... Options>
using Teams = Kokkos::TeamPolicy<Exec, WithLaunch, Options...>;

template <class ViewType>
inline ViewType to_device(const std::vector<typename ViewType::non_const_value_type>& values,
                          const std::string& name = "softwet") {
  ViewType view(Kokkos::view_alloc(name, Kokkos::WithoutInitializing), values.size());
  Kokkos::View<const typename ViewType::non_const_value_type*, Kokkos::HostSpace,
               Kokkos::MemoryTraits<Kokkos::Unmanaged>>
      host(values.data(), values.size());
  Kokkos::deep_copy(view, host);
  return view;
}

inline std::vector<double> to_host(const ConstArray& view) {
  std::vector<double> values(view.extent(0));
  Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> host(values.data(), values.size());
  Kokkos::deep_copy(host, view);
  return values;
}

}  // namespace softwet
