#include "solver/shared_inverses.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <numeric>
#include <random>

namespace softwet {

namespace {

/// y = inverse of a box, times x.
void multiply_inverse(const BoxInverses& inverses, int box, const std::vector<float>& x, std::vector<float>& y) {
  const int n = static_cast<int>(x.size());
  for (int first = 0; first < n; first += rows_at_once) {
    float sum[1][rows_at_once];
    inverses.multiply<1>(box, n, first, {x.data()}, sum);
    std::copy_n(sum[0], std::min(rows_at_once, n - first), y.begin() + first);
  }
}

}  // namespace

SharedInverses::SharedInverses(const PatchTables& t, int components, float limit)
    : limit_(limit), row_(t.row), rows_(t.rows), components_(components), owner_(t.count) {
  std::iota(owner_.begin(), owner_.end(), 0);
  std::map<std::vector<int>, int> kinds;
  for (int box = 0; box < t.count; ++box) {
    const auto first = t.local.begin() + std::ptrdiff_t(box) * t.sites;
    const std::vector<int> local(first, first + t.sites);
    const auto [kind, fresh] = kinds.emplace(local, static_cast<int>(kinds.size()));
    kind_.push_back(kind->second);
    if (!fresh) continue;
    std::vector<int>& component = component_.emplace_back(t.size[box]);
    for (int site = 0; site < t.sites; ++site)
      if (local[site] >= 0) component[local[site]] = site % components;
  }
  for (int k = 0; k < 2; ++k) {
    std::mt19937 random(1 + k);  // the same signs wherever the largest box of a process has another size
    for (int i = 0; i < t.unknowns; ++i) probe_[k].push_back(random() % 2 ? 1.0f : -1.0f);
  }
  const int all_rows = t.row > 0 ? t.count / t.row : 0;
  for (int r = 0; r < all_rows; ++r) {
    const std::size_t wave = any() ? r % rows_ + r / rows_ : 0;
    if (wave >= waves_.size()) waves_.resize(wave + 1);
    for (int i = 0; i < row_; ++i) waves_[wave].push_back(r * row_ + i);
  }
}

/// The inverses that boxes at most two places before this one use.
std::vector<int> SharedInverses::candidates(int box) const {
  constexpr int reach = 2;
  const int y = box / row_ % rows_, z = box / row_ / rows_;
  std::vector<int> found;
  for (int back = 0; back <= std::min(z, reach); ++back)
    for (int left = back == 0 ? 1 : 0; left <= std::min(y, reach); ++left) {
      const int other = owner_[box - (back * rows_ + left) * row_];
      if (kind_[other] == kind_[box] && std::find(found.begin(), found.end(), other) == found.end())
        found.push_back(other);
    }
  return found;
}

float SharedInverses::distance(const Matrix& a, int candidate, int kind, const BoxInverses& inverses) const {
  const std::vector<int>& component = component_[kind];
  const int n = static_cast<int>(component.size());
  std::vector<float> r(n), x(n), y(n);
  float largest = 0;
  for (const std::vector<float>& sign : probe_) {
    for (int i = 0; i < n; ++i) r[i] = sign[i] * a.size_of_row[i];
    multiply_inverse(inverses, candidate, r, x);
    for (int i = 0; i < n; ++i) r[i] = std::inner_product(a.row(i), a.row(i) + n, x.data(), 0.0f);
    multiply_inverse(inverses, candidate, r, y);
    std::vector<float> difference(components_), size(components_);
    for (int i = 0; i < n; ++i) {
      difference[component[i]] += (y[i] - x[i]) * (y[i] - x[i]);
      size[component[i]] += x[i] * x[i];
    }
    for (int f = 0; f < components_; ++f) {
      const float relative = difference[f] == 0 ? 0.0f : std::sqrt(difference[f] / size[f]);
      if (std::isnan(relative)) return relative;
      largest = std::max(largest, relative);
    }
  }
  return largest;
}

int SharedInverses::closest(int box, const Matrix& a, const BoxInverses& inverses) const {
  float least = limit_;
  int found = box;
  for (const int other : candidates(box)) {
    const float d = distance(a, other, kind_[box], inverses);
    if (!(d < least)) continue;
    least = d;
    found = other;
  }
  return found;
}

void SharedInverses::choose(const int* boxes, int count, const DenseBlocks& matrices, const BoxInverses& inverses) {
  const auto choose_one = [&](int b) {
    int& owner = owner_[boxes[b]];
    owner = boxes[b];
    try {
      const int n = static_cast<int>(component_[kind_[boxes[b]]].size());
      Matrix a{&matrices(b, 0, 0), matrices.extent(2), std::vector<float>(n)};
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) a.size_of_row[i] = std::max(a.size_of_row[i], std::abs(a.row(i)[j]));
      owner = closest(boxes[b], a, inverses);
    } catch (const std::bad_alloc&) {
      // No exception may leave a parallel region. The box keeps an inverse of its own.
    }
  };
  using Host = Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
  Kokkos::parallel_for("softwet::share", Host(0, count).set_chunk_size(1), choose_one);
}

std::vector<int> SharedInverses::by_owner() const {
  std::vector<int> boxes(owner_.size());
  std::iota(boxes.begin(), boxes.end(), 0);
  std::stable_sort(boxes.begin(), boxes.end(), [&](int a, int b) { return owner_[a] < owner_[b]; });
  return boxes;
}

}  // namespace softwet
