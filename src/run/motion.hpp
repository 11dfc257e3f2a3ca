// A run from its first state to its last.
#pragma once

#include "run/journal.hpp"
#include "run/way_to_rest.hpp"

namespace softwet {

/// Computes the motion of a case in a folder that exists. Each of several processes computes its columns of the scene.
template <int D, int P>
class Motion {
 public:
  Motion(const Case&, const RunOptions&);

  /// To time.end, time.max_steps, time.wall_clock, Ctrl-C. Throws Error (computation_failed) after a checkpoint of the
  /// last good state.
  void run();

 private:
  /// From the state of the case. False: it was asked to stop before the first state was there.
  bool begin();
  /// From the last checkpoint. False: nothing is left to compute.
  bool resume();
  void advance();
  /// Why nothing is left to compute; empty where there is.
  std::string completed();
  std::string stop_reason();
  bool at_end() const;

  const Case& case_;
  const bool resumes_;
  Scene<D, P> scene_;
  Stepper<D, P> stepper_;
  Journal<D, P> journal_;
  WayToRest<D, P> way_to_rest_;  ///< where time.start asks for it
};

}  // namespace softwet
