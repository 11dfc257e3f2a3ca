// Columns that travel between processes: copies of the columns of neighbours, and whole vectors collected from all
// processes.
#pragma once

#include <algorithm>
#include <cstdint>

#include "field/layout.hpp"
#include "field/ranks.hpp"

namespace softwet {

using ColumnList = Kokkos::View<const int*, Exec>;

/// Memory for messages; the host's is the same where kernels run there.
template <class Real>
struct MessageSpace {
  ArrayOf<Real> device;
  typename ArrayOf<Real>::host_mirror_type host;

  void hold(std::size_t size) {
    if (device.extent(0) >= size) return;
    device = ArrayOf<Real>(Kokkos::view_alloc("messages", Kokkos::WithoutInitializing), size);
    host = Kokkos::create_mirror_view(device);
  }
};

/// The stored columns that a process sends to its neighbours and those it receives, once and for all. A process may be
/// its own neighbour, around a periodic axis.
struct ColumnExchange {
  struct Neighbour {
    int rank;
    ColumnList send, receive;
  };
  std::vector<Neighbour> neighbours;
  mutable MessageSpace<double> sent, received;
  mutable MessageSpace<float> sent_single, received_single;

  template <class Real>
  MessageSpace<Real>& out() const {
    if constexpr (std::is_same_v<Real, double>)
      return sent;
    else
      return sent_single;
  }
  template <class Real>
  MessageSpace<Real>& in() const {
    if constexpr (std::is_same_v<Real, double>)
      return received;
    else
      return received_single;
  }
};

/// The exchange of one of the processes that an axis is cut for.
std::shared_ptr<const ColumnExchange> plan_exchange(const Axis&, const Columns&);

enum class MessageWay { from_vector, to_vector };

/// Columns of a vector to a message, or back.
template <class Real>
struct MoveColumns {
  ArrayOf<Real> vector, message;
  ColumnList columns;
  int stored, first;
  MessageWay way;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int n = static_cast<int>(columns.extent(0)), entry = item / n * stored + columns(item % n);
    if (way == MessageWay::from_vector) {
      message(first + item) = vector(entry);
    } else {
      vector(entry) = message(first + item);
    }
  }
};

/// Copies of other processes' columns, and those beyond a periodic end, take their values.
template <class Real>
void update_columns(const Columns& columns, const ColumnExchange& exchange, const ArrayOf<Real>& vector) {
  const int stored = columns.stored(), lines = static_cast<int>(vector.extent(0)) / stored;
  std::size_t sent = 0, received = 0;
  for (const auto& n : exchange.neighbours) {
    sent += lines * n.send.extent(0);
    received += lines * n.receive.extent(0);
  }
  MessageSpace<Real>&out = exchange.out<Real>(), &in = exchange.in<Real>();
  out.hold(sent);
  in.hold(received);
  const auto move = [&](const ColumnList& list, const ArrayOf<Real>& message, int first, MessageWay way) {
    Kokkos::parallel_for("softwet::columns", Items(0, lines * static_cast<int>(list.extent(0))),
                         MoveColumns<Real>{vector, message, list, stored, first, way});
  };
  std::vector<ranks::Message> messages;
  int to = 0, from = 0;
  for (const auto& n : exchange.neighbours) {
    const int give = lines * static_cast<int>(n.send.extent(0)), take = lines * static_cast<int>(n.receive.extent(0));
    move(n.send, out.device, to, MessageWay::from_vector);
    if (n.rank == columns.rank) {
      Kokkos::deep_copy(Exec(), Kokkos::subview(in.device, Kokkos::make_pair(from, from + take)),
                        Kokkos::subview(out.device, Kokkos::make_pair(to, to + give)));
    } else {
      messages.push_back(
          {n.rank, out.host.data() + to, give * sizeof(Real), in.host.data() + from, take * sizeof(Real)});
    }
    to += give;
    from += take;
  }
  if constexpr (!on_host) {  // what a process gives itself has arrived on the device
    Kokkos::deep_copy(in.host, in.device);
    Kokkos::deep_copy(out.host, out.device);
  }
  Kokkos::fence();
  ranks::exchange(messages);
  if constexpr (!on_host) Kokkos::deep_copy(in.device, in.host);
  from = 0;
  for (const auto& n : exchange.neighbours) {
    move(n.receive, in.device, from, MessageWay::to_vector);
    from += lines * static_cast<int>(n.receive.extent(0));
  }
}

/// Runs body(line) on the host.
template <class Body>
void for_lines_on_host(std::int64_t lines, const Body& body) {
  using Policy = Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace, Kokkos::IndexType<std::int64_t>>;
  Kokkos::parallel_for("softwet::lines", Policy(0, lines), body);
  Kokkos::DefaultHostExecutionSpace().fence();
}

/// The processes that receive collected values.
enum class Collects { every_process, first_process };

