// Integrals of the state by the columns of history.csv.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

#include "kernels/functional/columns.hpp"

namespace softwet {

/// Scales: energies a b^2 L0^D, mass b L0^D, volume L0^D; in the coordinates (r, z) L0^3 replaces L0^D.
/// The columns and their parts are in kernels/functional/columns.hpp.
/// Tested: tests/unit/scene/test_integrals.cpp
class Integrals {
 public:
  /// Whether a column is one of these integrals, or a sum of some.
  static constexpr bool has(std::string_view column) {
    return std::any_of(std::begin(integral_columns), std::end(integral_columns),
                       [&](const IntegralColumn& one) { return belongs(one.name, column); });
  }

  /// A column that is no sum, or a part of one. Throws std::logic_error where there is none.
  double& part(std::string_view name) { return values_[place(name)]; }
  /// Sum of the parts of a column. Throws std::logic_error where there are none.
  double operator[](std::string_view column) const {
    if (!has(column)) throw std::logic_error("no integral belongs to the column '" + std::string(column) + "'");
    return sum(column, [](double value) { return value; });
  }
  double energy() const { return (*this)["energy"]; }
  double dissipation() const { return (*this)["dissipation"]; }
  /// Sum of the sizes of the energies, of which the round-off of their sum is a part.
  double size() const {
    return sum("energy", [](double value) { return std::abs(value); });
  }

  /// Adds the integrals of a functional (kernels/functional) to the parts that it names. Another name does not compile.
  template <class Functional>
  void add(const std::array<double, Functional::count>& integrals) {
    constexpr std::array<std::size_t, Functional::count> at = places<Functional>();
    for (int k = 0; k < Functional::count; ++k) values_[at[k]] += integrals[k];
  }

  /// Turns integrals for each radian about an axis into integrals of a whole turn. The radial momentum cancels.
  void turn(double angle) {
    for (double& value : values_) value *= angle;
    part("momentum_x") = 0;
  }

 private:
  static constexpr std::size_t place(std::string_view part) {
    for (std::size_t i = 0; i < std::size(integral_columns); ++i)
      if (integral_columns[i].name == part && !is_sum(part)) return i;
    throw std::logic_error("there is no integral '" + std::string(part) + "'");
  }
  template <class Functional>
  static constexpr std::array<std::size_t, Functional::count> places() {
    std::array<std::size_t, Functional::count> all{};
    for (int k = 0; k < Functional::count; ++k) all[k] = place(Functional::column(k));
    return all;
  }
  template <class Map>
  double sum(std::string_view column, const Map& map) const {
    double sum = 0;
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (belongs(integral_columns[i].name, column)) sum += map(values_[i]);
    return sum;
  }

  std::array<double, std::size(integral_columns)> values_{};  ///< 0 of sums
};

}  // namespace softwet
