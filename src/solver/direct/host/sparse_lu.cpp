#include "solver/direct/host/sparse_lu.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "case/error.hpp"
#include "solver/direct/host/block_lu.hpp"

#ifdef SOFTWET_HAVE_UMFPACK
#include <Eigen/UmfPackSupport>
#endif

namespace softwet {

#ifdef SOFTWET_HAVE_UMFPACK

namespace {

/// Eigen reports every failure as "numerical issue", and its solve reports none; here is what UMFPACK says.
class Umfpack : public Eigen::UmfPackLU<Eigen::SparseMatrix<double>> {
 public:
  /// Of the last analysis or factorisation.
  int status() const { return m_fact_errorCode; }
  /// False, and x is not a solution, where the factors are singular.
  bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const { return _solve_impl(b, x); }
  /// After a factorisation.
  double factor_bytes() const { return m_umfpackInfo[UMFPACK_NUMERIC_SIZE] * m_umfpackInfo[UMFPACK_SIZE_OF_UNIT]; }
};

/// Throws what UMFPACK's status means. A singular matrix is not a failure of the library: apply reports it.
void require_success(int status) {
  if (status == UMFPACK_OK || status == UMFPACK_WARNING_singular_matrix) return;
  if (status == UMFPACK_ERROR_out_of_memory)
    throw Error(Exit::machine_failed,
                "solver.krylov.preconditioner = \"umfpack\": no memory for the sparse LU factors of the Jacobian; "
                "choose \"schwarz\", take fewer elements, or a machine with more memory");
  throw Error(Exit::computation_failed,
              "solver.krylov.preconditioner = \"umfpack\": UMFPACK cannot factorise the Jacobian (its status is " +
                  std::to_string(status) + "); choose \"lu\" or \"schwarz\"");
}

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
    factor_bytes_ = 8 * factor_entries(dissect(layout, table, D == 2 ? 40 : 64));
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
      require_success(lu_.status());
      analysed_ = true;
    }
    lu_.factorize(a);
    require_success(lu_.status());
    factor_bytes_ = lu_.factor_bytes();
  }

  void apply(const ConstArray& r, const Array& z) override {
    Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> b(right_.data(), right_.size());
    Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> x(solution_.data(),
                                                                                        solution_.size());
    Kokkos::deep_copy(b, r);
    if (!lu_.solve(right_, solution_)) solution_.setConstant(std::numeric_limits<double>::quiet_NaN());
    Kokkos::deep_copy(z, x);
  }

  std::string name() const override { return "umfpack"; }
  double build_cost() const override { return D == 2 ? 25 : 55; }
  /// Before the first build the factors are those of block LU in double precision. UMFPACK orders and pivots by itself:
  /// while it factorises it was measured to hold 1.0 to 1.6 times as much in 2D.
  double bytes() const override { return factor_bytes_ + 12.0 * values_.size() + sizeof(Place) * places_.size(); }

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
  Umfpack lu_;
  Eigen::VectorXd right_, solution_;
  double factor_bytes_ = 0;
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
