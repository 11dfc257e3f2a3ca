// Registers get places in memory: those that are never live together share one (linear scan over live ranges).
#include <algorithm>
#include <bit>

#include "translate.hpp"

namespace emulate {

template <class Use>
void Translator::registers_of(const Operand& o, int n, Use use) {
  if (o.kind == Operand::reg) use(o.reg_index + instances_[n].first_register);
  for (const Operand& part : o.parts) registers_of(part, n, use);
}

template <class Read, class Write>
void Translator::effects(const Step& step, Read read, Write write) {
  if (step.guard >= 0) read(step.guard);
  if (step.kind != Step::statement) return;
  const Statement& s = *step.s;
  const std::string& op = s.words[0];
  bool results = !no_result(op);
  if ((op == "bar" || op == "barrier") && s.has("red")) results = true;
  for (std::size_t k = 0; k < s.operands.size(); ++k) {
    const Operand& o = s.operands[k];
    const bool writes = results && o.kind != Operand::address && (k == 0 || o.second);
    if (writes)
      registers_of(o, step.instance, [&](int r) {
        write(r);
        if (step.guard >= 0) read(r);
      });
    else
      registers_of(o, step.instance, read);
  }
}

bool Translator::shares_places(const Step& step) {
  if (step.kind != Step::statement) return false;
  const std::string& op = step.s->words[0];
  static const char* apart[] = {"shfl", "vote", "match", "redux", "ld",  "ldu", "atom",
                                "addc", "subc", "madc",  "bfi",   "cvt", "brx", "elect"};
  if (std::find(std::begin(apart), std::end(apart), op) != std::end(apart)) return false;
  for (const Operand& o : step.s->operands)
    if (o.kind == Operand::vector || o.second) return false;
  return true;
}

void Translator::place_registers() {
  const int blocks = static_cast<int>(successors_.size()), count = static_cast<int>(types_.size());
  const std::size_t words = (count + 63) / 64;
  std::vector<std::uint64_t> in(blocks * words), out(blocks * words), used(blocks * words), defined(blocks * words);
  const auto bit = [](std::vector<std::uint64_t>& set, std::size_t row, int r) -> void {
    set[row + r / 64] |= std::uint64_t(1) << (r % 64);
  };
  for (int b = 0; b < blocks; ++b)
    for (int k = firsts_[b]; k < firsts_[b + 1]; ++k) {
      std::vector<int> writes;
      effects(
          steps_[k],
          [&](int r) {
            if (!(defined[b * words + r / 64] >> (r % 64) & 1)) bit(used, b * words, r);
          },
          [&](int r) { writes.push_back(r); });
      if (steps_[k].guard < 0)
        for (int r : writes) bit(defined, b * words, r);
    }
  for (bool changed = true; changed;) {
    changed = false;
    for (int b = blocks - 1; b >= 0; --b)
      for (std::size_t w = 0; w < words; ++w) {
        std::uint64_t o = 0;
        for (int s : successors_[b])
          if (s < blocks) o |= in[s * words + w];
        const std::uint64_t i = used[b * words + w] | (o & ~defined[b * words + w]);
        out[b * words + w] = o;
        if (i != in[b * words + w]) in[b * words + w] = i, changed = true;
      }
  }
  std::vector<int> begin(count, 1 << 30), end(count, -1);
  const auto reach = [&](int r, int at) { begin[r] = std::min(begin[r], at), end[r] = std::max(end[r], at); };
  for (int b = 0; b < blocks; ++b) {
    for (std::size_t w = 0; w < words; ++w) {
      for (std::uint64_t x = in [b * words + w]; x; x &= x - 1)
        reach(static_cast<int>(w * 64) + std::countr_zero(x), 2 * firsts_[b] - 1);
      for (std::uint64_t x = out[b * words + w]; x; x &= x - 1)
        reach(static_cast<int>(w * 64) + std::countr_zero(x), 2 * firsts_[b + 1] - 1);
    }
    for (int k = firsts_[b]; k < firsts_[b + 1]; ++k) {
      const bool shares = shares_places(steps_[k]);
      effects(
          steps_[k], [&](int r) { reach(r, shares ? 2 * k : 2 * k + 1); }, [&](int r) { reach(r, 2 * k + 1); });
    }
  }
  place_of_.assign(count, nowhere);
  std::vector<int> order;
  for (int r = 0; r < count; ++r)
    if (end[r] >= 0) order.push_back(r);
  k_.values = static_cast<int>(order.size());
  std::sort(order.begin(), order.end(), [&](int a, int b) { return begin[a] < begin[b]; });
  struct Active {
    int end;
    std::uint32_t place;
    bool operator<(const Active& other) const { return end > other.end; }
  };
  std::uint32_t top = 0;
  std::vector<Active> active[3];
  std::vector<std::uint32_t> unused[3];
  for (int r : order) {
    const int kind = types_[r] == Type::pred ? 0 : size_of(types_[r]) == 8 ? 2 : 1;
    static constexpr std::uint32_t sizes[] = {64, 128, 256};
    auto& heap = active[kind];
    while (!heap.empty() && heap.front().end < begin[r]) {
      std::pop_heap(heap.begin(), heap.end());
      unused[kind].push_back(heap.back().place);
      heap.pop_back();
    }
    if (unused[kind].empty()) {
      if (kind == 0) {
        for (std::uint32_t k = 0; k < 64; k += 4) unused[0].push_back(top + 60 - k);
      } else {
        unused[kind].push_back(top);
        ++(kind == 2 ? k_.colours64 : k_.colours32);
      }
      top += sizes[kind];
    }
    place_of_[r] = unused[kind].back();
    unused[kind].pop_back();
    heap.push_back({end[r], place_of_[r]});
    std::push_heap(heap.begin(), heap.end());
  }
  // Registers that nothing writes or reads, and results that nobody reads.
  k_.register_bytes = (top + 511) / 256 * 256;
}

}  // namespace emulate
