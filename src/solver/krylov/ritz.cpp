#include "solver/krylov/ritz.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace softwet {

std::vector<RitzValue> ritz_values(const std::vector<std::vector<double>>& columns) {
  const int n = static_cast<int>(columns.size());
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i <= std::min(j + 1, n - 1); ++i) h(i, j) = columns[j][i];
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(h);
  std::vector<RitzValue> result;
  if (solver.info() != Eigen::Success) return result;
  for (int k = 0; k < n; ++k) {
    const Eigen::VectorXcd y = solver.eigenvectors().col(k);
    result.push_back({solver.eigenvalues()[k], std::abs(columns[n - 1][n] * y[n - 1]) / y.norm()});
  }
  return result;
}

}  // namespace softwet
