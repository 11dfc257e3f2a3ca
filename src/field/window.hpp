// Columns of the whole patch around a process's own ones, brought from those who have them.
#pragma once

#include "field/exchange.hpp"

namespace softwet {

/// For a process's own columns and `width` beside them: who sends which. A neighbour's `send` numbers columns in storage,
/// its `receive` those of the patch. A process is its own neighbour.
inline std::shared_ptr<const ColumnExchange> plan_window(const Axis& axis, const Columns& mine, int width) {
  const auto& first = mine.first_function;
  const int owned = axis.owned();
  const auto wants = [&](int rank, int function) {
    const int low = first[rank], high = std::min(first[rank + 1], owned);
    for (const int turn : {0, -owned, owned}) {
      if (turn != 0 && !axis.periodic()) continue;
      if (function + turn >= low - width && function + turn < high + width) return true;
    }
    return false;
  };
  const auto plan = std::make_shared<ColumnExchange>();
  for (int rank = 0; rank < mine.ranks; ++rank) {
    std::vector<int> send, receive;
    for (int f = first[mine.rank]; f < std::min(first[mine.rank + 1], owned); ++f)
      if (wants(rank, f)) send.push_back(mine.begin + f - first[mine.rank]);
    for (int f = first[rank]; f < std::min(first[rank + 1], owned); ++f)
      if (wants(mine.rank, f)) receive.push_back(f);
    if (send.empty() && receive.empty()) continue;
    plan->neighbours.push_back({rank, to_device<Kokkos::View<int*, Exec>>(send, "columns"),
                                to_device<Kokkos::View<int*, Exec>>(receive, "columns")});
  }
  return plan;
}

/// A part of some lines, as `fill_window`.
template <class Real>
void move_window(const Columns& columns, const ColumnExchange& window, const ArrayOf<Real>& own,
                 const ArrayOf<Real>& all) {
  const int stored = columns.stored(), functions = columns.first_function.back();
  const int lines = static_cast<int>(own.extent(0)) / stored;
  std::size_t sent = 0, received = 0;
  for (const auto& n : window.neighbours) {
    sent += lines * n.send.extent(0);
    received += lines * n.receive.extent(0);
  }
  MessageSpace<Real>&out = window.out<Real>(), &in = window.in<Real>();
  out.hold(sent);
  in.hold(received);
  const auto move = [&](const ArrayOf<Real>& vector, int width, const ArrayOf<Real>& message, const ColumnList& list,
                        int first, bool pack) {
    Kokkos::parallel_for("softwet::columns", Kokkos::RangePolicy<Exec>(0, lines * static_cast<int>(list.extent(0))),
                         MoveColumns<Real>{vector, message, list, width, first, pack});
  };
  int to = 0, from = 0;
  std::vector<ranks::Message> messages;
  for (const auto& n : window.neighbours) {
    const int give = lines * static_cast<int>(n.send.extent(0)), take = lines * static_cast<int>(n.receive.extent(0));
    move(own, stored, out.device, n.send, to, true);
    if (n.rank == columns.rank) {
      move(all, functions, out.device, n.receive, to, false);
    } else {
      messages.push_back(
          {n.rank, out.host.data() + to, give * sizeof(Real), in.host.data() + from, take * sizeof(Real)});
    }
    to += give;
    from += take;
  }
  if constexpr (!on_host) Kokkos::deep_copy(out.host, out.device);
  Kokkos::fence();
  ranks::exchange(messages);
  if constexpr (!on_host) Kokkos::deep_copy(in.device, in.host);
  from = 0;
  for (const auto& n : window.neighbours) {
    if (n.rank != columns.rank) move(all, functions, in.device, n.receive, from, false);
    from += lines * static_cast<int>(n.receive.extent(0));
  }
}

/// The window of a vector with lines of columns: from what is stored, `own`, to `all` columns of the patch, of which the
/// others stay as they are. A few lines after the other, so that the memory for messages stays small.
template <class Real, class From, class To>
void fill_window(const Columns& columns, const ColumnExchange& window, const From& own, const To& all) {
  const int stored = columns.stored(), functions = columns.first_function.back();
  const std::int64_t lines = static_cast<std::int64_t>(own.extent(0)) / stored;
  const std::int64_t at_once = std::max<std::int64_t>(1, (std::int64_t(1) << 22) / functions);
  const ArrayOf<Real> from(const_cast<Real*>(own.data()), own.extent(0)), to(all.data(), all.extent(0));
  for (std::int64_t first = 0; first < lines; first += at_once) {
    const std::int64_t last = std::min(lines, first + at_once);
    move_window<Real>(columns, window, Kokkos::subview(from, Kokkos::make_pair(first * stored, last * stored)),
                      Kokkos::subview(to, Kokkos::make_pair(first * functions, last * functions)));
  }
}

}  // namespace softwet
