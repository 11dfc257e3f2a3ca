// The state of rest of a case, and whether it is stable.
#pragma once

#include "run/journal.hpp"
#include "run/way_to_rest.hpp"
#include "time/rest/growth.hpp"

namespace softwet {

/// Finds the state of rest under the full loads, in a folder that exists. Each of several processes computes its
/// columns of the scene.
template <int D, int P>
class Rest {
 public:
  Rest(const Case&, const RunOptions&);

  /// Throws Error (computation_failed) where there is none, after a checkpoint of the last state.
  void run();

 private:
  /// False: it was asked to stop before the scene was at rest.
  bool begin();
  void describe(RunRecord&) const;

  const Case& case_;
  Scene<D, P> scene_;
  Stepper<D, P> stepper_;
  Journal<D, P> journal_;
  WayToRest<D, P> way_;
  std::optional<Growth> growth_;  ///< of disturbances of the state at rest
};

}  // namespace softwet
