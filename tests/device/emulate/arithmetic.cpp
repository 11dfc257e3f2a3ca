// Instructions that compute get their functions.
#include "arithmetic.hpp"

#include <algorithm>
#include <cfenv>

namespace emulate {

namespace {

void nothing(Warp&, const Instruction&, std::uint32_t) {}

/// Instructions of no effect here: memory is read and written in the order of the program.
bool has_no_effect(const std::string& op) {
  static const char* all[] = {"membar",         "fence",         "prefetch", "prefetchu", "nanosleep",
                              "griddepcontrol", "applypriority", "discard",  "pmevent"};
  return std::find(std::begin(all), std::end(all), op) != std::end(all);
}

/// Rounding of sums and products to another side than the nearest number.
void set_rounding(Choice& choice) {
  if (!choice.floating() || choice.op == "cvt" || choice.s.has("rni")) return;
  for (const auto& word : choice.s.words)
    if (word == "rz" || word == "rm" || word == "rp") {
      choice.made.op = word == "rz" ? rz : word == "rm" ? rm : rp;
      choice.made.inner = choice.h.part;
      choice.one(with_rounding);
    }
}

}  // namespace

Class class_of(Type type, bool division) {
  return type == Type::f64    ? (division ? Class::fp64_div : Class::fp64)
         : type == Type::f32  ? (division ? Class::fp32_div : Class::fp32)
         : type == Type::pred ? Class::predicate
                              : Class::integer;
}

__attribute__((noinline)) void with_rounding(Warp& w, const Instruction& i, std::uint32_t mask) {
  static constexpr int modes[] = {FE_TONEAREST, FE_TOWARDZERO, FE_DOWNWARD, FE_UPWARD};
  std::fesetround(modes[i.op & 3]);
  i.inner(w, i, mask);
  std::fesetround(FE_TONEAREST);
}

Choice::Choice(const Statement& statement, Instruction& instruction, const std::vector<int>& bytes)
    : s(statement), made(instruction), widths(bytes), op(statement.words[0]) {
  for (auto word = s.words.rbegin(); word != s.words.rend(); ++word)
    if (const auto found = type_named(*word)) (type == Type::none ? type : second) = *found;
}

bool choose_arithmetic(const Statement& s, Instruction& made, const std::vector<int>& widths) {
  Choice choice(s, made, widths);
  made.kind = class_of(choice.type);
  if (has_no_effect(choice.op)) {
    made.kind = Class::other;
    choice.one(nothing);
  } else if (!choose_sum(choice) && !choose_comparison(choice) && !choose_bits(choice) && !choose_conversion(choice)) {
    return false;
  }
  set_rounding(choice);
  made.full = choice.h.full;
  made.part = choice.h.part;
  return made.full != nullptr;
}

}  // namespace emulate
