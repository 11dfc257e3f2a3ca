#include "solver/schwarz/shared_inverses.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

namespace softwet {

SharedInverses::SharedInverses(const PatchTables& t, int components, float limit)
    : limit_(limit), row_(t.row), rows_(t.rows), components_(components), owner_(t.count) {
  std::iota(owner_.begin(), owner_.end(), 0);
  std::map<std::vector<int>, int> kinds;
  std::vector<int> first_of_kind;
  for (int box = 0; box < t.count; ++box) {
    const auto first = t.local.begin() + std::ptrdiff_t(box) * t.sites;
    const auto [kind, fresh] = kinds.emplace(std::vector<int>(first, first + t.sites), static_cast<int>(kinds.size()));
    kind_.push_back(kind->second);
    if (fresh) first_of_kind.push_back(box);
  }
  const int all_rows = t.row > 0 ? t.count / t.row : 0;
  for (int r = 0; r < all_rows; ++r) {
    const std::size_t wave = any() ? r % rows_ + r / rows_ : 0;
    if (wave >= waves_.size()) waves_.resize(wave + 1);
    for (int i = 0; i < row_; ++i) waves_[wave].push_back(r * row_ + i);
  }
  if (any()) allocate(t, first_of_kind);
}

void SharedInverses::allocate(const PatchTables& t, const std::vector<int>& first_of_kind) {
  const int kinds = static_cast<int>(first_of_kind.size());
  field_ = Numbers("shared.field", kinds, t.unknowns);
  probe_ = ChooseInverse::Rows<float>("shared.probe", ChooseInverse::probes, t.unknowns);
  question_ = Numbers("shared.question", largest_wave(), 1 + ChooseInverse::most_candidates);
  answer_ = Kokkos::View<int*, Exec>("shared.answer", largest_wave());
  question_on_host_ = Kokkos::create_mirror_view(question_);
  answer_on_host_ = Kokkos::create_mirror_view(answer_);
  std::vector<int> size;
  const auto field = Kokkos::create_mirror_view(field_);
  for (int k = 0; k < kinds; ++k) {
    size.push_back(t.size[first_of_kind[k]]);
    for (int site = 0; site < t.sites; ++site) {
      const int i = t.local[std::ptrdiff_t(first_of_kind[k]) * t.sites + site];
      if (i >= 0) field(k, i) = site % components_;
    }
  }
  Kokkos::deep_copy(field_, field);
  size_ = to_device<Kokkos::View<int*, Exec>>(size);
  const auto probe = Kokkos::create_mirror_view(probe_);
  for (int k = 0; k < ChooseInverse::probes; ++k) {
    std::mt19937 random(1 + k);  // the same signs wherever the largest box of a process has another size
    for (int i = 0; i < t.unknowns; ++i) probe(k, i) = random() % 2 ? 1.0f : -1.0f;
  }
  Kokkos::deep_copy(probe_, probe);
}

int SharedInverses::largest_wave() const {
  std::size_t most = 0;
  for (const std::vector<int>& wave : waves_) most = std::max(most, wave.size());
  return static_cast<int>(most);
}

/// The inverses that boxes at most two places before this one use.
std::vector<int> SharedInverses::candidates(int box) const {
  constexpr int reach = 2;
  static_assert(ChooseInverse::most_candidates == (reach + 1) * (reach + 1) - 1);
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

void SharedInverses::choose(const int* boxes, int count, const DenseBlocks& matrices, const BoxInverses& inverses,
                            int threads) {
  if (!any()) return;
  Kokkos::deep_copy(question_on_host_, -1);
  for (int b = 0; b < count; ++b) {
    question_on_host_(b, 0) = kind_[boxes[b]];
    const std::vector<int> others = candidates(boxes[b]);
    for (std::size_t k = 0; k < others.size(); ++k) question_on_host_(b, 1 + k) = others[k];
  }
  Kokkos::deep_copy(question_, question_on_host_);
  ChooseInverse{matrices, inverses, size_, field_, probe_, question_, answer_, limit_, components_}.run(count, threads);
  Kokkos::deep_copy(answer_on_host_, answer_);
  for (int b = 0; b < count; ++b) {
    const int found = answer_on_host_(b);
    owner_[boxes[b]] = found < 0 ? boxes[b] : question_on_host_(b, 1 + found);
  }
}

std::vector<int> SharedInverses::by_owner() const {
  std::vector<int> boxes(owner_.size());
  std::iota(boxes.begin(), boxes.end(), 0);
  std::stable_sort(boxes.begin(), boxes.end(), [&](int a, int b) { return owner_[a] < owner_[b]; });
  return boxes;
}

}  // namespace softwet
