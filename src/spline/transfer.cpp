#include "spline/transfer.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

namespace softwet {
namespace {

/// Blossom of prod_k (x - root_k) at as many arguments: the mean over all pairings.
double blossom_of_product(const std::vector<double>& roots, const std::vector<double>& arguments) {
  std::vector<std::size_t> order(roots.size());
  std::iota(order.begin(), order.end(), 0);
  double sum = 0;
  int pairings = 0;
  do {
    double product = 1;
    for (std::size_t k = 0; k < roots.size(); ++k) product *= arguments[order[k]] - roots[k];
    sum += product;
    ++pairings;
  } while (std::next_permutation(order.begin(), order.end()));
  return sum / pairings;
}

/// The middle one of the elements in [low, high) on which a function lives; -1: there is none.
int element_of(const Axis& axis, int function, int low, int high) {
  std::vector<int> alive;
  for (int e = low; e < high; ++e)
    if (axis.span(e) <= function && function <= axis.span(e) + axis.degree()) alive.push_back(e);
  return alive.empty() ? -1 : alive[alive.size() / 2];
}

/// Blossom of the Lagrange polynomial that is 1 at points[a] and 0 at the others.
double blossom_of_lagrange(const std::vector<double>& points, std::size_t a, const std::vector<double>& arguments) {
  std::vector<double> roots;
  double scale = 1;
  for (std::size_t b = 0; b < points.size(); ++b)
    if (b != a) roots.push_back(points[b]), scale *= points[a] - points[b];
  return blossom_of_product(roots, arguments) / scale;
}

/// Products of the functions of `to` on an element of it with the functions of `from`, with the weight of `to`.
struct ElementProducts {
  Eigen::MatrixXd own;    ///< int N_a N_b w
  Eigen::MatrixXd mixed;  ///< int N_a M_j w, by function of `from`
  Eigen::VectorXd sums;   ///< int N_a w
};

/// The integrals are exact: the elements of `from` cut the element of `to` into parts.
ElementProducts products_on(const Axis& from, int from_low, int from_high, const Axis& to, int element) {
  const int n = to.degree() + 1;
  ElementProducts all{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, from.functions()),
                      Eigen::VectorXd::Zero(n)};
  const Gauss gauss(std::max(from.degree(), to.degree()) + 1);
  const double low = to.lower(element), high = low + to.size(element);
  for (int e = from_low; e < from_high; ++e) {
    // What sticks out of `from` by a rounding belongs to its last elements.
    const double begin = e == from_low ? low : std::max(low, from.lower(e));
    const double end = e == from_high - 1 ? high : std::min(high, from.lower(e + 1));
    for (std::size_t q = 0; q < gauss.point.size() && begin < end; ++q) {
      const double x = begin + (end - begin) * gauss.point[q], w = (end - begin) * gauss.weight[q] * to.weight(x);
      const std::vector<double> mine = to.values(element, x), theirs = from.values(e, x);
      for (int a = 0; a < n; ++a) {
        all.sums[a] += w * mine[a];
        for (int b = 0; b < n; ++b) all.own(a, b) += w * mine[a] * mine[b];
        for (int k = 0; k <= from.degree(); ++k) {
          const int function = from.span(e) + k;
          all.mixed(a, from.periodic() ? function % from.owned() : function) += w * mine[a] * theirs[k];
        }
      }
    }
  }
  return all;
}

/// The knots inside a function.
std::vector<double> knots_inside(const Axis& axis, int function) {
  const auto knot = axis.knots().begin() + function + 1;
  return {knot, knot + axis.degree()};
}

}  // namespace

std::vector<TransferRow> projection(const Axis& from, int from_low, int from_high, const Axis& to, int low, int high) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(to.owned(), from.functions());
  Eigen::VectorXd total = Eigen::VectorXd::Zero(to.owned());
  for (int e = low; e < high; ++e) {
    const ElementProducts on = products_on(from, from_low, from_high, to, e);
    const Eigen::MatrixXd best = on.own.ldlt().solve(on.mixed);
    for (int a = 0; a <= to.degree(); ++a) {
      const int i = (to.span(e) + a) % to.owned();
      sums.row(i) += on.sums[a] * best.row(a);
      total[i] += on.sums[a];
    }
  }
  std::vector<TransferRow> rows(to.functions());
  for (int i = 0; i < to.functions(); ++i)
    for (int j = 0; j < from.functions(); ++j)
      if (const double sum = sums(i % to.owned(), j); sum != 0)
        rows[i].function.push_back(j), rows[i].weight.push_back(sum / total[i % to.owned()]);
  return rows;
}

std::vector<TransferRow> from_samples(const Axis& axis, int low, int high) {
  std::vector<TransferRow> rows(axis.functions());
  for (int i = 0; i < axis.functions(); ++i) {
    const int function = axis.periodic() ? i % axis.owned() : i, element = element_of(axis, function, low, high);
    if (element < 0) continue;
    std::vector<double> points;
    for (int a = 0; a <= 2; ++a) points.push_back(axis.end_or_middle(2 * element + a));
    for (int a = 0; a <= 2; ++a) {
      rows[i].function.push_back(2 * (element - low) + a);
      rows[i].weight.push_back(blossom_of_lagrange(points, a, knots_inside(axis, function)));
    }
  }
  return rows;
}

}  // namespace softwet
