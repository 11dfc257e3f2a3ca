// Integrals of functionals (mass, energies, dissipation) over a region, summed in one fixed order.
#pragma once

#include <array>
#include <functional>
#include <stdexcept>
#include <vector>

#include "field/vector.hpp"
#include "operator/device/team_reduce.hpp"
#include "operator/rows.hpp"

namespace softwet {

/// Adds the lanes of a number one after the other: the first ones to a sum, and the others up to `count` to another one. A number that has no
/// lanes goes to the first sum.
template <class S>
KOKKOS_FORCEINLINE_FUNCTION void add_in_turn(const S& number, int first, int count, double& sum, double& other) {
  if constexpr (is_one_number<S>) {
    sum += number;
  } else {
    constexpr int lanes = Lanes<S>::count;
    double lane[lanes];
    Kokkos::Experimental::simd_unchecked_store(number, lane, Kokkos::Experimental::simd_flag_default);
    for (int l = 0; l < count; ++l) (l < first ? sum : other) += lane[l];
  }
}

/// The points of an element are summed in their order, and then the elements in theirs. N = S: the integral. N = Dual<S>: its rate
/// of change by the motion of the domain alone, at fixed fields.
/// @param sum    [strip][functional], of two strips
/// @param first  number of lanes that belong to the first strip; the others belong to the second one
template <class S, class N, int D, int P, int Q, class Functional, class Motion>
KOKKOS_FUNCTION void reduce_batch(const ReduceTask<D, Functional, Motion>& task, const Batch<D>& b, int first,
                                  double* sum) {
  constexpr int QL = points_across<Functional, Q>, points = power(Q, D - 1) * QL;
  using Trial = typename Functional::template Trial<N, D>;
  using Fields = BatchFields<S, S, D, P, Q, QL, typename Functional::template Trial<S, D>>;
  const BatchBasis<S, D, P, Q, QL> basis(task.region, b);
  const Fields values(task, b, basis);
  const LiftedFields<Fields, N> fields{values};
  const BatchGeometry<S, N, D, P, Q, Motion> geometry(task.region, b, basis.x, basis.y, task.motion);
  S of_elements[Functional::count];
  for (int f = 0; f < Functional::count; ++f) of_elements[f] = S(0.0);
  for (int q = 0; q < points; ++q) {
    const auto point = point_at<Functional, Q, S>(geometry, task, b, q);
    const Reader<N, D, std::remove_const_t<decltype(fields)>, std::remove_const_t<decltype(point)>> reader{fields,
                                                                                                           point, q};
    const Vector<N, Functional::count> value = task.functional.value(Trial::read(reader));
    const S weight = weight_at<S, D, Q>(task.region, b, q);
    for (int f = 0; f < Functional::count; ++f)
      of_elements[f] = of_elements[f] + weight * outcome(point.measured(value[f]));
  }
  for (int f = 0; f < Functional::count; ++f)
    add_in_turn(of_elements[f], first, b.count, sum[f], sum[Functional::count + f]);
}

/// Partial sums of the strips of one row of elements, element by element. An item is two strips where a batch has lanes for both.
/// The order in each strip's sum is the same whatever is beside it.
template <int D, int P, int Q, bool Rate, class Functional, class Motion>
struct ReduceRow {
  using S = BatchNumber<double>;
  static constexpr int lanes = Lanes<S>::count, together = lanes >= 2 * strip_width ? 2 : 1;

  ReduceTask<D, Functional, Motion> task;
  Colouring<D> rows;
  Array partial;  ///< [row][own strip][functional]

  KOKKOS_FUNCTION int strips() const { return rows.first_axis.last_strip - rows.first_axis.first_strip; }
  /// The first so many strips are no wider than others.
  KOKKOS_FUNCTION int equal_strips() const {
    const ElementColumns& columns = rows.first_axis;
    return columns.own_end - columns.own_begin > strips() * strip_width ? strips() - 1 : strips();
  }
  KOKKOS_FUNCTION int items_of_row() const {
    return (equal_strips() + together - 1) / together + strips() - equal_strips();
  }
  int items() const { return rows.items() * items_of_row(); }

  KOKKOS_FUNCTION void operator()(int item) const {
    using N = std::conditional_t<Rate, Dual<S>, S>;
    constexpr int count = Functional::count;
    double sum[2 * count] = {};
    const ElementColumns& columns = rows.first_axis;
    const int row = item / items_of_row(), next = item % items_of_row() * together;
    const bool wide = next >= equal_strips();
    const int strip = wide ? equal_strips() : next, end = wide ? strips() : min(strip + together, equal_strips());
    const int last = end < strips() ? columns.own_begin + end * strip_width : columns.own_end;
    Batch<D> b = rows.batch(row);
    for (b.element[0] = columns.own_begin + strip * strip_width; b.element[0] < last; b.element[0] += lanes) {
      b.count = min(last - b.element[0], lanes);
      reduce_batch<S, N, D, P, Q, Functional, Motion>(task, b, wide ? lanes : strip_width, sum);
    }
    for (int i = 0; i < (end - strip) * count; ++i) partial((row * strips() + strip) * count + i) = sum[i];
  }

