// Constants that kernels of a device read, against the loops over slots that they stand for.
#include "operator/packed.hpp"

#include <gtest/gtest.h>

#include "kernels/fluid/contact_angle.hpp"
#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/solid/graded.hpp"
#include "operator/device/tile_plan.hpp"

namespace softwet {
namespace {

TEST(Packed, GivesBackWhatWasPacked) {
  constexpr Packed squares = packed<4>([](int i) { return i * i; });
  for (int i = 0; i < 4; ++i) EXPECT_EQ(unpacked(squares, i), i * i);
  constexpr Packed sixteen = packed<16>([](int i) { return 15 - i; });
  for (int i = 0; i < 16; ++i) EXPECT_EQ(unpacked(sixteen, i), 15 - i);
}

/// Fields of a product: the slots, and behind them the tangents of the unknowns that some slot follows from, in their
/// order.
template <class Term, int D>
void check_fields(const char* name) {
  using Trial = typename Term::template Trial<double, D>;
  using Fields = TrialFields<Trial, D, true>;
  using Plan = TilePlan<TileShape<D, 2, 2, 2, 1, 1>, Term, NoMotion, true, double>;
  int field = Trial::slot_count, stored = 0;
  for (int s = 0; s < Trial::slot_count; ++s) {
    EXPECT_EQ(Fields::has_value(s), Trial::slot(s).value) << name << s;
    EXPECT_EQ(Fields::has_gradient(s), Trial::slot(s).gradient) << name << s;
    EXPECT_EQ(Fields::unknown_of_slot(s), Trial::slot(s).from.unknown(D)) << name << s;
    EXPECT_EQ(Plan::stored_before(s), stored) << name << s;
    stored += Trial::slot(s).gradient ? 1 : 0;
  }
  for (int u = 0; u < D + 2; ++u) {
    bool value = false, gradient = false;
    for (int s = 0; s < Trial::slot_count; ++s) {
      if (Trial::slot(s).from.unknown(D) != u) continue;
      value = value || Trial::slot(s).value;
      gradient = gradient || Trial::slot(s).gradient;
    }
    EXPECT_EQ(Fields::reads_unknown(u), value || gradient) << name << u;
    if (!value && !gradient) continue;
    EXPECT_EQ(Fields::tangent_of(u), field) << name << u;
    EXPECT_EQ(Fields::unknown_of(field), u) << name << u;
    EXPECT_EQ(Fields::has_value(field), value) << name << u;
    EXPECT_EQ(Fields::has_gradient(field), gradient) << name << u;
    EXPECT_EQ(Plan::stored_before(field), stored) << name << u;
    stored += gradient ? 1 : 0;
    ++field;
  }
  EXPECT_EQ(Fields::fields, field) << name;
  EXPECT_EQ(Plan::stored, stored) << name;
}

TEST(Packed, FieldsOfTerms) {
  check_fields<NavierStokesKorteweg, 2>("fluid, plane");
  check_fields<NavierStokesKorteweg, 3>("fluid, space");
  check_fields<Elastodynamics<SaintVenantKirchhoff>, 2>("solid, plane");
  check_fields<GradedSolid, 3>("graded solid, space");
  check_fields<CapillaryTraction, 3>("traction, space");
  check_fields<EnergyWall, 3>("wall, space");
}

}  // namespace
}  // namespace softwet
