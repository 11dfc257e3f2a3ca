// Whether values are admissible, and how large the local error of a step is, for all schemes.
#pragma once

#include "field/factor.hpp"
#include "scene/fault_search.hpp"
#include "scene/scene.hpp"
#include "time/step/host_numbers.hpp"
#include "time/step/scheme.hpp"

namespace softwet {

/// Factors of the last two states in x - x_f, where x_f = (1 + f) last - f before is their extrapolation.
struct ChangeFactors {
  Factor last, before;
  static double of_last(double f) { return -1 - f; }
  static double of_before(double f) { return f; }
};

template <int D, int P>
class Judge {
 public:
  Judge(const Scene<D, P>&, const Case&);

  /// Why values of the unknowns are not admissible; empty when they are.
  Refusal of_values(const ConstArray& unknown) const;
  /// Why values with these ranges are not admissible.
  Refusal of_ranges(bool finite, double least_density, double most_density) const;
  /// Why the mesh of a stage is not admissible; the integrals describe it.
  Refusal of_mesh(const Stage&) const;
  /// Why the mesh or the density at the end of the step is not admissible.
  Refusal of_end(const Stage&) const;

  /// Compares values with the extrapolation of the two states before, f = (time from the last state) / previous_dt:
  ///   max( rms(rho - rho_f) / (rho_l - rho_v),  dt rms(v - v_f) / H )  ~ dt^2,   H the thinner layer
  /// The means are taken over control values. Where elements are graded, these are weighted with the integrals of their
  /// functions, so that a place counts by its volume, not by how many functions it has.
  double indicator(const StepHistory&, const Array& values, double f, double dt) const;

  // For a step whose end the host judges late: how many numbers it needs, what starts the kernels that find them, and,
  // when they are there, whether the mesh is admissible, and the indicator.
  int numbers() const { return squares_count_ + faults_.numbers(); }
  void ask(const StepHistory&, const Stage& end, const ChangeFactors&, const HostNumbers&) const;
  Refusal take_mesh(const Stage& end, const HostNumbers&) const;
  double take_indicator(const StepHistory&, double dt, const HostNumbers&) const;

 private:
  void weigh(const Layout<D>&);
  /// Sums of the squares of a vector of unknowns, of the velocities and of the density.
  std::vector<StripSums<double>> squares() const;
  void ask_squares(const StepHistory&, const Array& values, const ChangeFactors&, const Array& partial) const;
  Refusal of_faults(const MeshFaults&) const;

  const Scene<D, P>& scene_;
  FaultSearch<D, P> faults_;
  double undershoot_, length_;
  Array root_of_weight_;                ///< of each control value, where elements are graded; else empty
  double volume_ = 0, of_scalars_ = 0;  ///< sums of the weights of a component
  int squares_count_;
  HostNumbers partial_;  ///< sums of strips
};

}  // namespace softwet
