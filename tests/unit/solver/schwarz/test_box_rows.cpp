// The matrices of boxes by both ways against the entries that a stencil has in their columns.
#include "solver/schwarz/box_rows.hpp"

#include "unit/scene/scenes.hpp"
#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

/// A level with random values, and its boxes.
template <int D>
struct BoxCase {
  const Layout<D>& layout;
  UnknownTable<D> table;
  Stencil<D> stencil;
  PatchTables t;
  StencilValues values;
  int width;

  BoxCase(const Layout<D>& l, const ConstArray& mask, int width_, int stride)
      : layout(l),
        table(l, to_host(mask)),
        stencil(l),
        t(make_patches(l, table, width_, stride)),
        values("values", stencil.size()),
        width(width_) {
    const auto host = Kokkos::create_mirror_view(values);
    std::mt19937 random(3);
    for (std::size_t i = 0; i < host.extent(0); ++i) host(i) = std::uniform_real_distribution<float>(-1, 1)(random);
    Kokkos::deep_copy(values, host);
  }

  /// All boxes, by fill(rows).
  template <class Fill>
  std::vector<float> filled(const Fill& fill) const {
    const auto on_device = [](const std::vector<int>& v) { return to_device<Kokkos::View<int*, Exec>>(v); };
    std::vector<int> all(t.count);
    for (int box = 0; box < t.count; ++box) all[box] = box;
    const DenseBlocks blocks("blocks", t.count, t.unknowns, t.unknowns);
    Kokkos::deep_copy(blocks, std::nanf(""));  // all entries have to be written
    const int round = layout.axis[0].periodic() ? layout.axis[0].owned() : 0;
    fill(BoxRows<D>{stencil, values, on_device(t.size), on_device(t.local), on_device(t.start), on_device(t.column),
                    on_device(all), blocks, t.sites, width, round});
    Kokkos::fence();
    const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), blocks);
    std::vector<float> entries;
    for (int box = 0; box < t.count; ++box)
      for (int i = 0; i < t.size[box]; ++i)
        for (int j = 0; j < t.size[box]; ++j) entries.push_back(host(box, i, j));
    return entries;
  }
  /// What for_column finds in the columns of a box's unknowns.
  std::vector<float> expected() const {
    const auto value = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), values);
    std::vector<float> entries;
    for (int box = 0; box < t.count; ++box) {
      const int n = t.size[box], *dof = t.dof.data() + std::size_t(box) * t.unknowns;
      std::vector<float> block(n * n);
      std::vector<int> local(layout.size(), -1);
      for (int i = 0; i < n; ++i) local[dof[i]] = i;
      for (int j = 0; j < n; ++j)
        for_column(stencil, table, dof[j], [&](int row, std::int64_t place) {
          if (local[row] >= 0) block[local[row] * n + j] += value(place);
        });
      entries.insert(entries.end(), block.begin(), block.end());
    }
    return entries;
  }
  void check() const {
    const std::vector<float> right = expected();
    ASSERT_GT(right.size(), 100u);
    const auto close = [&](const std::vector<float>& found, const char* way) {
      ASSERT_EQ(found.size(), right.size());
      for (std::size_t i = 0; i < right.size(); ++i) ASSERT_NEAR(found[i], right[i], 1e-6) << way << ", entry " << i;
    };
    close(filled([&](const BoxRows<D>& rows) {
            const FillRows<D> fill{rows, t.row};
            Kokkos::parallel_for("fill", Items(0, fill.items(t.count)), fill);
          }),
          "rows of boxes");
    close(filled([&](const BoxRows<D>& rows) { FillRowsByTeams<D>{rows}.run(t.count); }), "teams");
  }
};

TEST(BoxRows, AreThoseOfTheStencilIn2D) {
  for (const Case& c : {small_case(SceneKind::coupled), small_case(SceneKind::rigid, WallLaw::energy, true),
                        small_case(SceneKind::solid)})
    for (const auto& [width, stride] : {std::pair{3, 2}, {5, 3}, {8, 6}, {12, 12}}) {
      SCOPED_TRACE(testing::Message() << "width " << width);
      RandomScene s(c);
      BoxCase<2>(s.layout(), s.scene.mask(), width, stride).check();
    }
}

TEST(BoxRows, AreThoseOfTheStencilIn3D) {
  for (const Shape& shape : shapes_3d())
    for (const auto& [width, stride] : {std::pair{3, 2}, {4, 3}, {6, 6}}) {
      SCOPED_TRACE(testing::Message() << "width " << width);
      const RandomMatrix<3> r(shape);
      BoxCase<3>(r.layout, r.mask, width, stride).check();
    }
}

}  // namespace
}  // namespace softwet::testing_tools
