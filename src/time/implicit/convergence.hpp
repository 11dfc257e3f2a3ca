// Whether the residual of Newton's method is small enough, field by field and as a whole, and how accurate the next
// linear solve is.
#pragma once

#include <limits>
#include <vector>

#include "case/choices.hpp"
#include "field/range_factors.hpp"

namespace softwet {

struct NewtonControl {
  double rtol = 1e-6;   ///< of the weighted residual, relative to the start of the step
  double atol = 1e-10;  ///< accepted error of velocity and density, sets a floor for the residual
  int max = 10;
  double krylov_rtol = 1e-2;  ///< tightest forcing term; early iterations ask for less
  int krylov_max = 200;
  JacobianKind jacobian = JacobianKind::exact;
  bool bends = false;  ///< contact lines have friction, whose bend lets residuals rise on the way
};

/// Fields are weighted so that each starts the step with the same share of the norm of the residual, or is at its
/// floor. A field whose residual is not much more than round-off has a smaller share, because no solve makes it
/// smaller.
struct FieldRange {
  int first, last;
  double floor;
  double round_off = 0;  ///< norm of the round-off of the residual, where it is above the floor
};

/// The residuals of one solve, from the norms of their fields.
class Convergence {
 public:
  /// @param smallest  part of the largest norm below which the norm of a field at the start is not a measure
  Convergence(const std::vector<FieldRange>& fields, const NewtonControl& control, double smallest)
      : fields_(fields), control_(control), smallest_(smallest) {}

  /// @param sizes  the norm of each field of the next residual; the norms of the first residual set the weights
  void add(const std::vector<double>& sizes);

  bool finite() const;
  /// Whether the last residual is small enough.
  bool reached() const;
  bool vanishes() const { return size_ == 0; }
  /// Whether a state whose residual is small enough is accepted. Where stiff parts stand beside soft ones a residual
  /// that is small for the stiff ones may move the soft ones far. Where one more solve has not halved what remains,
  /// this is round-off.
  /// @param remaining  how far a linear solve would still move fields, over what is accepted; infinite before the first
  ///   solve
  bool accepts(double remaining);
  /// Whether steps are given up, from the third iteration on: the residual has risen twice, or stays above its value at
  /// the start. One rise may be a long step along a soft direction, as the translation of a droplet; Newton's method
  /// converges from there.
  bool diverges();
  /// Tolerance of the next linear solve: Eisenstat and Walker 1996, choice 2, without solving beyond what the step
  /// needs.
  double forcing() const;
  double reduction() const { return size_ / start_; }
  /// Weights of the squares in norms of vectors.
  RangeFactors weights() const;

 private:
  void set_weights();
  double weighted_norm(const std::vector<double>& sizes) const;
  bool at_floor() const;

  const std::vector<FieldRange>& fields_;
  const NewtonControl& control_;
  double smallest_;
  std::vector<double> weight_, sizes_;
  double start_ = 0, previous_ = 0, size_ = 0;
  int iteration_ = -1;
  bool risen_ = false;
  double remaining_ = std::numeric_limits<double>::infinity();
  bool insists_ = false;  ///< the residual is small, but the fields would still move
};

}  // namespace softwet
