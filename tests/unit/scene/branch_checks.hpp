// The energy of branches in scenes: what the residual does with it, and what a rotation does.
#pragma once

#include "scene/branch_strains.hpp"
#include "unit/scene/rates.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {

/// What branches follow, of a displacement: it, or its strain at each point.
template <int D>
std::vector<double> followed(const Regions<D>& regions, const Array& displacement) {
  if (!regions.layout().branches_at_points) return to_host(displacement);
  const Array strain("strain", regions.layout().branch_size());
  write_strains<2>(regions, displacement, strain);
  return to_host(strain);
}

/// Random branches of a stage, their rates, and what their stress is made of.
template <int D>
void fill_branches(RandomSceneIn<D>& s, std::vector<double>& memory, std::vector<double>& rate) {
  const auto& branches = s.data.substrate->branches;
  const Layout<D>& l = s.layout();
  const int size = l.branch_size(), count = static_cast<int>(branches.size());
  const bool strains = l.branches_at_points;
  memory = to_host(s.terms.patch.draw(count * size, -0.01, 0.01));
  if (l.axisymmetric() && !strains)
    for (int i = 0; i < count * size; ++i)
      if (i % size < l.displacement_offset(1) && i % l.row_size == 0) memory[i] = 0;
  const std::vector<double> x = followed(s.scene.regions(), s.stage().displacement);
  std::vector<double> lag(size, 0.0);
  double moduli = 0;
  for (const Branch& branch : branches) moduli += 2 * branch.modulus;
  rate.resize(memory.size());
  for (int i = 0; i < count * size; ++i) {
    const Branch& branch = branches[i / size];
    rate[i] = (x[i % size] - memory[i]) / branch.time;
    lag[i % size] += 2 * branch.modulus * (strains ? memory[i] / moduli : x[i % size] - memory[i]);
  }
  s.stage().lag = to_device<Array>(lag);
  s.stage().branch_weight = moduli;
  s.stage().memory = to_device<Array>(memory);
  s.stage().memory_rate = to_device<Array>(rate);
}

/// A branch takes from the motion what its spring gains while its dashpot stands still, and the dashpot dissipates what
/// it takes from the spring.
template <int D>
void expect_energy_law_of_branches(Case c, Strain strain) {
  c.substrate->strain = strain;
  c.substrate->branches = {{0.9, 0.3}, {1.7, 0.04}};
  RandomSceneIn<D> s(c);
  std::vector<double> memory, rate;
  fill_branches(s, memory, rate);
  Stage& stage = s.stage();
  const Integrals now = s.scene.balance().measure(stage).integrals;
  const double dissipation = now["dissipation_solid"];
  EXPECT_GT(dissipation, 1e-4);
  EXPECT_GT(now["energy_branches"], 1e-6);
  const double power = s.scene.balance().measure(stage).load_power, expected = s.rate_of_energy(1e-3) - power;
  const std::vector<double> r = s.residual(stage), x = to_host(stage.unknown);
  EXPECT_NEAR(s.scene.regions().turn() * contract(r, x, 0, s.layout().size()), expected, 1e-9 * std::abs(expected));
  const auto energy = [&](double time) {
    Stage moved = stage;
    const Array later = plus(to_device<Array>(memory), time, rate);
    moved.memory = later;
    return s.scene.balance().measure(moved).integrals["energy_branches"];
  };
  EXPECT_NEAR(slope(energy, 1e-3), -dissipation, 1e-9 * dissipation);
}

/// Turns the body about the last axis but one of the dimension: u -> R (X + u) - X, exact for control values.
template <int D>
Array turned(const Layout<D>& l, const Array& displacement, double angle) {
  const std::vector<double> u = to_host(displacement);
  std::vector<double> v = u;
  const double c = std::cos(angle), s = std::sin(angle);
  const int size = l.solid_rows() * l.row_size, other = D - 1;
  for (int i = 0; i < size; ++i) {
    const double x = l.axis[0].greville(i % l.extent(0)), z = l.axis[other].greville(i / l.row_size);
    const double moved_x = x + u[i], moved_z = z + u[other * size + i];
    v[i] = c * moved_x - s * moved_z - x;
    v[other * size + i] = s * moved_x + c * moved_z - z;
  }
  return to_device<Array>(v);
}

template <int D>
void expect_energy_of_branches_to_feel_no_rotation(Case c) {
  c.substrate->branches = {{0.9, 0.3}, {1.7, 0.04}};
  RandomSceneIn<D> s(c);
  std::vector<double> memory, rate;
  fill_branches(s, memory, rate);
  const double before = s.scene.balance().measure(s.stage()).integrals["energy_branches"];
  Stage moved = s.stage();
  moved.displacement = turned(s.layout(), moved.displacement, 2.1);
  const double after = s.scene.balance().measure(moved).integrals["energy_branches"];
  std::printf("  energy of branches %.6e, changed by %.1e in a rotation\n", before, after / before - 1);
  EXPECT_NEAR(after, before, 1e-12 * before);
  EXPECT_GT(before, 1e-6);
}

}  // namespace softwet::testing_tools
