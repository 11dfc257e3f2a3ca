// The load vector of the sources: their integrals against the B-splines.
#pragma once

#include "quadrature.hpp"
#include "strong_form.hpp"

namespace softwet::mms {

template <int D>
class Load {
 public:
  Load(const Layout<D>& layout, const Exact<D>& exact, const Material& material)
      : layout_(layout), exact_(exact), material_(material) {}

  /// What the discrete equations have to get at time t, in the layout of the unknowns.
  const std::vector<double>& at(double t) {
    if (t == time_) return sum_;
    time_ = t;
    sum_.assign(layout_.size(), 0.0);
    const Axis& vertical = layout_.axis[D - 1];
    const int solid = layout_.solid_elements, all = vertical.elements(), points = vertical.degree() + 2;
    if (layout_.has_solid) {
      add(gauss_points(vertical, 0, solid, points), t,
          [&](const auto& p) { return solid_source(exact_, material_, p); });
      add(face_point(vertical, solid - 1, 1), t,
          [&](const auto& p) { return solid_face_source(exact_, material_, p); });
    }
    if (layout_.has_fluid) {
      add(gauss_points(vertical, solid, all, points), t,
          [&](const auto& p) { return fluid_source(exact_, material_, p); });
      add(face_point(vertical, solid, -1), t,
          [&](const auto& p) { return fluid_face_source(exact_, material_, p, -1); });
      add(face_point(vertical, all - 1, 1), t,
          [&](const auto& p) { return fluid_face_source(exact_, material_, p, 1); });
    }
    return sum_;
  }

 private:
  template <class SourceAt>
  void add(std::vector<AxisPoint> last, double t, const SourceAt& source_at) {
    const Quadrature<D> rule(layout_, layout_.axis[0].degree() + 2, std::move(last));
    const int shift = layout_.fluid_shift();
    const bool traction = layout_.has_solid && layout_.has_fluid;
    rule.for_points([&](const Vector<double, D>& x, double weight, const auto& functions) {
      const Source<D> s = source_at(Point<double, D>{x, t});
      functions([&](int i, double value) {
        const double w = weight * value;
        const bool wall = traction && i >= shift && i < shift + layout_.row_size;
        for (int d = 0; d < D; ++d)
          sum_[layout_.velocity_offset(d) + i] += w * (s.momentum[d] + (wall ? s.wall_momentum[d] : 0.0));
        if (!layout_.has_fluid || i < shift) return;
        sum_[layout_.density_offset() + i - shift] += w * s.mass;
        sum_[layout_.potential_offset() + i - shift] += w * s.potential;
      });
    });
  }

  const Layout<D>& layout_;
  Exact<D> exact_;
  Material material_;
  double time_ = -1;
  std::vector<double> sum_;
};

}  // namespace softwet::mms