 private:
  static KOKKOS_FUNCTION int min(int a, int b) { return a < b ? a : b; }
};

/// The rows of elements of an integral, cut into strips.
template <int D>
struct IntegralItems {
  Colouring<D> rows;
  int strips, items;
  StripsHere here;

  explicit IntegralItems(const Region<D>& region)
      : rows(region, 1, 0, FirstAxis::in_rows),
        strips(rows.first_axis.last_strip - rows.first_axis.first_strip),
        items(rows.items() * strips),
        here(region.columns.strips > 0 ? StripsHere::own : StripsHere::all) {}

  /// Whether a device adds up the partial sums of so many functionals, in a second kernel (field/strip_sums.hpp).
  bool adds_rows(int functionals) const { return adds_on_device(std::int64_t(items) * functionals); }
  /// How many numbers of each functional come to the host: partial sums, or those of strips.
  int numbers(int functionals) const { return adds_rows(functionals) ? strips : items; }
  /// From the partial sums of the items, or from so many sums of strips, over all processes.
  template <int count, class Partial>
  std::array<double, count> total(const Partial& partial, int numbers) const {
    StripTotals totals(rows.first_axis.strips, count, here);
    for (int i = 0; i < numbers; ++i)
      for (int f = 0; f < count; ++f) totals.add(rows.first_axis.first_strip + i % strips, f, partial(i * count + f));
    std::array<double, count> sum{};
    for (int f = 0; f < count; ++f) sum[f] = totals.total(f);
    return sum;
  }
};

/// Starts the kernel of the partial sums of an integral.
template <int P, bool Rate = false, int D, class Functional, class Motion>
void start_integral(const ReduceTask<D, Functional, Motion>& task, const Array& partial) {
  const IntegralItems<D> in(task.region);
  with_points<P>(task.region, [&]<int Q>(PointsPerAxis<Q>) {
    if constexpr (host_algorithms) {
      const ReduceRow<D, P, Q, Rate, Functional, Motion> kernel{task, in.rows, partial};
      for_items("softwet::reduce", kernel.items(), kernel);
    } else {
      TeamReduce<D, P, Q, Rate, Functional, Motion>::launch(task, in.rows, partial, in.items);
    }
  });
}

/// Starts the kernels that leave the numbers of an integral for the host.
/// @param blocks  room for the partial sums of all items where a device adds them up
template <int P, bool Rate, int D, class Functional, class Motion>
void start_integral_and_sums(const IntegralItems<D>& in, const ReduceTask<D, Functional, Motion>& task,
                             const Array& numbers, const Array& blocks) {
  const bool adds = in.adds_rows(Functional::count);
  start_integral<P, Rate>(task, adds ? blocks : numbers);
  if (adds) AddBlocks{blocks, in.rows.items(), numbers}.start();
}

/// Integrals, and other numbers that kernels leave for the host. The kernels start one after the other, and all numbers come in one copy,
/// with one wait. There is room for one such list at a time: to start something in another one before `finish` is a mistake,
/// std::logic_error. All processes have to call it. What kernels read has to hold until `finish`.
class PendingIntegrals {
 public:
  PendingIntegrals() = default;
  PendingIntegrals(const PendingIntegrals&) = delete;
  ~PendingIntegrals() { leave(); }

