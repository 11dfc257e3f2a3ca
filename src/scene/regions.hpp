// Where a scene is computed: its patch with the unknowns, the boxes of elements on which terms act, and what sides
// prescribe.
#pragma once

#include <cmath>
#include <vector>

#include "case/case.hpp"
#include "field/layout.hpp"
#include "kernels/point/fields.hpp"
#include "kernels/point/geometry.hpp"
#include "spline/region.hpp"
#include "spline/rule.hpp"

namespace softwet {

template <int D>
class Regions {
 public:
  /// Errors: invalid_input where there are more processes than strips of elements, or no program for the quadrature.
  explicit Regions(const Case&);

  const Layout<D>& layout() const { return layout_; }
  ConstArray mask() const { return mask_; }      ///< 1 free, 0 prescribed or ghost
  int points() const { return points_; }         ///< Gauss points per element and axis
  const Blend& blend() const { return blend_; }  ///< of the motion of the wall over the height of the fluid
  double wall_height() const { return blend_.low; }
  bool has_wall() const { return has_wall_; }  ///< whether the fluid ends at one, rigid or soft
  /// Factor from integrals of the equations to integrals over the whole scene: in the coordinates (r, z) the equations
  /// are integrated for each radian.
  double turn() const { return layout_.axisymmetric() ? 2 * M_PI : 1; }

  const Region<D>& fluid() const { return fluid_; }
  const Region<D>& solid() const { return solid_; }
  const Region<D>& wall() const { return wall_; }
  /// Where a term is integrated, with the points of the scene or others.
  Region<D> of(Where, int points) const;
  /// The parts of this region: the solid below and above its joint, where it has one.
  std::vector<Region<D>> parts_of(Where, int points) const;

 private:
  void build_axes(const Case&);
  void build_mask(const Case&);
  /// Rows of elements [first, last) over the whole width, with Gauss points or another rule per element and axis.
  Region<D> rows(int first, int last, int points) const;
  Region<D> means_of_rows(int first, int last, int points) const;
  /// @param rule  along axis d for its elements [low, high)
  template <class Along>
  Region<D> rows_of(int first, int last, const Along& rule) const;

  int points_;
  Layout<D> layout_;
  Blend blend_;
  bool has_wall_ = false;
  Region<D> solid_, fluid_, wall_;
  Array mask_;
};

}  // namespace softwet
