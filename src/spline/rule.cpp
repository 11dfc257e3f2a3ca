#include "spline/rule.hpp"

#include <numeric>

namespace softwet {

namespace {

enum class Weigh { length, point };
Living at_point(const Axis& axis, int e, double x) { return {axis.values(e, x), axis.slopes(e, x)}; }

/// Points on each element as fractions of it, with weights per unit length (or for each point of a trace).
/// @param tables  of the functions of an element, for a point of it
template <class Of = decltype(&at_point)>
AxisRule tabulate(const Axis& axis, const std::vector<int>& elements, const std::vector<double>& fraction,
                  const std::vector<double>& weight, Weigh weigh = Weigh::point, const Of& tables = at_point) {
  const int n = axis.degree() + 1, q = static_cast<int>(fraction.size()), count = static_cast<int>(elements.size());
  const int padded = count + lane_padding;
  Kokkos::View<double***, Kokkos::LayoutRight, Exec> value("value", q, n, padded), slope("slope", q, n, padded);
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> weights("weight", q, padded), position("position", q, padded);
  Kokkos::View<double*, Exec> shares("share", padded);
  Kokkos::View<int*, Exec> spans("first", padded);
  auto v = Kokkos::create_mirror_view(value), s = Kokkos::create_mirror_view(slope);
  auto w = Kokkos::create_mirror_view(weights), x = Kokkos::create_mirror_view(position);
  auto f = Kokkos::create_mirror_view(spans);
  auto share = Kokkos::create_mirror_view(shares);
  for (int l = 0; l < padded; ++l) {
    const int e = elements[std::min(l, count - 1)];
    const double length = axis.size(e);
    f(l) = axis.span(e);
    share(l) = axis.spacing() / length;
    for (int p = 0; p < q; ++p) {
      x(p, l) = axis.lower(e) + length * fraction[p];
      w(p, l) = l >= count ? 0.0 : weigh == Weigh::length ? weight[p] * length : weight[p];
      const Living living = tables(axis, e, x(p, l));
      for (int a = 0; a < n; ++a) {
        v(p, a, l) = living.values[a];
        s(p, a, l) = living.slopes[a];
      }
    }
  }
  Kokkos::deep_copy(value, v);
  Kokkos::deep_copy(slope, s);
  Kokkos::deep_copy(weights, w);
  Kokkos::deep_copy(position, x);
  Kokkos::deep_copy(spans, f);
  Kokkos::deep_copy(shares, share);
  return {value, slope, weights, position, shares, spans, count, q, axis.spacing()};
}

std::vector<int> range(int first, int last) {
  std::vector<int> elements(last - first);
  std::iota(elements.begin(), elements.end(), first);
  return elements;
}

AxisRule gauss_rule(const Axis& axis, const std::vector<int>& elements, int points) {
  const Gauss rule(points);
  return tabulate(axis, elements, rule.point, rule.weight, Weigh::length);
}

AxisRule mean_rule(const Axis& axis, const std::vector<int>& elements, int points, MeanWeight weight) {
  const std::vector<double> middle(points, 0.5), share(points, 1.0 / points);
  return tabulate(axis, elements, middle, share, Weigh::length,
                  [weight](const Axis& along, int e, double) { return means_of(along, e, weight); });
}

/// The elements of each stored column.
std::vector<int> elements_of(const ElementColumns& columns) {
  std::vector<int> elements(columns.run[columns.runs - 1].end, 0);  // between two runs nothing is read
  for (int r = 0; r < columns.runs; ++r)
    for (int l = columns.run[r].begin; l < columns.run[r].end; ++l) elements[l] = l + columns.run[r].shift;
  return elements;
}

}  // namespace

AxisRule gauss_rule(const Axis& axis, int first, int last, int points) {
  return gauss_rule(axis, range(first, last), points);
}

AxisRule gauss_rule(const Axis& axis, const ElementColumns& columns, int points) {
  return gauss_rule(axis, elements_of(columns), points);
}

AxisRule mean_rule(const Axis& axis, int first, int last, int points, MeanWeight weight) {
  return mean_rule(axis, range(first, last), points, weight);
}

AxisRule mean_rule(const Axis& axis, const ElementColumns& columns, int points, MeanWeight weight) {
  return mean_rule(axis, elements_of(columns), points, weight);
}

AxisRule low_face_rule(const Axis& axis, int first) { return tabulate(axis, range(first, first + 1), {0.0}, {1.0}); }

AxisRule high_face_rule(const Axis& axis, int last) { return tabulate(axis, range(last, last + 1), {1.0}, {1.0}); }

AxisRuleOf<float> in_single(const AxisRule& rule) {
  const auto cube = [](const auto& table) {
    const Kokkos::View<float***, Kokkos::LayoutRight, Exec> to("rounded", table.extent(0), table.extent(1),
                                                               table.extent(2));
    Kokkos::deep_copy(to, table);
    return to;
  };
  const auto square = [](const auto& table) {
    const Kokkos::View<float**, Kokkos::LayoutRight, Exec> to("rounded", table.extent(0), table.extent(1));
    Kokkos::deep_copy(to, table);
    return to;
  };
  const Kokkos::View<float*, Exec> share("rounded", rule.share.extent(0));
  Kokkos::deep_copy(share, rule.share);
  return {cube(rule.value), cube(rule.slope), square(rule.weight), square(rule.position), share,
          rule.first,       rule.elements,    rule.points,         rule.spacing};
}

AxisRule restricted_to(const AxisRule& rule, int function) {
  const auto keep = [function](const auto& table) {
    Kokkos::View<double***, Kokkos::LayoutRight, Exec> copy("restricted", table.extent(0), table.extent(1),
                                                            table.extent(2));
    auto from = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), table);
    auto to = Kokkos::create_mirror_view(copy);
    for (std::size_t p = 0; p < to.extent(0); ++p)
      for (std::size_t e = 0; e < to.extent(2); ++e) to(p, function, e) = from(p, function, e);
    Kokkos::deep_copy(copy, to);
    return copy;
  };
  AxisRule result = rule;
  result.value = keep(rule.value);
  result.slope = keep(rule.slope);
  return result;
}

AxisRule linear_from(const AxisRule& rule, int row, double low, double height) {
  const auto shape = [&rule](const char* name) {
    return Kokkos::View<double***, Kokkos::LayoutRight, Exec>(name, rule.value.extent(0), rule.value.extent(1),
                                                              rule.value.extent(2));
  };
  const auto value = shape("value"), slope = shape("slope");
  const Kokkos::View<int*, Exec> first("first", rule.first.extent(0));
  auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), rule.position);
  auto v = Kokkos::create_mirror_view(value), s = Kokkos::create_mirror_view(slope);
  for (std::size_t p = 0; p < v.extent(0); ++p)
    for (std::size_t e = 0; e < v.extent(2); ++e) {
      v(p, 0, e) = 1 - (x(p, e) - low) / height;
      s(p, 0, e) = -1 / height;
    }
  Kokkos::deep_copy(value, v);
  Kokkos::deep_copy(slope, s);
  Kokkos::deep_copy(first, row);
  AxisRule result = rule;
  result.value = value;
  result.slope = slope;
  result.first = first;
  return result;
}

}  // namespace softwet