/// Lines of all columns of the patch, collected from what each process stores. `own` and `all` are in the memory of the
/// host; `all` means nothing where nothing is collected. A few lines after the other, so that the memory for messages
/// stays small.
template <class Real>
void gather_lines(const Columns& c, std::int64_t lines, const Real* own, Real* all,
                  Collects who = Collects::every_process) {
  const bool every = who == Collects::every_process, here = every || c.rank == 0;
  const int functions = c.first_function.back(), stored = c.stored(), mine = c.end - c.begin;
  const std::int64_t at_once = std::max<std::int64_t>(1, (std::int64_t(1) << 22) / functions);
  std::vector<Real> part, parts;
  for (std::int64_t first = 0; first < lines; first += at_once) {
    const std::int64_t count = std::min(at_once, lines - first);
    part.resize(count * mine);
    if (here) parts.resize(count * functions);
    for_lines_on_host(count, [=, from = own + first * stored + c.begin, to = part.data()](std::int64_t l) {
      std::copy_n(from + l * stored, mine, to + l * mine);
    });
    std::vector<int> bytes(c.ranks);
    for (int r = 0; r < c.ranks; ++r)
      bytes[r] = static_cast<int>(count * (c.first_function[r + 1] - c.first_function[r]) * sizeof(Real));
    every ? ranks::gather(part.data(), bytes, parts.data()) : ranks::gather_on_root(part.data(), bytes, parts.data());
    if (!here) continue;
    const int* ends = c.first_function.data();
    const int ranks = c.ranks;
    for_lines_on_host(count, [=, from = parts.data(), to = all + first * functions](std::int64_t l) {
      for (int r = 0; r < ranks; ++r) {
        const int begin = ends[r], width = ends[r + 1] - begin;
        std::copy_n(from + count * begin + l * width, width, to + l * functions + begin);
      }
    });
  }
}

/// The stored columns out of lines of all columns.
template <class Real>
void take_lines(const Columns& c, std::int64_t lines, const Real* all, Real* own) {
  const int functions = c.first_function.back(), stored = c.stored();
  for_lines_on_host(lines, [=, from = c.function.data()](std::int64_t l) {
    for (int i = 0; i < stored; ++i) own[l * stored + i] = all[l * functions + from[i]];
  });
}

/// A vector of all columns from those that each process stores; views with lines of columns, in the memory of kernels.
template <class From, class To>
void gather_columns(const Columns& c, const From& own, const To& all) {
  const auto from = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), own);
  const auto to = Kokkos::create_mirror_view(all);
  gather_lines(c, static_cast<std::int64_t>(own.extent(0)) / c.stored(), from.data(), to.data());
  Kokkos::deep_copy(all, to);
}
template <class From, class To>
void take_columns(const Columns& c, const From& all, const To& own) {
  const auto from = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), all);
  const auto to = Kokkos::create_mirror_view(own);
  take_lines(c, static_cast<std::int64_t>(own.extent(0)) / c.stored(), from.data(), to.data());
  Kokkos::deep_copy(own, to);
}

/// Values of the whole patch on the host, on every process.
template <int D>
std::vector<double> to_host_of_patch(const Layout<D>& layout, const ConstArray& own) {
  std::vector<double> values = to_host(own);
  if (layout.whole()) return values;
  const std::int64_t lines = static_cast<std::int64_t>(values.size()) / layout.columns.stored();
  std::vector<double> all(lines * layout.columns.first_function.back());
  gather_lines(layout.columns, lines, values.data(), all.data());
  return all;
}

/// Values of the whole patch on the first process, from those that each process stores; empty on the others.
template <int D>
std::vector<double> collect_on_root(const Layout<D>& layout, std::vector<double> values) {
  if (layout.whole()) return values;
  const Columns& c = layout.columns;
  const std::int64_t lines = static_cast<std::int64_t>(values.size()) / c.stored();
  std::vector<double> all(c.rank == 0 ? lines * c.first_function.back() : 0);
  gather_lines(c, lines, values.data(), all.data(), Collects::first_process);
  return all;
}
template <int D>
std::vector<double> to_host_on_root(const Layout<D>& layout, const ConstArray& own) {
  return collect_on_root(layout, to_host(own));
}

/// The part of values of the whole patch that this process stores: the inverse of collecting.
template <int D>
Array from_patch(const Layout<D>& layout, const std::vector<double>& all) {
  if (layout.whole()) return to_device<Array>(all);
  const std::int64_t lines = static_cast<std::int64_t>(all.size()) / layout.columns.first_function.back();
  std::vector<double> own(lines * layout.columns.stored());
  take_lines(layout.columns, lines, all.data(), own.data());
  return to_device<Array>(own);
}

/// Entries of the whole patch in a vector of which `stored` are here.
template <int D>
double entries_of_patch(const Layout<D>& layout, double stored) {
  return layout.whole() ? stored : stored / layout.columns.stored() * layout.columns.first_function.back();
}

}  // namespace softwet
