#include "solver/schwarz.hpp"

#include <optional>

#include "field/vector.hpp"
#include "solver/block_lu.hpp"
#include "solver/coarse_space.hpp"
#include "solver/dense_inverse.hpp"
#include "solver/patches.hpp"

namespace softwet {

namespace {

using Indices = Kokkos::View<const int*, Exec>;

/// One row of a box's matrix out of the stencil.
template <int D>
struct FillRow {
  Stencil<D> stencil;
  StencilValues values;
  Indices size, site, local, start;
  DenseBlocks blocks;
  int unknowns, sites, width;

  KOKKOS_FUNCTION void operator()(int item) const {
    const int box = item / unknowns, row = item % unknowns;
    if (row >= size(box)) return;
    for (int j = 0; j < unknowns; ++j) blocks(box, row, j) = 0;
    const int place = site(item), a = place % stencil.components;
    int point = 0, stride = 1, at[D];
    for (int d = 0, rest = place / stencil.components; d < D; ++d) {
      at[d] = rest % width;
      rest /= width;
      point += stride * stencil.moved(start(box * D + d), at[d], d);
      stride *= stencil.extent[d];
    }
    for (int o = 0; o < stencil.offsets; ++o) {
      int to = 0, step = 1;  // control point of the column in the box
      for (int d = 0; d < D; ++d) {
        // A box that goes all around a periodic axis closes on itself.
        const int i = wrapped(at[d] + stencil.shift(o, d), width, stencil.period[d]);
        to = i < 0 ? -1 : to < 0 ? -1 : to + step * i;
        step *= width;
      }
      if (to < 0) continue;
      for (int u = 0; u < stencil.components; ++u) {
        const int column = local(box * sites + to * stencil.components + u);
        if (column >= 0) blocks(box, row, column) += values(stencil.index(a, u, o, point));
      }
    }
  }
};

/// out = W_b A_b^-1 W_b r on every box. Rows are contiguous: lanes (host) or threads (device) take neighbouring rows
/// and walk along the columns together.
struct ApplyBoxes {
  Indices size, dof;
  DenseBlocks inverse;  ///< [box][column][row]
  Kokkos::View<const float*, Exec> weight;
  ConstArray r;
  Kokkos::View<float**, Kokkos::LayoutRight, Exec> out;
  int unknowns;
  static constexpr int rows_at_once = on_host ? 64 : 1;
  using Team = Kokkos::TeamPolicy<Exec>::member_type;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int box = team.league_rank(), n = size(box);
    const Scratch local(team.team_scratch(0), unknowns);
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), [&](int i) {
      const int unknown = dof(box * unknowns + i);
      local(i) = static_cast<float>(r(unknown)) * weight(unknown);
    });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, (n + rows_at_once - 1) / rows_at_once), [&](int chunk) {
      const int first = chunk * rows_at_once;
      float sum[rows_at_once] = {};
      for (int j = 0; j < n; ++j) {
        const float* column = &inverse(box, j, first);
        for (int i = 0; i < rows_at_once; ++i) sum[i] += column[i] * local(j);
      }
      for (int i = 0; i < rows_at_once && first + i < n; ++i) out(box, first + i) = sum[i];
    });
  }
};

/// Over a coarse space the boxes' answer is halved. Where several boxes hold an unknown their sum overshoots, and
/// amplifies what the coarse space adds to the residual, above all through the moving mesh, which the operator has and
/// the boxes' matrices have not (unit test: 27 iterations undamped, 8 so; 8 both ways with the matrix as operator).
constexpr float damping = 0.5f;

/// z += factor times what the boxes say of each unknown.
struct Collect {
  Indices grouped, place;
  Kokkos::View<const float*, Exec> weight;
  Kokkos::View<const float**, Kokkos::LayoutRight, Exec> out;
  Array z;
  int unknowns;
  float factor;
  KOKKOS_FUNCTION void operator()(int i) const {
    float sum = 0;
    for (int k = grouped(i); k < grouped(i + 1); ++k) sum += out(place(k) / unknowns, place(k) % unknowns);
    z(i) += factor * weight(i) * sum;
  }
};

template <int D>
class Schwarz final : public StencilSolver<D> {
 public:
  Schwarz(const Layout<D>& layout, const ConstArray& mask, SchwarzControl control) : width_(control.width) {
    const PatchTables t = make_patches(layout, UnknownTable<D>(layout, to_host(mask)), control.width, control.stride);
    count_ = t.count;
    unknowns_ = t.unknowns;
    sites_ = t.sites;
    padded_ = (t.unknowns + ApplyBoxes::rows_at_once - 1) / ApplyBoxes::rows_at_once * ApplyBoxes::rows_at_once;
    const auto to_view = [](const std::vector<int>& v) { return to_device<Kokkos::View<int*, Exec>>(v); };
    size_ = to_view(t.size);
    dof_ = to_view(t.dof);
    site_ = to_view(t.site);
    local_ = to_view(t.local);
    start_ = to_view(t.start);
    place_ = to_view(t.place);
    grouped_ = to_view(t.grouped);
    std::vector<float> weight(layout.size());
    for (int i = 0; i < layout.size(); ++i)
      weight[i] = t.grouped[i + 1] > t.grouped[i] ? 1 / std::sqrt(float(t.grouped[i + 1] - t.grouped[i])) : 0;
    weight_ = to_device<Kokkos::View<float*, Exec>>(weight);
    if (control.coarse) add_coarse(layout, mask, control);
  }

