#include "solver/sparse_lu.hpp"

#include <algorithm>
#include <limits>

#include "app/error.hpp"

#ifdef SOFTWET_HAVE_UMFPACK
#include <Eigen/UmfPackSupport>
#endif

namespace softwet {

#ifdef SOFTWET_HAVE_UMFPACK

namespace {

template <int D>
class SparseLu final : public StencilSolver<D> {
 public:
  SparseLu(const Layout<D>& layout, const ConstArray& mask) : right_(layout.size()), solution_(layout.size()) {
    lu_.umfpackControl()[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    lu_.umfpackControl()[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;
    lu_.umfpackControl()[UMFPACK_IRSTEP] = 0;  // GMRES refines
    const Stencil<D> stencil(layout);
    const UnknownTable<D> table(layout, to_host(mask));
    if (stencil.size() > std::numeric_limits<int>::max())
      throw Error(Exit::invalid_input,
                  "solver.krylov.preconditioner: a matrix of this mesh may have more entries than \"umfpack\" can "
                  "number (2147483647); choose \"schwarz\" or take fewer elements");
    for (int i = 0; i < layout.size(); ++i) add_column(stencil, table, i);
    start_.push_back(static_cast<int>(row_.size()));
    values_.assign(row_.size(), 1.0);
  }

  void build(const StencilMatrix<D>& matrix) override {
    const auto entry = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), matrix.values());
    for (const Place& p : places_) values_[p.to] = 0;
    for (const Place& p : places_) values_[p.to] += entry(p.from);
    const int n = static_cast<int>(right_.size());
    const Eigen::Map<const Eigen::SparseMatrix<double>> a(n, n, values_.size(), start_.data(), row_.data(),
                                                          values_.data());
    if (!analysed_) {
      lu_.analyzePattern(a);
      analysed_ = true;
    }
    lu_.factorize(a);
    if (lu_.info() != Eigen::Success)
      throw Error(Exit::computation_failed, "the Jacobian is singular: its sparse LU factorisation failed");
  }

  void apply(const ConstArray& r, const Array& z) override {
    Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> b(right_.data(), right_.size());
    Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> x(solution_.data(),
                                                                                        solution_.size());
    Kokkos::deep_copy(b, r);
    solution_ = lu_.solve(right_);
    Kokkos::deep_copy(z, x);
  }

  std::string name() const override { return "umfpack"; }
  double build_cost() const override { return D == 2 ? 25 : 60; }
  double bytes() const override { return 12.0 * values_.size() + sizeof(Place) * places_.size(); }

 private:
  struct Place {
    std::int64_t from;  ///< index into the values of the stencil
    int to;             ///< index into values_
  };

  /// Rows ascend; prescribed values and ghosts are identity.
  void add_column(const Stencil<D>& stencil, const UnknownTable<D>& table, int column) {
    start_.push_back(static_cast<int>(row_.size()));
    if (table.component(column) < 0) {
      row_.push_back(column);
      return;
    }
    std::vector<std::pair<int, std::int64_t>> entries;
    for_column(stencil, table, column, [&](int row, std::int64_t value) { entries.emplace_back(row, value); });
    std::sort(entries.begin(), entries.end());
    for (const auto& [row, value] : entries) {
      if (static_cast<int>(row_.size()) == start_.back() || row_.back() != row) row_.push_back(row);
      places_.push_back({value, static_cast<int>(row_.size()) - 1});
    }
  }

  std::vector<int> start_, row_;  ///< compressed columns
  std::vector<double> values_;
  std::vector<Place> places_;
  Eigen::UmfPackLU<Eigen::SparseMatrix<double>> lu_;
  Eigen::VectorXd right_, solution_;
  bool analysed_ = false;
};

}  // namespace

template <int D>
std::unique_ptr<StencilSolver<D>> make_sparse_lu(const Layout<D>& layout, const ConstArray& mask) {
  return std::make_unique<SparseLu<D>>(layout, mask);
}

#else

template <int D>
std::unique_ptr<StencilSolver<D>> make_sparse_lu(const Layout<D>&, const ConstArray&) {
  throw Error(Exit::invalid_input,
              "solver.krylov.preconditioner = umfpack: this build has no sparse direct solver; install SuiteSparse "
              "(Debian: libsuitesparse-dev) and rebuild, or choose \"lu\"");
}

#endif

template std::unique_ptr<StencilSolver<2>> make_sparse_lu<2>(const Layout<2>&, const ConstArray&);
template std::unique_ptr<StencilSolver<3>> make_sparse_lu<3>(const Layout<3>&, const ConstArray&);

}  // namespace softwet
