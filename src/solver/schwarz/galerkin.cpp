#include "solver/schwarz/galerkin.hpp"

#include <algorithm>
#include <cstdlib>

#include "memory/start_teams.hpp"

namespace softwet {

namespace {

struct CoarsenTerm {
  int row, step;
  double weight;
};

/// Fine rows and shifts that make up a coarse row and shift.
std::vector<CoarsenTerm> terms_of(const Axis& fine, const Refinement& r, int row, int shift) {
  const int owned = r.coarse.owned(), fine_owned = fine.owned(), degree = fine.degree();
  const bool periodic = fine.periodic();
  const int column = row + shift, at = wrapped(column, owned, periodic ? owned : 0);
  if (row >= owned || at < 0) return {};
  const int first_column = r.first[at] + (column - at) / owned * fine_owned;
  std::vector<CoarsenTerm> list;
  for (int k = 0; k < static_cast<int>(r.coefficient[row].size()); ++k)
    for (int l = 0; l < static_cast<int>(r.coefficient[at].size()); ++l) {
      const int i = r.first[row] + k, step = first_column + l - i;
      const double weight = r.coefficient[row][k] * r.coefficient[at][l];
      if (weight != 0 && std::abs(step) <= degree)
        list.push_back({wrapped(i, fine_owned, periodic ? fine_owned : 0), step + degree, weight});
    }
  while (list.size() % AxisProduct::terms_at_once != 0) list.push_back({list.front().row, list.front().step, 0.0});
  return list;
}

AxisProduct make_product(const Axis& fine, const Refinement& r, const AxisPlaces& from, const AxisPlaces& to) {
  std::vector<std::vector<CoarsenTerm>> terms;
  std::vector<int> count;
  std::size_t width = 0;
  for (std::size_t j = 0; j < to.function.size(); ++j)
    for (int shift = -fine.degree(); shift <= fine.degree(); ++shift) {
      terms.push_back(to.own[j] ? terms_of(fine, r, to.function[j], shift) : std::vector<CoarsenTerm>());
      count.push_back(static_cast<int>(terms.back().size()));
      width = std::max(width, terms.back().size());
    }
  AxisProduct p{to_device<decltype(AxisProduct::count)>(count),
                decltype(AxisProduct::row)("galerkin.row", terms.size(), width),
                decltype(AxisProduct::step)("galerkin.step", terms.size(), width),
                decltype(AxisProduct::weight)("galerkin.weight", terms.size(), width)};
  const auto row = Kokkos::create_mirror_view(p.row), step = Kokkos::create_mirror_view(p.step);
  const auto weight = Kokkos::create_mirror_view(p.weight);
  for (std::size_t i = 0; i < terms.size(); ++i)
    for (std::size_t k = 0; k < terms[i].size(); ++k) {
      row(i, k) = from.place[terms[i][k].row];
      step(i, k) = terms[i][k].step;
      weight(i, k) = static_cast<float>(terms[i][k].weight);
    }
  Kokkos::deep_copy(p.row, row);
  Kokkos::deep_copy(p.step, step);
  Kokkos::deep_copy(p.weight, weight);
  return p;
}

/// Entries of neighbouring rows that are summed at once, and lines that are turned at once for the first axis.
constexpr int coarsen_piece = chunk(256), lines_in_team = chunk(16);

/// One axis but the first, or on a device any. An item is a piece of the rows that lie side by side.
template <int D>
struct CoarsenAxis {
  Stencil<D> in, out;
  const float* from;
  float* to;
  AxisProduct axis;
  int d, width;        ///< width: 2 degree + 1
  int below, above;    ///< control points below and above axis d in the order of storage
  int before, behind;  ///< shifts along the axes before and behind axis d

