#include "field/exchange.hpp"

namespace softwet {
namespace {

int owner(const Columns& c, int function) {
  int rank = 0;
  while (function >= c.first_function[rank + 1]) ++rank;
  return rank;
}

/// For each copy that a process stores, in the order of storage: visit(its column, the function it repeats).
template <class Visit>
void each_copy(const Axis& axis, const Columns& c, const Visit& visit) {
  for (int i = 0; i < c.stored(); ++i) {
    const int function = c.function[i], repeated = axis.periodic() ? function % axis.owned() : function;
    if (!c.own(i) || repeated != function) visit(i, repeated);
  }
}

}  // namespace

std::shared_ptr<const ColumnExchange> plan_exchange(const Axis& axis, const Columns& mine) {
  auto plan = std::make_shared<ColumnExchange>();
  for (int rank = 0; rank < mine.ranks; ++rank) {
    std::vector<int> send, receive;
    each_copy(axis, mine, [&](int column, int repeated) {
      if (owner(mine, repeated) == rank) receive.push_back(column);
    });
    each_copy(axis, cut_before(axis, rank, mine.first_function, mine.beside), [&](int, int repeated) {
      if (owner(mine, repeated) == mine.rank) send.push_back(mine.begin + repeated - mine.first_function[mine.rank]);
    });
    if (send.empty() && receive.empty()) continue;
    plan->neighbours.push_back({rank, to_device<Kokkos::View<int*, Exec>>(send, "columns"),
                                to_device<Kokkos::View<int*, Exec>>(receive, "columns")});
  }
  return plan;
}

}  // namespace softwet
