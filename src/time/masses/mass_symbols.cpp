#include "time/masses/mass_symbols.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "spline/axis.hpp"
#include "time/masses/end_ties.hpp"

namespace softwet {
namespace {

using Dense = Eigen::MatrixXd;

/// Elements of length 1 in a row: (N_i, N_j), (N_i', N_j') and (N_i, N_j') with the weight of the axis. Along a radius
/// there are also (N_i / r, N_j / r) of the hoop strain and the mean of (N_i / r, N_j') and its transpose; zero
/// elsewhere.
struct ElementLine {
  Dense mass, stiffness, slope, hoop, mixed;
  int at_joint;  ///< the function that is 1 at the joint; 0: there is none

  ElementLine(int elements, int degree, AxisKind kind = AxisKind::bounded, int joint = 0) {
    const Axis axis(elements, elements, degree, kind, 0, joint);
    const Gauss gauss(degree + 1);
    const int n = axis.functions();
    at_joint = joint > 0 ? axis.span(joint) : 0;
    mass = stiffness = slope = hoop = mixed = Dense::Zero(n, n);
    for (int e = 0; e < elements; ++e)
      for (int q = 0; q <= degree; ++q) {
        const double x = e + gauss.point[q], r = axis.weight(x), weight = gauss.weight[q] * r,
                     on = kind == AxisKind::radial ? 1 : 0;
        const std::vector<double> value = axis.values(e, x), d = axis.slopes(e, x);
        for (int a = 0; a <= degree; ++a)
          for (int b = 0; b <= degree; ++b) {
            const int i = axis.span(e) + a, j = axis.span(e) + b;
            mass(i, j) += weight * value[a] * value[b];
            stiffness(i, j) += weight * d[a] * d[b];
            slope(i, j) += weight * value[a] * d[b];
            hoop(i, j) += on * weight * value[a] / r * value[b] / r;
            mixed(i, j) += on * weight * 0.5 * (value[a] * d[b] + d[a] * value[b]) / r;
          }
      }
  }
};

/// 1 + e + e^2 - 2 e^3 of a matrix or a number.
template <class T>
T series(const T& one, const T& e) {
  const T square = e * e;
  return one + e + square - 2 * (square * e);
}

/// Whether the function at an end of a line is prescribed.
enum class LineEnd { free, held };

/// The inverse of a mass with ties, without the functions that are held: zero rows and columns for these.
/// @param joint  the function there; 0: none
Dense inverse(const Dense& mass, MassKind kind, double kept, LineEnd below, LineEnd above, int joint = 0) {
  const int all = static_cast<int>(mass.rows()), first = below == LineEnd::held ? 1 : 0,
            n = all - first - (above == LineEnd::held ? 1 : 0);
  const Eigen::VectorXd sums = mass.rowwise().sum().segment(first, n);
  const Dense inner = mass.block(first, first, n, n), one = Dense::Identity(n, n);
  Dense found = Dense::Zero(all, all);
  if (kind == MassKind::consistent) {
    found.block(first, first, n, n) = inner.inverse();
    return found;
  }
  Dense d = sums.cwiseInverse().asDiagonal();
  const auto tie = [&](int end, int way, double part) {
    Eigen::VectorXd along = Eigen::VectorXd::Zero(n);
    along[end] = 1;
    along[end + way] = -1;
    const Eigen::VectorXd scaled = along.cwiseQuotient(sums);
    d -= (1 - part) / along.dot(scaled) * scaled * (along.transpose() * d);
  };
  // As EndTies does it: where ends share a function, halves of all but the last come before it and after it.
  const bool tied_below = below == LineEnd::free && n > 1, tied_above = above == LineEnd::free && n > 1,
             joined = joint - first > 0;
  const double last_above = joined ? std::sqrt(kept) : kept;
  if (tied_below) tie(0, 1, std::sqrt(kept));
  if (tied_above) tie(n - 1, -1, last_above);
  if (joined) tie(joint - first, -1, kept);
  if (tied_above && joined) tie(n - 1, -1, last_above);
  if (tied_below) tie(0, 1, std::sqrt(kept));
  found.block(first, first, n, n) = kind == MassKind::lumped ? d : Dense(series<Dense>(one, one - d * inner) * d);
  return found;
}

double largest(const Dense& m) { return m.eigenvalues().cwiseAbs().maxCoeff(); }

/// Largest factor between a lumped quantity, such as springs at control values, and a mass. Ties make lumped masses
/// larger. So the eigenvalues of e in the series lie in [0, 1], in any dimension, and the largest value of the series
/// there bounds corrected masses.
double held_factor(const ElementLine& line, MassKind kind) {
  if (kind == MassKind::lumped) return 1;
  if (kind == MassKind::corrected) return series<double>(1, (1 + std::sqrt(7.0)) / 6);
  return largest(line.mass.inverse() * Dense(line.mass.rowwise().sum().asDiagonal()));
}

}  // namespace

MassSymbols inside_symbols(int degree, MassKind kind) {
  const ElementLine line(4 * degree, degree);
  const int middle = static_cast<int>(line.mass.rows()) / 2;
  MassSymbols s;
  constexpr int waves = 400;
  for (int w = 1; w <= waves; ++w) {
    const double angle = M_PI * w / waves;
    double mass = 0, stiffness = 0, slope = 0;
    for (int k = -degree; k <= degree; ++k) {
      mass += line.mass(middle, middle + k) * std::cos(k * angle);
      stiffness += line.stiffness(middle, middle + k) * std::cos(k * angle);
      slope += line.slope(middle, middle + k) * std::sin(k * angle);
    }
    const double inverse = kind == MassKind::consistent ? 1 / mass
                           : kind == MassKind::lumped   ? 1
                                                        : series<double>(1, 1 - mass);
    s.acoustic = std::max(s.acoustic, std::sqrt(inverse * inverse * inverse * mass) * std::abs(slope));
    s.capillary = std::max(s.capillary, std::sqrt(inverse * inverse * inverse * stiffness) * std::abs(slope));
    s.viscous = std::max(s.viscous, inverse * stiffness);
    s.convective = std::max(s.convective, inverse * std::abs(slope));
    s.elastic = std::max(s.elastic, std::sqrt(inverse * stiffness));
    if (kind == MassKind::consistent) s.held = std::max(s.held, 1 / mass);
  }
  s.diffusive = s.viscous;
  return s;
}

MassSymbols end_symbols(int degree, MassKind kind, int elements, Coordinates coordinates) {
  const bool radial = coordinates == Coordinates::axisymmetric;
  const ElementLine line(elements, degree, radial ? AxisKind::radial : AxisKind::bounded);
  const Dense held = inverse(line.mass, kind, kept_of_velocities, LineEnd::held, LineEnd::held);
  const Dense free = inverse(line.mass, kind, kept_of_velocities, LineEnd::free, LineEnd::free);
  const Dense layer = inverse(line.mass, kind, kept_of_velocities, LineEnd::held, LineEnd::free);
  const Dense scalar = inverse(line.mass, kind, kept_of_scalars, LineEnd::free, LineEnd::free);
  // rho' = - S grad^T v,  mu = S (c^2 M + g^2 K) rho / rho,  v' = - S grad mu
  const Dense there = scalar * line.slope.transpose(), back = held * line.slope * scalar;
  MassSymbols s = inside_symbols(degree, kind);
  s.acoustic = std::max(s.acoustic, std::sqrt(largest(back * line.mass * there)));
  s.capillary = std::max(s.capillary, std::sqrt(largest(back * line.stiffness * there)));
  s.viscous = std::max({s.viscous, largest(free * line.stiffness), largest(held * line.stiffness)});
  s.diffusive = std::max(s.diffusive, largest(scalar * line.stiffness));  // the ties of scalars are weaker
  s.elastic = std::max(s.elastic, std::sqrt(std::max(largest(layer * line.stiffness), largest(free * line.stiffness))));
  if (radial) {
    // tau : grad v = 4/3 m (v'^2 + (v/r)^2 - v' v/r); elastic waves (lambda + 2 mu) (u'^2 + (u/r)^2) + 2 lambda u' u/r
    for (const Dense& axis : {held, layer}) {
      s.viscous = std::max(s.viscous, largest(axis * (line.stiffness + line.hoop - line.mixed)));
      for (const double lambda : {0.0, 0.5, 1.0})  // in parts of lambda + 2 mu
        s.elastic =
            std::max(s.elastic, std::sqrt(largest(axis * (line.stiffness + line.hoop + 2 * lambda * line.mixed))));
    }
  }
  // Faces lie across the vertical axis, whose line has no weight.
  const Dense upwards = radial ? ElementLine(elements, degree).mass : line.mass;
  const Dense held_below = inverse(upwards, kind, kept_of_velocities, LineEnd::held, LineEnd::free);
  const double along = radial ? std::max(s.viscous, s.elastic * s.elastic) : s.viscous;
  s.surface = std::sqrt(along * held_below(held_below.rows() - 1, held_below.cols() - 1));
  s.springs = std::sqrt(inverse(upwards, kind, kept_of_velocities, LineEnd::free, LineEnd::free)(0, 0));
  s.held = std::max(s.held, held_factor(line, kind));
  return s;
}

MassSymbols with_joint(MassSymbols ends, int degree, MassKind kind, JoinedElements elements) {
  if (elements.below == 0) return ends;
  const int below = std::min(elements.below, 10), above = std::min(elements.above, 10);
  const ElementLine line(below + above, degree, AxisKind::bounded, below);
  const auto inverse_of = [&](LineEnd at_bottom, LineEnd at_top) {
    return inverse(line.mass, kind, kept_of_velocities, at_bottom, at_top, line.at_joint);
  };
  const auto of = [&](LineEnd at_bottom, LineEnd at_top) {
    return largest(inverse_of(at_bottom, at_top) * line.stiffness);
  };
  const double free = of(LineEnd::free, LineEnd::free);
  ends.elastic = std::max(ends.elastic, std::sqrt(std::max(free, of(LineEnd::held, LineEnd::free))));
  ends.viscous = std::max({ends.viscous, free, of(LineEnd::held, LineEnd::held)});
  ends.springs = std::max(ends.springs, std::sqrt(inverse_of(LineEnd::free, LineEnd::free)(0, 0)));
  ends.held = std::max(ends.held, held_factor(line, kind));
  return ends;
}

}  // namespace softwet
