#include "solver/direct/device/level_lu.hpp"

#include <algorithm>
#include <optional>

#include "memory/start_teams.hpp"
#include "solver/direct/device/gauss_jordan.hpp"
#include "solver/direct/device/level_apply.hpp"
#include "solver/direct/device/level_scale.hpp"

namespace softwet {

namespace {

/// Control points of a leaf: with fewer there are more levels, with more the factors grow.
constexpr int leaf_of_levels = 64;

template <class T>
Kokkos::View<T*, Exec> list_on_device(const char* name, const std::vector<T>& values) {
  return to_device<Kokkos::View<T*, Exec>>(values, name);
}

template <int D>
class LevelLu final : public StencilSolver<D> {
 public:
  LevelLu(const Layout<D>& layout, const ConstArray& mask, int threads)
      : LevelLu(layout, UnknownTable<D>(layout, to_host(mask)), threads) {}

  void build(const StencilMatrix<D>& matrix) override {
    if (factors_.extent(0) == 0) allocate();
    scale_.compute(matrix.values());
    const ScaledEntries<D> entries{matrix.stencil(), matrix.values(), place_, scale_.row(), scale_.column()};
    for (int depth = static_cast<int>(levels_.size()) - 1; depth >= 0; --depth) {
      const TreeLevel& level = levels_[depth];
      const LevelNumbers here = memory_[depth % 2], below = memory_[1 - depth % 2];
      const Teams<> columns((level.last - level.first) * level.rows, team_size(4), lanes);
      start_teams("softwet::assemble_fronts", columns,
                  AssembleFronts<D>{entries, fronts_, unknown_, inherited_, here, below, level.first, level.rows});
      const auto some = Kokkos::make_pair(level.first, level.last);
      elimination_->eliminate({here.data(), Kokkos::subview(begin_, some), Kokkos::subview(stride_, some)},
                              Kokkos::subview(own_, some), Kokkos::subview(size_, some), level.rows, level.pivots,
                              threads_);
      start_teams("softwet::keep_factors", columns, KeepFactors{fronts_, here, factors_, level.first, level.rows});
    }
  }

  void apply(const ConstArray& r, const Array& z) override { multiply<double>(r, z, {}); }
  void answer(const ConstArray& r, const Array& z, const RangeFactors& factors) override {
    multiply<double>(r, z, factors);
  }
  void answer(const ConstArrayOf<float>& r, const ArrayOf<float>& z, const RangeFactors& factors) override {
    multiply<float>(r, z, factors);
  }

  std::string name() const override { return "lu"; }
  double build_cost() const override { return D == 2 ? 35 : 90; }
  bool recordable() const override { return true; }
  double bytes() const override {
    const double lists = sizeof(LevelFront) * fronts_.extent(0) + 4.0 * (unknown_.extent(0) + inherited_.extent(0)) +
                         sizeof(LevelStrip) * (forward_.extent(0) + backward_.extent(0)) +
                         sizeof(LevelPlace<D>) * place_.extent(0) + 20.0 * own_.extent(0) + 4.0 * held_.extent(0);
    const double vectors = 4.0 * (unknown_.extent(0) + place_.extent(0));
    return lists + vectors + scale_.bytes() + 4.0 * (factor_entries_ + entries_[0] + entries_[1]) +
           GaussJordan::bytes(rows_of_level_);
  }

 private:
  using Strips = Kokkos::View<LevelStrip*, Exec>;
  static constexpr int lanes = team_size(32);

  LevelLu(const Layout<D>& layout, const UnknownTable<D>& table, int threads)
      : threads_(threads), scale_(layout, table) {
    const LevelTree tree = make_level_tree(dissect(layout, table, leaf_of_levels));
    levels_ = tree.levels;
    factor_entries_ = tree.factor_entries;
    for (std::size_t depth = 0; depth < levels_.size(); ++depth) {
      const TreeLevel& level = levels_[depth];
      entries_[depth % 2] = std::max(entries_[depth % 2], level.entries);
      rows_of_level_ = std::max(rows_of_level_, std::int64_t(level.last - level.first) * level.rows);
    }
    fronts_ = list_on_device("lu.fronts", tree.fronts);
    forward_ = list_on_device("lu.forward", tree.forward);
    backward_ = list_on_device("lu.backward", tree.backward);
    unknown_ = list_on_device("lu.unknown", tree.unknown);
    inherited_ = list_on_device("lu.inherited", tree.inherited);
    std::vector<int> own, size, stride, held;
    std::vector<std::int64_t> begin;
    for (const LevelFront& f : tree.fronts) {
      own.push_back(f.own);
      size.push_back(f.size);
      stride.push_back(f.stride());
      begin.push_back(f.matrix);
    }
    own_ = list_on_device("lu.own", own);
    size_ = list_on_device("lu.size", size);
    stride_ = list_on_device("lu.stride", stride);
    begin_ = list_on_device("lu.begin", begin);
    const Stencil<D> stencil(layout);
    std::vector<LevelPlace<D>> place(layout.size());
    for (int i = 0; i < layout.size(); ++i) {
      place[i].component = table.component(i);
      if (table.component(i) < 0) held.push_back(i);
      for (int d = 0; d < D && table.component(i) >= 0; ++d) place[i].at[d] = stencil.coordinate(table.point(i), d);
    }
    held_ = list_on_device("lu.held", held);
    place_ = list_on_device("lu.place", place);
  }

