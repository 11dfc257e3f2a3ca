#include "solver/direct/device/dense_solver.hpp"

#include <optional>

#include "memory/start_teams.hpp"
#include "solver/direct/device/gauss_jordan.hpp"

namespace softwet {

namespace {

using RowTable = Kokkos::View<const int*, Exec>;

/// Rows of the dense matrix out of the stencil. An item is a row.
template <int D>
struct FillDenseRows {
  Stencil<D> stencil;
  StencilValues values;
  RowTable component, point;  ///< [row]
  RowTable row_of;            ///< [component][control point] -1: none
  DenseBlocks a;

  KOKKOS_FUNCTION void operator()(int row) const {
    const int p = point(row), c = component(row), n = static_cast<int>(component.extent(0));
    for (int j = 0; j < n; ++j) a(0, row, j) = 0;
    for (int o = 0; o < stencil.offsets; ++o) {
      const int to = stencil.neighbour(p, o);
      if (to < 0) continue;
      for (int u = 0; u < stencil.components; ++u) {
        const int column = row_of(u * stencil.points + to);
        if (column >= 0 && stencil.couples(c, u)) a(0, row, column) += values(stencil.index(c, u, o, p));
      }
    }
  }
};

/// A team computes one entry of z.
struct MultiplyDense {
  DenseBlocks inverse;
  RowTable row_at, unknown;  ///< [entry of z] -1: prescribed; [row]
  ConstArray r;
  Array z;
  using Team = Kokkos::TeamPolicy<Exec>::member_type;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int entry = team.league_rank(), row = row_at(entry);
    double sum = 0;
    if (row >= 0)
      Kokkos::parallel_reduce(
          Kokkos::TeamVectorRange(team, static_cast<int>(unknown.extent(0))),
          [&](int j, double& part) { part += double(inverse(0, row, j)) * r(unknown(j)); }, sum);
    Kokkos::single(Kokkos::PerTeam(team), [&] { z(entry) = sum; });
  }
};

template <int D>
class DenseSolver final : public StencilSolver<D> {
 public:
  DenseSolver(const Layout<D>& layout, const ConstArray& mask) {
    const UnknownTable<D> table(layout, to_host(mask));
    const int points = layout.rows * layout.row_size;
    std::vector<int> component, point, unknown, row_at(layout.size(), -1);
    std::vector<int> row_of(std::size_t(layout.components()) * points, -1);
    for (int i = 0; i < layout.size(); ++i) {
      if (table.component(i) < 0) continue;
      row_at[i] = row_of[std::size_t(table.component(i)) * points + table.point(i)] = static_cast<int>(unknown.size());
      component.push_back(table.component(i));
      point.push_back(table.point(i));
      unknown.push_back(i);
    }
    rows_ = static_cast<int>(unknown.size());
    const auto view = [](const std::vector<int>& v) { return to_device<Kokkos::View<int*, Exec>>(v); };
    component_ = view(component);
    point_ = view(point);
    unknown_ = view(unknown);
    row_at_ = view(row_at);
    row_of_ = view(row_of);
    size_ = view({rows_});
  }

  void build(const StencilMatrix<D>& matrix) override {
    if (!invert_) {
      inverse_ = DenseBlocks(Kokkos::view_alloc("dense.inverse", Kokkos::WithoutInitializing), 1, rows_, rows_);
      invert_.emplace(1, rows_);
    }
    Kokkos::parallel_for("softwet::dense_rows", Items(0, rows_),
                         FillDenseRows<D>{matrix.stencil(), matrix.values(), component_, point_, row_of_, inverse_});
    invert_->invert(inverse_, size_);
  }
  void apply(const ConstArray& r, const Array& z) override {
    const int entries = static_cast<int>(z.extent(0));
    start_teams("softwet::dense_multiply", Teams<>(entries, 1, team_size(32)),
                MultiplyDense{inverse_, row_at_, unknown_, r, z});
  }
  std::string name() const override { return "dense"; }
  double bytes() const override { return 4.0 * rows_ * rows_ + GaussJordan::bytes(1, rows_); }
  double build_cost() const override { return 120; }
  bool recordable() const override { return true; }

 private:
  int rows_ = 0;
  RowTable component_, point_, unknown_, row_at_, row_of_, size_;
  DenseBlocks inverse_;
  std::optional<GaussJordan> invert_;
};

}  // namespace

template <int D>
std::unique_ptr<StencilSolver<D>> make_dense_solver(const Layout<D>& layout, const ConstArray& mask) {
  return std::make_unique<DenseSolver<D>>(layout, mask);
}

template std::unique_ptr<StencilSolver<2>> make_dense_solver<2>(const Layout<2>&, const ConstArray&);
template std::unique_ptr<StencilSolver<3>> make_dense_solver<3>(const Layout<3>&, const ConstArray&);

}  // namespace softwet
