// What a run keeps in memory, part by part.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "case/precision.hpp"
#include "operator/device/tile_shape.hpp"
#include "solver/preconditioner.hpp"

namespace softwet {

/// The part that does not grow with the case.
constexpr const char* program_part = "program and libraries";

/// Partial sums of the tiles of a device, for each control value of an evaluation: tiles overlap in their control points.
template <int D>
double sums_of_tiles(int degree, int points) {
  const auto of = []<class Tile>(Tile) { return double(Tile::controls) / (Tile::NX * Tile::NY * Tile::NZ); };
  if (points <= degree) return degree == 2 ? of(SlopeTileShape<D, 2, 2>()) : of(SlopeTileShape<D, 3, 3>());
  return degree == 2 ? of(ChosenTile<D, 2, false, double>()) : of(ChosenTile<D, 3, false, double>());
}

/// Name and bytes of each part. The preconditioner counts what it will hold once it is built. Explicit schemes
/// have none.
template <int D>
std::vector<std::pair<std::string, double>> memory_parts(const Case& c, const Layout<D>& l,
                                                         const Preconditioner* preconditioner) {
  const double n = l.size(), rate = l.rate_size(), solid = l.solid_size(), scalar = l.scalar_size();
  const double lag = l.branches > 0 ? l.branch_size() : 0;
  const double state = n + rate + 2 * solid + 2 * scalar + 2 * l.memory_size() + 2 * lag;
  const double stage = n + rate + 2 * solid + scalar + lag;
  std::vector<std::pair<std::string, double>> parts{{program_part, 34.0 * 1048576},
                                                    {"state and history", 8 * (state + 3 * n)}};
  const bool mixed = precision_of(c) != Precision::full;
  if (!host_algorithms)
    parts.push_back(
        {"sums of tiles", (mixed ? 12 : 8) * sums_of_tiles<D>(l.axis[0].degree(), c.domain.points()) * (n + scalar)});
  if (preconditioner) {
    // Rounded stages: one for products in single precision, and one for the last build, for a checkpoint.
    const int rounded = (mixed ? 1 : 0) + (preconditioner->name() == "none" ? 0 : 1);
    const double friction = l.rate_rows > 0 ? 20 * n : 0;  // what Newton's method knows of it, and a mass
    const double work = 8 * n + friction;
    parts.insert(parts.end(), {{"stage", (8 + 4 * rounded) * stage + work},
                               {"Newton", 8 * (mixed ? 6 : 5) * n},
                               {"Krylov basis", (mixed ? 4 : 8) * n * (2.0 * c.solver.krylov_restart + 2)},
                               {"preconditioner " + preconditioner->name(), preconditioner->bytes()}});
  } else {
    constexpr double stages = 7, masses = 9;  // vectors, as many as the scheme kick_drift has
    parts.push_back({"stages and masses", 8 * (stages * (rate + solid + scalar) + masses * n)});
  }
  return parts;
}

template <int D>
double total_bytes(const Case& c, const Layout<D>& layout, const Preconditioner* preconditioner) {
  double total = 0;
  for (const auto& [name, bytes] : memory_parts(c, layout, preconditioner)) total += bytes;
  return total;
}

}  // namespace softwet
