// How a scene comes to rest: before its first step, or as all that is asked of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/journal.hpp"
#include "time/rest/relaxation.hpp"

namespace softwet {

/// The way of one state to rest, and what became of the bodies on it.
template <int D, int P>
class WayToRest {
 public:
  WayToRest(const Case& c, const Scene<D, P>& scene, Journal<D, P>& journal)
      : case_(c), scene_(scene), journal_(journal) {}

  /// Takes the state to rest, or as near as it comes. False: it was asked to stop on the way.
  /// @param time_of_loads  at which loads act: the time of the state, or just behind it
  /// @param asked_by       what a user who has stopped it reads behind "at rest"
  bool go(State& state, double time_of_loads, const std::string& asked_by);
  /// Why it is not at rest; empty where it is.
  const std::string& why_not() const { return relaxation_->why; }
  const Relaxation& relaxation() const { return *relaxation_; }
  /// For run.json. Nothing before the way was gone.
  void describe(RecordValue& rest) const;

 private:
  const Case& case_;
  const Scene<D, P>& scene_;
  Journal<D, P>& journal_;
  std::optional<Relaxation> relaxation_;
  double speed_ = 0, mass_change_ = 0;        ///< the largest one at rest; of the mass on the way, relative
  std::vector<std::optional<double>> moved_;  ///< how far each body went
};

}  // namespace softwet
