#include "solver/sparse_lu.hpp"

#include "app/error.hpp"
#include "solver/stencil.hpp"

#ifdef SOFTWET_HAVE_UMFPACK
#include <Eigen/UmfPackSupport>
#endif

namespace softwet {

#ifdef SOFTWET_HAVE_UMFPACK

namespace {

template <int D>
class SparseLu final : public Preconditioner {
 public:
  SparseLu(const Layout<D>& layout, const ConstArray& mask)
      : matrix_(layout, mask), right_(matrix_.size()), solution_(matrix_.size()) {
    lu_.umfpackControl()[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    lu_.umfpackControl()[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;
    lu_.umfpackControl()[UMFPACK_IRSTEP] = 0;  // GMRES refines
  }

  void build(const Product& product) override {
    matrix_.fill(product);
    const Eigen::Map<const Eigen::SparseMatrix<double>> a(matrix_.size(), matrix_.size(), matrix_.values().size(),
                                                          matrix_.start().data(), matrix_.row().data(),
                                                          matrix_.values().data());
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
  double bytes() const override { return 12.0 * matrix_.values().size(); }

 private:
  StencilMatrix<D> matrix_;
  Eigen::UmfPackLU<Eigen::SparseMatrix<double>> lu_;
  Eigen::VectorXd right_, solution_;
  bool analysed_ = false;
};

}  // namespace

template <int D>
std::unique_ptr<Preconditioner> make_sparse_lu(const Layout<D>& layout, const ConstArray& mask) {
  return std::make_unique<SparseLu<D>>(layout, mask);
}

#else

template <int D>
std::unique_ptr<Preconditioner> make_sparse_lu(const Layout<D>&, const ConstArray&) {
  throw Error(Exit::invalid_input,
              "solver.krylov.preconditioner = umfpack: this build has no sparse direct solver; install SuiteSparse "
              "(Debian: libsuitesparse-dev) and rebuild, or choose \"lu\"");
}

#endif

template std::unique_ptr<Preconditioner> make_sparse_lu<2>(const Layout<2>&, const ConstArray&);
template std::unique_ptr<Preconditioner> make_sparse_lu<3>(const Layout<3>&, const ConstArray&);

}  // namespace softwet
