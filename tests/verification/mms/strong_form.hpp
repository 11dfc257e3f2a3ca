// What the exact solution leaves in the strong form of the equations, point by point: the sources that make it exact.
//
//   mass       rho_t + v.grad rho + rho div v - div(eps grad mu)
//   potential  mu - W'(rho) + g^2 Lap rho
//   momentum   rho (v_t + v.grad v) - div tau + rho grad mu               solid: rho0s v_t - Div P
//   wall rows  - div Sigma - rho grad mu        added to the momentum of the wall's functions alone, whose capillary
//                                               force has the form (grad wh, Sigma); zero where mu = W' - g^2 Lap rho
// and, on the wall and the top, what the integration by parts leaves there. Nothing here uses the weak form.
#pragma once

#include "exact.hpp"

namespace softwet::mms {

struct Material {
  double viscosity, capillarity, temperature, stabilisation;  ///< stabilisation: eps / rho^2
  double cosine, smoothing;                                   ///< of the wall's law
  double lame, shear, solid_density;
};

/// W(rho), scale a b^2.
template <class N>
N bulk_energy(double temperature, const N& rho) {
  using std::log;
  return (8.0 / 27.0 * temperature) * rho * log(rho / (1.0 - rho)) - rho * rho;
}
/// W'(rho), scale a b.
template <class N>
N bulk_potential(double temperature, const N& rho) {
  Jet<N, 1> r(rho);
  r.slope[0] = N(1.0);
  return bulk_energy(temperature, r).slope[0];
}

/// The fluid at a point of the deformed mesh; gradients with respect to x, rates at fixed mesh coordinate.
template <class N, int D>
struct FluidPoint {
  Matrix<N, D> inverse;  ///< dX/dx
  N volume;              ///< det dx/dX
  N density, density_rate, potential;
  Vector<N, D> density_gradient, potential_gradient, velocity, acceleration, mesh_velocity;
  Matrix<N, D> velocity_gradient;

  FluidPoint(const Exact<D>& exact, const Point<N, D>& point) {
    const auto p = point.seeded();
    const auto shift = exact.mesh_displacement(p), v = exact.velocity(p);
    const auto rho = exact.density(p), mu = exact.potential(p);
    Matrix<N, D> f;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) f(i, j) = shift[i].slope[j] + (i == j ? 1.0 : 0.0);
    const Matrix<N, D> cofactors = cofactor(f);
    volume = determinant(f, cofactors);
    inverse = (1.0 / volume) * transpose(cofactors);
    density = rho.value;
    density_rate = rho.slope[D];
    density_gradient = gradient(rho);
    potential = mu.value;
    potential_gradient = gradient(mu);
    for (int i = 0; i < D; ++i) {
      velocity[i] = v[i].value;
      acceleration[i] = v[i].slope[D];
      mesh_velocity[i] = shift[i].slope[D];
      const Vector<N, D> g = gradient(v[i]);
      for (int j = 0; j < D; ++j) velocity_gradient(i, j) = g[j];
    }
  }

  /// grad a of a field differentiated along X: (dX/dx)^T Grad a
  Vector<N, D> gradient(const Jet<N, D + 1>& a) const {
    Vector<N, D> g;
    for (int j = 0; j < D; ++j) g[j] = a.slope[j];
    return product(transpose(inverse), g);
  }
  /// eps grad mu: minus the stabilising flux of mass
  Vector<N, D> stabilising_flux(const Material& m) const {
    return (m.stabilisation * (density * density)) * potential_gradient;
  }
  /// tau = m (grad v + grad v^T) - (2/3) m div v I
  Matrix<N, D> viscous_stress(const Material& m) const {
    const Matrix<N, D> sum = velocity_gradient + transpose(velocity_gradient);
    return add_diagonal(m.viscosity * sum, (-2.0 / 3.0 * m.viscosity) * trace(velocity_gradient));
  }
  /// Sigma = (W - rho mu + g^2 |grad rho|^2 / 2) I - g^2 grad rho (x) grad rho
  Matrix<N, D> capillary_stress(const Material& m) const {
    const double g2 = m.capillarity * m.capillarity;
    const N pressure = bulk_energy(m.temperature, density) - density * potential +
                       (0.5 * g2) * dot(density_gradient, density_gradient);
    return add_diagonal((-g2) * outer(density_gradient, density_gradient), pressure);
  }
};

