// The search for faults of a mesh against the search of all points: a bound from control values excludes them only where
// there are none.
#include "scene/fault_search.hpp"

#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

struct Found {
  bool excluded;
  MeshFaults faults, expected;
};

template <int D>
struct Searches {
  RandomSceneIn<D> random;
  SlopeBound<D, 2> bound;
  FaultSearch<D, 2> search;
  std::vector<double> shape;

  explicit Searches(const Case& c)
      : random(c),
        bound(random.scene.regions()),
        search(random.scene.regions(), random.scene.balance()),
        shape(to_host(random.stage().displacement)) {
    double largest = 0;
    for (const double u : shape) largest = std::max(largest, std::abs(u));
    for (double& u : shape) u /= largest;
  }

  /// With displacements of this size.
  Found at(double size) {
    std::vector<double> u = shape;
    for (double& x : u) x *= size;
    return of(u);
  }
  Found of(const std::vector<double>& u) {
    Kokkos::deep_copy(random.stage().displacement, to_device<Array>(u));
    const Array numbers("numbers", search.numbers());
    search.ask(random.stage(), numbers);
    const std::vector<double> on_host = to_host(numbers);
    return {bound.excludes_faults(on_host.data()), search.take(random.stage(), on_host.data()),
            random.scene.balance().faults(random.stage())};
  }
};

void expect_right(const Found& found, double size) {
  EXPECT_EQ(found.faults.folded, found.expected.folded) << size;
  EXPECT_EQ(found.faults.inverted, found.expected.inverted) << size;
  if (!found.excluded) return;
  EXPECT_EQ(found.expected.folded, 0) << size;
  EXPECT_EQ(found.expected.inverted, 0) << size;
}

/// Random displacements of sizes from far too small for a fault to far too large.
template <int D>
void expect_right(const Case& c) {
  Searches<D> searches(c);
  int excluded = 0, faults = 0;
  for (double size = 1e-4; size < 2; size *= 1.3) {
    const Found found = searches.at(size);
    expect_right(found, size);
    excluded += found.excluded;
    faults += found.expected.inverted > 0 || found.expected.folded > 0;
  }
  EXPECT_GT(excluded, 5);
  EXPECT_GT(faults, 5);
}

TEST(FaultSearch, ExcludesFaultsOnlyWhereThereAreNone) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::solid}) {
    expect_right<2>(small_case(kind));
    expect_right<2>(small_case(kind, WallLaw::gradient, true));
    expect_right<2>(axisymmetric(small_case(kind)));
    expect_right<3>(small_case_in_3d(kind));
  }
}

// One control point moves along one axis: a fault begins where the bound is close to its limit, and the search finds
// what lies between.
TEST(FaultSearch, FindsASingleFault) {
  Searches<2> searches(small_case(SceneKind::coupled));
  const Layout<2>& l = searches.random.layout();
  for (int component = 0; component < 2; ++component)
    for (const int row : {1, l.wall_row})
      for (int column = 1; column + 1 < l.row_size; ++column) {
        const int at = l.displacement_offset(component) + row * l.row_size + column;
        bool excluded_one = false, found_one = false;
        for (double size = 0.005; size < 1; size *= 1.1)
          for (const double sign : {-1.0, 1.0}) {
            std::vector<double> u(searches.shape.size(), 0.0);
            u[at] = sign * size;
            const Found found = searches.of(u);
            expect_right(found, sign * size);
            excluded_one = excluded_one || found.excluded;
            found_one = found_one || found.faults.inverted > 0 || found.faults.folded > 0;
          }
        EXPECT_TRUE(excluded_one);
        EXPECT_TRUE(found_one || component == 0) << row << ", " << column;
      }
}

TEST(FaultSearch, DoesNotExcludeWhatIsNoNumber) {
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Searches<3> searches(small_case_in_3d(SceneKind::coupled));
    std::vector<double> u(searches.shape.size(), 0.0);
    EXPECT_TRUE(searches.of(u).excluded);
    for (const std::size_t i : {std::size_t(0), u.size() / 2, u.size() - 1}) {
      u[i] = wrong;
      EXPECT_FALSE(searches.of(u).excluded) << i;
      u[i] = 0;
    }
  }
}

// In (r, z) the hoop u_r / r counts too: a displacement of the axis itself is never excluded.
TEST(FaultSearch, DoesNotExcludeAMotionOfTheAxisOfSymmetry) {
  Searches<2> searches(axisymmetric(small_case(SceneKind::solid)));
  std::vector<double> u(searches.shape.size(), 0.0);
  u[searches.random.layout().row_size] = -1e-9;
  EXPECT_FALSE(searches.of(u).excluded);
}

}  // namespace
}  // namespace softwet::testing_tools
