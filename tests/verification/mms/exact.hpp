// The exact solutions: smooth fields chosen freely, in reference coordinates X, that obey the sides of the scene.
//
// Horizontal sides are slip sides: a vector component is a sine along its own axis, everything else a cosine. On the
// top of the coupled scene v = 0, on the top of the other scenes v_n = 0. All fields are templates in the number, so
// that their derivatives come from jets.
#pragma once

#include <numbers>

#include "jet.hpp"
#include "kernels/algebra/tensor.hpp"

namespace softwet::mms {

enum class SceneKind { fluid, solid, coupled };
/// linear: fields linear in time, exact for generalized-alpha on a fixed mesh; harmonic: for orders in time.
enum class Course { linear, harmonic };

/// Reference coordinates and time.
template <class N, int D>
struct Point {
  Vector<N, D> x;
  N t;

  /// This point with D + 1 directions to differentiate along: x_0, .., x_{D-1}, t.
  Point<Jet<N, D + 1>, D> seeded() const {
    Point<Jet<N, D + 1>, D> p;
    for (int d = 0; d < D; ++d) {
      p.x[d] = x[d];
      p.x[d].slope[d] = N(1.0);
    }
    p.t = t;
    p.t.slope[D] = N(1.0);
    return p;
  }
};

template <int D>
struct Exact {
  SceneKind scene;
  Course course;
  std::array<double, D> length;
  double wall;  ///< height of the interface; 0 in the scene fluid, the top in the scene solid

  /// Amplitude number k, of order one.
  template <class N>
  N amplitude(const N& t, int k) const {
    using std::sin;
    if (course == Course::linear) return 0.7 + (k % 2 ? -0.6 : 0.8) * t;
    return 1.0 + 0.5 * sin((5.0 + k % 3) * t + 0.9 * k);
  }

  /// Product over the horizontal axes: sine of (mode pi x / L) along `own`, cosine along the others. In 3D, whose
  /// meshes are coarser, the mode is 1.
  template <class N>
  N horizontal(const Vector<N, D>& x, int mode, int own = -1) const {
    using std::cos, std::sin;
    N product(1.0);
    for (int d = 0; d + 1 < D; ++d) {
      const N phase = ((D == 2 ? mode : 1) * std::numbers::pi / length[d]) * x[d];
      product = product * (d == own ? sin(phase) : cos(phase));
    }
    return product;
  }

  /// Height above the wall, 0 .. 1.
  template <class N>
  N height(const Vector<N, D>& x) const {
    return (x[D - 1] - wall) / (length[D - 1] - wall);
  }

  /// Amplitude of component d of the displacement. Linear: undeformed at the start, so that no error of the initial
  /// displacement sets off elastic waves, whose velocity would be one order lower.
  template <class N>
  N stretch(const N& t, int d) const {
    return course == Course::linear ? (1.0 + 0.5 * d) * t : 0.4 * amplitude(t, 2 * d);
  }

  /// Displacement of the solid.
  template <class N>
  Vector<N, D> displacement(const Point<N, D>& p) const {
    using std::cos, std::sin;
    Vector<N, D> u;
    const double turn = scene == SceneKind::solid ? std::numbers::pi : 2.0;  // the top of a solid alone is a slip side
    const N phase = (turn / wall) * p.x[D - 1];
    for (int d = 0; d < D; ++d)
      u[d] = (0.03 + 0.01 * d) * stretch(p.t, d) * horizontal(p.x, 2, d) * (d == D - 1 ? sin(phase) : cos(phase));
    return u;
  }

  /// v = du/dt in the solid.
  template <class N>
  Vector<N, D> solid_velocity(const Point<N, D>& p) const {
    Point<Jet<N, 1>, D> seeded;
    for (int d = 0; d < D; ++d) seeded.x[d] = p.x[d];
    seeded.t = p.t;
    seeded.t.slope[0] = N(1.0);
    const Vector<Jet<N, 1>, D> u = displacement(seeded);
    Vector<N, D> v;
    for (int d = 0; d < D; ++d) v[d] = u[d].slope[0];
    return v;
  }

  /// The point of the wall below.
  template <class N>
  Point<N, D> foot(Point<N, D> p) const {
    p.x[D - 1] = N(wall);
    return p;
  }

  /// Displacement of the fluid's mesh: it falls linearly from the displacement of the wall to zero at the top.
  template <class N>
  Vector<N, D> mesh_displacement(const Point<N, D>& p) const {
    if (scene == SceneKind::fluid) return Vector<N, D>{};
    return (1.0 - height(p.x)) * displacement(foot(p));
  }

  /// Velocity of the fluid: it moves with the wall at the wall, and is 0 (coupled) or tangential (fluid) at the top.
  template <class N>
  Vector<N, D> velocity(const Point<N, D>& p) const {
    using std::cos, std::sin;
    const N phase = std::numbers::pi * height(p.x);
    Vector<N, D> v;
    for (int d = 0; d < D; ++d) {
      const bool sine = d == D - 1 || scene == SceneKind::coupled;
      v[d] = (0.2 + 0.1 * d) * amplitude(p.t, d) * horizontal(p.x, 2, d) * (sine ? sin(phase) : cos(phase));
    }
    return scene == SceneKind::coupled ? v + cos(0.5 * phase) * solid_velocity(foot(p)) : v;
  }

  /// Stable liquid at theta = 0.85: W'' > 0 for rho in (0.5, 0.7).
  template <class N>
  N density(const Point<N, D>& p) const {
    return 0.6 + 0.06 * amplitude(p.t, 3) * horizontal(p.x, 2) * vertical(p.x, 0.3);
  }

  template <class N>
  N potential(const Point<N, D>& p) const {
    return -0.4 + 0.05 * amplitude(p.t, 4) * horizontal(p.x, 1) * vertical(p.x, -0.4);
  }

 private:
  /// Slope zero at wall and top in the scene fluid, whose sides have no sources.
  template <class N>
  N vertical(const Vector<N, D>& x, double shift) const {
    using std::cos;
    return scene == SceneKind::fluid ? cos(std::numbers::pi * height(x)) : cos(2.0 * height(x) + shift);
  }
};

}  // namespace softwet::mms