/// First Piola-Kirchhoff stress as the derivative of lambda tr(E)^2 / 2 + G E:E by F = I + Grad u.
template <class N, int D>
Matrix<N, D> first_piola(const Material& m, const Matrix<N, D>& grad_u) {
  using J = Jet<N, D * D>;
  Matrix<J, D> f;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      f(i, j) = J(grad_u(i, j) + (i == j ? 1.0 : 0.0));
      f(i, j).slope[i * D + j] = N(1.0);
    }
  const Matrix<J, D> strain = 0.5 * add_diagonal(product(transpose(f), f), -1.0);
  const J energy = (0.5 * m.lame) * (trace(strain) * trace(strain)) + m.shear * contract(strain, strain);
  Matrix<N, D> stress;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) stress(i, j) = energy.slope[i * D + j];
  return stress;
}

template <class N, int D>
Matrix<N, D> first_piola(const Material& m, const Exact<D>& exact, const Point<N, D>& point) {
  const auto u = exact.displacement(point.seeded());
  Matrix<N, D> grad_u;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) grad_u(i, j) = u[i].slope[j];
  return first_piola(m, grad_u);
}

/// Sources per reference volume, or per reference area of a horizontal face.
template <int D>
struct Source {
  Vector<double, D> momentum{}, wall_momentum{};
  double mass = 0, potential = 0;
};

/// div of a field of vectors whose slopes are along X.
template <int D, class J>
double divergence(const Vector<J, D>& flux, const Matrix<J, D>& inverse) {
  double sum = 0;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) sum += flux[i].slope[j] * inverse(j, i).value;
  return sum;
}
template <int D, class J>
Vector<double, D> divergence(const Matrix<J, D>& stress, const Matrix<J, D>& inverse) {
  Vector<double, D> r;
  for (int i = 0; i < D; ++i) {
    Vector<J, D> row;
    for (int j = 0; j < D; ++j) row[j] = stress(i, j);
    r[i] = divergence<D>(row, inverse);
  }
  return r;
}

template <int D>
Source<D> fluid_source(const Exact<D>& exact, const Material& m, const Point<double, D>& p) {
  const FluidPoint<double, D> here(exact, p);
  const FluidPoint<Jet<double, D + 1>, D> around(exact, p.seeded());
  const Vector<double, D> slip = here.velocity - here.mesh_velocity;
  const Vector<double, D> force = here.density * here.potential_gradient;
  const Vector<double, D> inertia = here.density * (here.acceleration + product(here.velocity_gradient, slip));
  const double g2 = m.capillarity * m.capillarity;
  Source<D> s;
  s.momentum = here.volume * (inertia - divergence<D>(around.viscous_stress(m), around.inverse) + force);
  s.wall_momentum = (-here.volume) * (divergence<D>(around.capillary_stress(m), around.inverse) + force);
  s.mass = here.volume *
           (here.density_rate + dot(here.density_gradient, slip) + here.density * trace(here.velocity_gradient) -
            divergence<D>(around.stabilising_flux(m), around.inverse));
  s.potential = here.volume * (here.potential - bulk_potential(m.temperature, here.density) +
                               g2 * divergence<D>(around.density_gradient, around.inverse));
  return s;
}

/// On the wall (side = -1) or the top (side = 1) of the fluid.
template <int D>
Source<D> fluid_face_source(const Exact<D>& exact, const Material& m, const Point<double, D>& p, int side) {
  const FluidPoint<double, D> here(exact, p);
  Vector<double, D> normal;  // n da = det(F) F^-T N dA
  for (int i = 0; i < D; ++i) normal[i] = side * here.volume * here.inverse(D - 1, i);
  const double area = std::sqrt(dot(normal, normal)), g2 = m.capillarity * m.capillarity;
  const double slope = std::sqrt(dot(here.density_gradient, here.density_gradient) + m.smoothing * m.smoothing);
  Source<D> s;
  s.momentum = product(here.viscous_stress(m), normal);
  if (side < 0) s.wall_momentum = product(here.capillary_stress(m), normal);
  s.mass = dot(here.stabilising_flux(m), normal);
  s.potential = -g2 * dot(here.density_gradient, normal) + (side < 0 ? g2 * m.cosine * slope * area : 0.0);
  return s;
}

template <int D>
Source<D> solid_source(const Exact<D>& exact, const Material& m, const Point<double, D>& p) {
  const auto around = p.seeded();
  const auto v = exact.solid_velocity(around);
  const auto stress = first_piola(m, exact, around);
  Source<D> s;
  for (int i = 0; i < D; ++i) {
    s.momentum[i] = m.solid_density * v[i].slope[D];
    for (int j = 0; j < D; ++j) s.momentum[i] -= stress(i, j).slope[j];
  }
  return s;
}

/// On the top of the solid.
template <int D>
Source<D> solid_face_source(const Exact<D>& exact, const Material& m, const Point<double, D>& p) {
  const Matrix<double, D> stress = first_piola(m, exact, p);
  Source<D> s;
  for (int i = 0; i < D; ++i) s.momentum[i] = stress(i, D - 1);
  return s;
}

}  // namespace softwet::mms
