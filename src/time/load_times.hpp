// How loads and needles vary over time: which times steps meet, after which a run starts afresh, and how long steps may
// be in between (host).
#pragma once

#include <memory>
#include <vector>

#include "case/case.hpp"

namespace softwet {

/// Where a load jumps, or nearly jumps, on the clock of the computation. A step ends at `time`, with the load before
/// the jump. The next one goes on from `behind`, with the load after the jump, and without the rates and the history of
/// earlier steps.
struct Jump {
  double time, behind;
};

/// The ramps, factors and paths of the loads of a case, and the paths of its needles. Ramps and tables say where they
/// are not smooth. Expressions are looked at.
/// Tested: tests/unit/time/test_load_times.cpp
class LoadTimes {
 public:
  explicit LoadTimes(const Case&);

  /// Times that a step has to end at: starts and ends of ramps, points of tables.
  const std::vector<double>& kinks() const { return kinks_; }
  /// Starts without a ramp, points of a table that are closer than 1e-8 max(1, t), and changes that are short against
  /// dt_initial and against what follows.
  const std::vector<Jump>& jumps() const { return jumps_; }

  /// The longest step from t, at most `wish`, that does not step over a change of a factor or of a path that is an
  /// expression: between the ends of the step, and of the next ones of the same length, each stays within 0.003 of its
  /// range over the run of the line between its values at both ends (or within 0.00015 of its largest value). For sin(w
  /// t) that is about w dt < 0.22. At a jump it ends with the last number that has the value of before.
  double longest(double t, double wish) const;
  /// Where time goes on from t: behind all jumps that are within 1e-8 max(1, t) of it; else t.
  double behind(double t) const;
  /// t where a jump is there; else infinity.
  double jump_at(double t) const;

 private:
  /// How far a line goes, and whether a jump ends it.
  struct Reach {
    double dt;
    bool jump;
  };
  /// An expression of a load that acts from `start` on; times of the computation.
  struct Expression {
    std::shared_ptr<const Formula> formula;
    double start, zero, tolerance;
    std::vector<double> times;  ///< at which it is always looked at
    double at(double t) const { return formula->at({0, 0, 0}, t - zero); }
    bool follows_line(double t, double dt) const;
    bool changes(double from, double to) const;
    double before_change(double from, double to) const;
    Reach reach(double t, double wish) const;
    double longest(double t, double wish) const;
    double behind(double t) const;
  };

  /// @param start  from which on it acts
  void add_profile(double start, const Profile&, double end);
  /// Points of something piecewise smooth. @param changes  whether it changes from point i to the next one
  template <class Changes>
  void add_points(const std::vector<double>& points, const Changes& changes);

  double zero_, dt_initial_;
  std::vector<double> kinks_;
  std::vector<Jump> jumps_;
  std::vector<Expression> expressions_;
};

}  // namespace softwet