  void build(const StencilMatrix<D>& matrix) override {
    matrix_ = &matrix;
    if (blocks_.extent(0) == 0) allocate();
    Kokkos::parallel_for("softwet::boxes", Kokkos::RangePolicy<Exec>(0, count_ * unknowns_),
                         FillRow<D>{matrix.stencil(), matrix.values(), size_, site_, local_, start_, blocks_, unknowns_,
                                    sites_, width_});
    invert(blocks_, size_);
    if (!space_) return;
    coarse_matrix_->fill([&](const StencilValues& values) { space_->galerkin(matrix, values); });
    coarse_->build(*coarse_matrix_);
  }

  void set_operator(const Operator& product) override { product_ = product; }

  void apply(const ConstArray& r, const Array& z) override {
    if (!space_) {
      Kokkos::deep_copy(Exec(), z, 0.0);
      return add_boxes(r, z);
    }
    space_->restrict_to(r, coarse_r_);
    coarse_->apply(coarse_r_, coarse_z_);
    space_->prolong(coarse_z_, z);
    if (product_) {
      product_(z, rest_);
    } else {
      matrix_->multiply(z, rest_);
    }
    combine(rest_, -1, rest_, 0);
    add_scaled(rest_, 0, 1, r);
    add_boxes(rest_, z);
  }

  std::string name() const override { return "schwarz"; }
  double build_cost() const override { return D == 2 ? 25 : 50; }
  double bytes() const override {
    double total = 4.0 * count_ * (double(unknowns_) * padded_ + unknowns_);
    if (space_) total += coarse_matrix_->bytes() + coarse_->bytes() + space_->transient_bytes();
    return total;
  }

 private:
  void add_coarse(const Layout<D>& layout, const ConstArray& mask, const SchwarzControl& control) {
    space_.emplace(layout, mask, 4);
    if (!space_->exists()) return space_.reset();
    const Layout<D>& coarse = space_->layout();
    coarse_matrix_.emplace(coarse, space_->mask());
    coarse_ = coarse.size() <= control.direct_up_to ? make_block_lu<D>(coarse, space_->mask())
                                                    : make_schwarz<D>(coarse, space_->mask(), control);
    coarse_r_ = Array("schwarz.coarse_r", coarse.size());
    coarse_z_ = Array("schwarz.coarse_z", coarse.size());
    rest_ = Array("schwarz.rest", layout.size());
  }

  void allocate() {
    const auto uninitialised = Kokkos::view_alloc("schwarz.blocks", Kokkos::WithoutInitializing);
    blocks_ = DenseBlocks(uninitialised, count_, unknowns_, padded_);
    out_ = Kokkos::View<float**, Kokkos::LayoutRight, Exec>("schwarz.out", count_, unknowns_);
  }

  void add_boxes(const ConstArray& r, const Array& z) const {
    const std::size_t scratch = ApplyBoxes::Scratch::shmem_size(unknowns_);
    Kokkos::parallel_for("softwet::schwarz",
                         Kokkos::TeamPolicy<Exec>(count_, on_host ? 1 : 8, on_host ? 1 : 32)
                             .set_scratch_size(0, Kokkos::PerTeam(scratch)),
                         ApplyBoxes{size_, dof_, blocks_, weight_, r, out_, unknowns_});
    Kokkos::parallel_for("softwet::collect", Kokkos::RangePolicy<Exec>(0, z.extent(0)),
                         Collect{grouped_, place_, weight_, out_, z, unknowns_, space_ ? damping : 1});
  }

  int width_, count_ = 0, unknowns_ = 0, sites_ = 0, padded_ = 0;
  Indices size_, dof_, site_, local_, start_, place_, grouped_;
  Kokkos::View<const float*, Exec> weight_;
  DenseBlocks blocks_;  ///< matrices of the boxes, then [box][column][row] of their inverses
  Kokkos::View<float**, Kokkos::LayoutRight, Exec> out_;
  const StencilMatrix<D>* matrix_ = nullptr;
  Operator product_;
  std::optional<CoarseSpace<D>> space_;
  std::optional<StencilMatrix<D>> coarse_matrix_;
  std::unique_ptr<StencilSolver<D>> coarse_;
  Array coarse_r_, coarse_z_, rest_;
};

}  // namespace

template <int D>
std::unique_ptr<StencilSolver<D>> make_schwarz(const Layout<D>& layout, const ConstArray& mask,
                                               SchwarzControl control) {
  return std::make_unique<Schwarz<D>>(layout, mask, control);
}

template std::unique_ptr<StencilSolver<2>> make_schwarz<2>(const Layout<2>&, const ConstArray&, SchwarzControl);
template std::unique_ptr<StencilSolver<3>> make_schwarz<3>(const Layout<3>&, const ConstArray&, SchwarzControl);

}  // namespace softwet
