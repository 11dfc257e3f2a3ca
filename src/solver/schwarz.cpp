#include "solver/schwarz.hpp"

#include "field/vector.hpp"
#include "solver/colours.hpp"
#include "solver/dense_inverse.hpp"

namespace softwet {

namespace {

using Indices = Kokkos::View<const int*, Exec>;

/// One seed per unknown of a colour.
struct SeedColour {
  Indices colour;
  Array seed;
  int key;
  KOKKOS_FUNCTION void operator()(int i) const { seed(i) = colour(i) == key ? 1.0 : 0.0; }
};

/// Copies the columns of one colour from a product into the boxes' matrices.
template <int D>
struct CollectColumns {
  Indices colour, point, size, dof;
  ConstArray product;
  DenseBlocks blocks;
  int key, reach, unknowns;
  int period[3];  ///< 0: not periodic

  KOKKOS_FUNCTION bool couple(int a, int b) const {
    for (int d = 0; d < D; ++d) {
      int distance = point(3 * a + d) - point(3 * b + d);
      distance = distance < 0 ? -distance : distance;
      if (period[d] > 0 && 2 * distance > period[d]) distance = period[d] - distance;
      if (distance > reach) return false;
    }
    return true;
  }
  KOKKOS_FUNCTION void operator()(int item) const {
    const int box = item / unknowns, column = item % unknowns;
    if (column >= size(box)) return;
    const int source = dof(item);
    if (colour(source) != key) return;
    for (int row = 0; row < size(box); ++row) {
      const int target = dof(box * unknowns + row);
      blocks(box, row, column) = couple(source, target) ? static_cast<float>(product(target)) : 0.0f;
    }
  }
};

/// z on the core of a box = stored rows times r on the box. Rows are contiguous: lanes (host) or threads (device) take
/// neighbouring rows and walk along the columns together.
struct ApplyBoxes {
  Indices size, core, dof;
  DenseBlocks inverse;  ///< [box][column][core row]
  ConstArray r;
  Array z;
  int unknowns;
  static constexpr int rows_at_once = on_host ? 64 : 1;
  using Team = Kokkos::TeamPolicy<Exec>::member_type;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int box = team.league_rank(), n = size(box), m = core(box);
    const Scratch local(team.team_scratch(0), unknowns);
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n),
                         [&](int i) { local(i) = static_cast<float>(r(dof(box * unknowns + i))); });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, (m + rows_at_once - 1) / rows_at_once), [&](int chunk) {
      const int first = chunk * rows_at_once;
      float sum[rows_at_once] = {};
      for (int j = 0; j < n; ++j) {
        const float* column = &inverse(box, j, first);
        for (int i = 0; i < rows_at_once; ++i) sum[i] += column[i] * local(j);
      }
      for (int i = 0; i < rows_at_once && first + i < m; ++i) z(dof(box * unknowns + first + i)) = sum[i];
    });
  }
};

template <int D>
class Schwarz final : public Preconditioner {
 public:
  Schwarz(const Layout<D>& layout, const ConstArray& mask, SchwarzControl control)
      : seed_("schwarz.seed", layout.size()), product_("schwarz.product", layout.size()) {
    const std::vector<double> host_mask = to_host(mask);
    const PatchTables t = make_patches(layout, host_mask, control.core, control.overlap);
    const Colours c = make_colours(layout, host_mask);
    count_ = t.count;
    unknowns_ = t.unknowns;
    colours_ = c.count;
    reach_ = layout.axis[0].degree();
    for (int d = 0; d < 3; ++d) period_[d] = d < D && layout.axis[d].periodic() ? layout.axis[d].owned() : 0;
    size_ = to_device<Kokkos::View<int*, Exec>>(t.size);
    core_ = to_device<Kokkos::View<int*, Exec>>(t.core);
    dof_ = to_device<Kokkos::View<int*, Exec>>(t.dof);
    colour_ = to_device<Kokkos::View<int*, Exec>>(c.of);
    point_ = to_device<Kokkos::View<int*, Exec>>(c.point);
    blocks_ = DenseBlocks("schwarz.blocks", t.count, t.unknowns, t.unknowns);
    const int rows = (t.cores + ApplyBoxes::rows_at_once - 1) / ApplyBoxes::rows_at_once * ApplyBoxes::rows_at_once;
    inverse_ = DenseBlocks("schwarz.inverse", t.count, t.unknowns, rows);
  }

  void build(const Product& product) override {
    const Kokkos::RangePolicy<Exec> all(0, seed_.extent(0)), columns(0, count_ * unknowns_);
    for (int key = 0; key < colours_; ++key) {
      Kokkos::parallel_for("softwet::seed", all, SeedColour{colour_, seed_, key});
      product(seed_, product_);
      Kokkos::parallel_for("softwet::collect", columns,
                           CollectColumns<D>{colour_,
                                             point_,
                                             size_,
                                             dof_,
                                             product_,
                                             blocks_,
                                             key,
                                             reach_,
                                             unknowns_,
                                             {period_[0], period_[1], period_[2]}});
    }
    invert_core_rows(blocks_, size_, core_, inverse_);
  }

  void apply(const ConstArray& r, const Array& z) override {
    Kokkos::deep_copy(Exec(), z, 0.0);
    const std::size_t scratch = ApplyBoxes::Scratch::shmem_size(unknowns_);
    Kokkos::parallel_for("softwet::schwarz",
                         Kokkos::TeamPolicy<Exec>(count_, on_host ? 1 : 8, on_host ? 1 : 32)
                             .set_scratch_size(0, Kokkos::PerTeam(scratch)),
                         ApplyBoxes{size_, core_, dof_, inverse_, r, z, unknowns_});
  }

  std::string name() const override { return "schwarz"; }
  double bytes() const override { return 4.0 * (blocks_.size() + inverse_.size()); }

 private:
  int count_ = 0, unknowns_ = 0, colours_ = 0, reach_ = 0, period_[3] = {};
  Indices size_, core_, dof_, colour_, point_;
  DenseBlocks blocks_, inverse_;
  Array seed_, product_;
};

}  // namespace

template <int D>
std::unique_ptr<Preconditioner> make_schwarz(const Layout<D>& layout, const ConstArray& mask, SchwarzControl control) {
  return std::make_unique<Schwarz<D>>(layout, mask, control);
}

template std::unique_ptr<Preconditioner> make_schwarz<2>(const Layout<2>&, const ConstArray&, SchwarzControl);
template std::unique_ptr<Preconditioner> make_schwarz<3>(const Layout<3>&, const ConstArray&, SchwarzControl);

}  // namespace softwet
