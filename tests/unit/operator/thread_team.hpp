// A team of threads of the host in place of one of a device. A barrier that is missing shows here, but for luck, and to
// the thread sanitizer always.
#pragma once

#include <barrier>
#include <thread>
#include <vector>

namespace softwet::testing_tools {

/// Threads that meet at each barrier.
template <int threads>
struct ThreadTeamOf {
  static constexpr int size = threads;
  int rank_, tile_;
  std::barrier<>* all;
  int rank() const { return rank_; }
  int tile() const { return tile_; }
  void barrier() const { all->arrive_and_wait(); }
};

using ThreadTeam = ThreadTeamOf<3>;

/// A team of one thread.
struct OneThread {
  static constexpr int size = 1;
  int tile_;
  int rank() const { return 0; }
  int tile() const { return tile_; }
  void barrier() const {}
};

/// Runs body(team) in all threads of a team for each of the tiles 0 .. count - 1, one tile after another.
template <class Team = ThreadTeam, class Body>
void run_thread_teams(int count, const Body& body) {
  for (int tile = 0; tile < count; ++tile) {
    std::barrier<> all(Team::size);
    std::vector<std::thread> threads;
    for (int r = 0; r < Team::size; ++r) threads.emplace_back([&, r] { body(Team{r, tile, &all}); });
    for (std::thread& thread : threads) thread.join();
  }
}

}  // namespace softwet::testing_tools