  KOKKOS_FUNCTION int pieces() const { return chunks_in(below, coarsen_piece); }
  std::int64_t items() const { return std::int64_t(before) * behind * above * out.extent[d] * pieces(); }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int begin = static_cast<int>(item % pieces()) * coarsen_piece,
              count = begin + coarsen_piece < below ? coarsen_piece : below - begin;
    item /= pieces();
    const int row = static_cast<int>(item % out.extent[d]), high = static_cast<int>(item / out.extent[d] % above);
    const int other = static_cast<int>(item / out.extent[d] / above);  // shifts along the other axes
    const std::int64_t block = std::int64_t(other / before) * width * before + other % before;
    const std::int64_t line = std::int64_t(high) * out.extent[d] + row;
    for (int s = 0; s < width; ++s) {
      float sum[coarsen_piece] = {};
      const int list = row * width + s;
      for (int k = 0; k < axis.count(list); k += AxisProduct::terms_at_once) {
        const float *a = source(block, high, list, k) + begin, *b = source(block, high, list, k + 1) + begin;
        const float *c = source(block, high, list, k + 2) + begin, *e = source(block, high, list, k + 3) + begin;
        const float wa = axis.weight(list, k), wb = axis.weight(list, k + 1);
        const float wc = axis.weight(list, k + 2), we = axis.weight(list, k + 3);
        for (int i = 0; i < count; ++i) sum[i] += (wa * a[i] + wb * b[i]) + (wc * c[i] + we * e[i]);
      }
      float* result = to + (block + s * before) * out.points + line * below + begin;
      for (int i = 0; i < count; ++i) result[i] = sum[i];
    }
  }
  KOKKOS_FUNCTION const float* source(std::int64_t block, int high, int list, int k) const {
    return from + (block + std::int64_t(axis.step(list, k)) * before) * in.points +
           (std::int64_t(high) * in.extent[d] + axis.row(list, k)) * below;
  }
};

/// The first axis on the host, where rows to be summed follow each other: some lines are turned first, so that their
/// entries lie side by side. A team turns and sums one group of lines.
template <int D>
struct CoarsenLines {
  Stencil<D> in, out;
  const float* from;
  float* to;
  AxisProduct axis;
  int width, groups;
  using Team = Kokkos::TeamPolicy<Exec>::member_type;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int n = in.extent[0], lines = in.points / n, first = team.league_rank() % groups * lines_in_team;
    const int count = first + lines_in_team < lines ? lines_in_team : lines - first;
    const std::int64_t block = std::int64_t(team.league_rank() / groups) * width;
    const Scratch turned(team.team_scratch(1), width * n * lines_in_team);
    for (int step = 0; step < width; ++step)
      for (int lane = 0; lane < lines_in_team; ++lane) {
        const float* source = from + (block + step) * in.points + std::int64_t(first + lane) * n;
        for (int i = 0; i < n; ++i) turned((step * n + i) * lines_in_team + lane) = lane < count ? source[i] : 0.0f;
      }
    for (int s = 0; s < width; ++s)
      for (int row = 0; row < out.extent[0]; ++row) {
        const int list = row * width + s;
        float sum[lines_in_team] = {};
        for (int k = 0; k < axis.count(list); ++k) {
          const float* source = &turned((axis.step(list, k) * n + axis.row(list, k)) * lines_in_team);
          for (int lane = 0; lane < lines_in_team; ++lane) sum[lane] += axis.weight(list, k) * source[lane];
        }
        float* result = to + (block + s) * out.points + std::int64_t(first) * out.extent[0] + row;
        for (int lane = 0; lane < count; ++lane) result[lane * out.extent[0]] = sum[lane];
      }
  }
};

template <int D>
void coarsen(const Stencil<D>& in, const Stencil<D>& out, const AxisProduct& axis, int d, const float* from,
             float* to) {
  const int width = 2 * in.degree + 1;
  if (on_host && d == 0) {
    const int lines = in.points / in.extent[0], groups = chunks_in(lines, lines_in_team);
    const std::size_t scratch = CoarsenLines<D>::Scratch::shmem_size(width * in.extent[0] * lines_in_team);
    start_teams("softwet::galerkin",
                Teams<>(in.offsets / width * groups, 1).set_scratch_size(1, Kokkos::PerTeam(scratch)),
                CoarsenLines<D>{in, out, from, to, axis, width, groups});
    return;
  }
  int below = 1, before = 1;
  for (int e = 0; e < d; ++e) {
    below *= out.extent[e];
    before *= width;
  }
  const CoarsenAxis<D> body{in,
                            out,
                            from,
                            to,
                            axis,
                            d,
                            width,
                            below,
                            out.points / below / out.extent[d],
                            before,
                            out.offsets / width / before};
  Kokkos::parallel_for("softwet::galerkin", LongItems(0, body.items()), body);
}

}  // namespace

template <int D>
GalerkinProduct<D>::GalerkinProduct(const Layout<D>& fine, const Layout<D>& coarse,
                                    const std::vector<Refinement>& refinement)
    : stencil_{Stencil<D>(fine)} {
  for (int d = 0; d < D; ++d)
    axis_[d] = make_product(fine.axis[d], refinement[d], axis_places(fine.axis[d], d == 0 ? fine.columns : Columns()),
                            axis_places(coarse.axis[d], d == 0 ? coarse.columns : Columns()));
  for (int d = D - 1; d >= 0; --d) {  // the first axis last: rows of neighbouring points stay together meanwhile
    Stencil<D> next = stencil_.back();
    next.extent[d] = coarse.extent(d);
    next.points = stencil_.back().points / stencil_.back().extent[d] * next.extent[d];
    stencil_.push_back(next);
  }
}

template <int D>
void GalerkinProduct<D>::operator()(const StencilValues& fine, const StencilValues& coarse) {
  const std::int64_t offsets = stencil_[0].offsets;
  for (int step = 0; step + 1 < D; ++step)
    if (between_[step].extent(0) == 0)
      between_[step] = StencilValues(Kokkos::view_alloc("galerkin.between", Kokkos::WithoutInitializing),
                                     offsets * stencil_[step + 1].points);
  for (int pair = 0; pair < stencil_[0].pairs(); ++pair) {
    const float* from = fine.data() + pair * offsets * stencil_[0].points;
    for (int step = 0; step < D; ++step) {
      const int d = D - 1 - step;
      float* to = d > 0 ? between_[step].data() : coarse.data() + pair * offsets * stencil_[D].points;
      coarsen(stencil_[step], stencil_[step + 1], axis_[d], d, from, to);
      from = to;
    }
  }
}

template <int D>
double GalerkinProduct<D>::bytes() const {
  double bytes = 0;
  for (int step = 0; step + 1 < D; ++step) bytes += 4.0 * stencil_[0].offsets * stencil_[step + 1].points;
  return bytes;
}

template class GalerkinProduct<2>;
template class GalerkinProduct<3>;

}  // namespace softwet
