// Kernels that are recorded once and then started as one.
#pragma once

#include <Kokkos_Core.hpp>
#include <functional>
#include <map>

namespace softwet {

/// Returns what starts all kernels that `launches` starts, in their order and with the arguments that they have now. On
/// CUDA and HIP they are a graph of the device, so that the host makes one call for all of them. Elsewhere it calls
/// `launches`.
///
/// `launches` starts kernels on the default instance of Exec and does nothing else that a device sees: it copies
/// nothing between memories, allocates nothing and waits for nothing. It has been called before, so that its kernels
/// are loaded, and Kokkos has memory for teams (memory/team_scratch.hpp). While a tool of Kokkos listens nothing can be
/// recorded, since Kokkos waits after each kernel then.
std::function<void()> record(std::function<void()> launches);

/// Memory of Kokkos for sums of kernels. It moves when a larger one is asked for, and then nothing that was recorded
/// before may be started: recordings of such kernels have it in their key.
const void* memory_of_sums();

/// What was recorded, by all that the arguments of its kernels follow from.
/// Tested: tests/unit/solver/test_recorded_answers.cpp
template <class Key>
class Recordings {
 public:
  /// @param most  keys that are known at once; beyond that all are forgotten
  explicit Recordings(std::size_t most = -1) : most_(most) {}

  /// Whether the kernels of this key may be recorded: not the first time, when they have to start one by one, and not
  /// while a tool of Kokkos listens.
  bool ready(const Key& key) {
    if (known_.size() >= most_ && known_.count(key) == 0) known_.clear();
    return !known_.try_emplace(key).second && !Kokkos::Tools::profileLibraryLoaded();
  }
  /// Starts the kernels of a key that is ready, as one. They are recorded where they are not yet.
  void start(const Key& key, const std::function<void()>& launches) {
    std::function<void()>& recorded = known_[key];
    if (!recorded) recorded = record(launches);
    recorded();
  }
  /// What was recorded is void, but its kernels have run once.
  void forget() {
    for (auto& [key, recorded] : known_) recorded = nullptr;
  }
  int count() const {
    int count = 0;
    for (const auto& [key, recorded] : known_) count += recorded ? 1 : 0;
    return count;
  }

 private:
  std::size_t most_;
  std::map<Key, std::function<void()>> known_;
};

}  // namespace softwet