  /// Starts an integral, which `take` gets from `finish`, an array of Functional::count numbers.
  /// With Rate, not the integrals but the rates at which they change because the domain moves; `motion.tangent` is then the
  /// velocity of the wall and `motion.scale` 1.
  template <int P, bool Rate = false, int D, class Functional, class Motion, class Take>
  void start(const ReduceTask<D, Functional, Motion>& task, Take take) {
    const IntegralItems<D> in(task.region);
    constexpr int count = Functional::count;
    start_numbers(
        static_cast<std::size_t>(in.numbers(count)) * count,
        [&](const Array& numbers) {
          const Array blocks = in.adds_rows(count) ? sum_scratch(std::size_t(in.items) * count).device : Array();
          start_integral_and_sums<P, Rate>(in, task, numbers, blocks);
        },
        [in, take](const auto& numbers) { take(in.template total<count>(numbers, in.numbers(count))); });
  }
  /// Starts sum_i x_i y_i, as `dot` has it, or, without y, sum_i x_i, which `take` gets from `finish`.
  template <class Take>
  void start_sum(const VectorSpace& space, const ConstArray& x, const ConstArray& y, Take take) {
    const StripSums<double> sums(space, x.data(), 0, 1, {y.data()}, SquareOfFirst::left_out,
                                 static_cast<int>(x.extent(0)));
    start_numbers(
        static_cast<std::size_t>(numbers_of(sums)),
        [&](const Array& numbers) {
          start_strip_sums(sums, numbers, adds_blocks(sums) ? sum_scratch(sums.items()).device : Array());
        },
        [sums, take, x, y](const auto& numbers) {
          StripTotals totals(sums.space.strips, 1, strips_here(sums.space));
          add_partial_sums(totals, sums, numbers.data(), numbers_of(sums), 0);
          take(totals.total(0));
        });
  }
  /// Starts kernels by `launch`, which gets an array for so many numbers. `take` gets them on the host from `finish`.
  template <class Launch, class Take>
  void start_numbers(std::size_t count, const Launch& launch, Take take) {
    const std::size_t first = room(count);
    const auto range = Kokkos::make_pair(first, used_);
    launch(Kokkos::subview(partial_sums().device, range));
    waiting_.push_back([range, take] { take(Kokkos::subview(partial_sums().host, range)); });
  }
  /// Calls `work` when all that were started before are handed out.
  void then(std::function<void()> work) { waiting_.push_back(std::move(work)); }

  /// Waits for all that were started, and hands them out in the order in which they were. Copies to the host that the execution space was
  /// asked for before have then arrived too.
  void finish() {
    if (used_ > 0)
      partial_sums().copy_to_host(used_);
    else
      Exec().fence("softwet: copies to the host");
    for (const auto& hand_out : waiting_) hand_out();
    leave();
    grow(partial_sums(), wanted_);  // the next such list fits as a whole
  }

 private:
  /// One for all, because `sum_scratch` serves sums that are made in between.
  static SumScratch& partial_sums() {
    static SumScratch scratch;
    return scratch;
  }
  /// Whose partial sums are there; null: nobody's.
  static const PendingIntegrals*& owner() {
    static const PendingIntegrals* list = nullptr;
    return list;
  }
  void leave() {
    if (owner() == this) owner() = nullptr;
    waiting_.clear();
    used_ = 0;
  }
  /// Where so many partial sums begin. Those that are there are handed out first where they do not fit beside them.
  std::size_t room(std::size_t entries) {
    if (owner() && owner() != this) throw std::logic_error("two lists of integrals are pending at once");
    wanted_ += entries;
    if (used_ + entries > partial_sums().device.extent(0)) finish();
    owner() = this;
    used_ += entries;
    return used_ - entries;
  }

  std::vector<std::function<void()>> waiting_;
  std::size_t used_ = 0, wanted_ = 0;  ///< partial sums: that wait, that were ever asked for
};

/// One integral, or with Rate its rate; as PendingIntegrals::start.
template <int P, bool Rate = false, int D, class Functional, class Motion>
std::array<double, Functional::count> reduce(const ReduceTask<D, Functional, Motion>& task) {
  constexpr int count = Functional::count;
  const IntegralItems<D> in(task.region);
  const std::size_t numbers = std::size_t(in.numbers(count)) * count;
  const std::size_t blocks = in.adds_rows(count) ? std::size_t(in.items) * count : 0;
  const SumScratch& scratch = sum_scratch(numbers + blocks);
  const auto part = [&](std::size_t begin, std::size_t end) {
    return Kokkos::subview(scratch.device, Kokkos::make_pair(begin, end));
  };
  start_integral_and_sums<P, Rate>(in, task, part(0, numbers), part(numbers, numbers + blocks));
  scratch.copy_to_host(numbers);
  return in.template total<count>(scratch.host, in.numbers(count));
}

/// Starts those of two integrals, on a device as one.
template <int P, int D, class First, class FirstMotion, class Second, class SecondMotion>
void start_integrals(const ReduceTask<D, First, FirstMotion>& first, const Array& partial_of_first,
                     const ReduceTask<D, Second, SecondMotion>& second, const Array& partial_of_second) {
  if constexpr (host_algorithms) {
    start_integral<P>(first, partial_of_first);
    start_integral<P>(second, partial_of_second);
  } else {
    const IntegralItems<D> in_first(first.region), in_second(second.region);
    with_points<P>(first.region, [&]<int Q>(PointsPerAxis<Q>) {
      with_points<P>(second.region, [&]<int R>(PointsPerAxis<R>) {
        using One = TeamReduce<D, P, Q, false, First, FirstMotion>;
        using Other = TeamReduce<D, P, R, false, Second, SecondMotion>;
        TeamReducePair<One, Other>{
            {first, in_first.rows, partial_of_first}, {second, in_second.rows, partial_of_second}, in_first.items}
            .launch(in_second.items);
      });
    });
  }
}

}  // namespace softwet