  void allocate() {
    const auto fresh = [](const std::string& label) { return Kokkos::view_alloc(label, Kokkos::WithoutInitializing); };
    factors_ = LevelNumbers("lu.factors", factor_entries_ + LevelStrip::rows);  // strips read whole lanes
    for (int parity = 0; parity < 2; ++parity) memory_[parity] = LevelNumbers(fresh("lu.level"), entries_[parity]);
    results_ = LevelNumbers(fresh("lu.results"), unknown_.extent(0));
    solution_ = LevelNumbers(fresh("lu.solution"), place_.extent(0));
    elimination_.emplace(rows_of_level_);
  }

  template <class Real>
  void multiply(const ConstArrayOf<Real>& r, const ArrayOf<Real>& z, const RangeFactors& factors) const {
    const LevelVectors<Real> v{fronts_,  unknown_,  inherited_, factors_, scale_.row(), scale_.column(),
                               results_, solution_, r,          z,        factors};
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level)
      run("softwet::lu_forward", level->pivots, level->last_forward - level->first_forward, [&](int parts) {
        return ForwardStrips<Real>{v, part_of(forward_, level->first_forward, level->last_forward), parts};
      });
    for (const TreeLevel& level : levels_) {
      BackwardStrips<Real> back{v, part_of(backward_, level.first_backward, level.last_backward), 0, {}};
      if (&level == &levels_.back()) back.held = held_;
      run("softwet::lu_backward", level.border, back.teams(), [&](int parts) {
        back.parts = parts;
        return back;
      });
    }
  }

  static Strips part_of(const Strips& strips, int first, int last) {
    return Kokkos::subview(strips, Kokkos::make_pair(first, last));
  }

  /// One team for each strip or piece. Columns are dealt out to so many sums as keep the memory busy and leave each one
  /// some.
  template <class Kernel>
  void run(const char* label, int columns, int teams, const Kernel& kernel) const {
    if (teams == 0) return;
    const int parts = columns > 256 ? 16 : 8, threads = threads_ > 0 ? threads_ : team_size(parts);
    start_teams(label,
                Teams<>(teams, threads, StripProduct::lanes)
                    .set_scratch_size(0, Kokkos::PerTeam(StripProduct::scratch_bytes(parts))),
                kernel(parts));
  }

  int threads_;
  LevelScale<D> scale_;
  std::vector<TreeLevel> levels_;  ///< root first
  std::int64_t factor_entries_ = 0;
  std::int64_t entries_[2] = {0, 0};  ///< of the fronts of a level, of even and of odd depth
  std::int64_t rows_of_level_ = 0;    ///< fronts times rows of the largest one
  Kokkos::View<LevelFront*, Exec> fronts_;
  Strips forward_, backward_;
  Kokkos::View<int*, Exec> unknown_, inherited_;
  Kokkos::View<int*, Exec> own_, size_, stride_;  ///< [front]
  Kokkos::View<std::int64_t*, Exec> begin_;       ///< [front]
  Kokkos::View<int*, Exec> held_;                 ///< prescribed values and ghosts
  Kokkos::View<LevelPlace<D>*, Exec> place_;
  LevelNumbers factors_, results_, solution_;
  LevelNumbers memory_[2];  ///< of fronts, by the parity of their depth
  std::optional<GaussJordan> elimination_;
};

}  // namespace

template <int D>
std::unique_ptr<StencilSolver<D>> make_level_lu(const Layout<D>& layout, const ConstArray& mask, int threads) {
  return std::make_unique<LevelLu<D>>(layout, mask, threads);
}

template std::unique_ptr<StencilSolver<2>> make_level_lu<2>(const Layout<2>&, const ConstArray&, int);
template std::unique_ptr<StencilSolver<3>> make_level_lu<3>(const Layout<3>&, const ConstArray&, int);

}  // namespace softwet
