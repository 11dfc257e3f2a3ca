// How an instruction that computes gets its functions. Each family of instructions has a source of its own, which knows its opcodes.
#pragma once

#include <string>
#include <vector>

#include "lanes.hpp"
#include "operations.hpp"

namespace emulate {

/// An instruction whose functions are sought.
struct Choice {
  const Statement& s;
  Instruction& made;
  const std::vector<int>& widths;  ///< bytes of the registers of its operands
  const std::string& op;
  Type type = Type::none, second = Type::none;  ///< the last type of the opcode, and the first one where there are two
  Handlers h{};

  Choice(const Statement& statement, Instruction& instruction, const std::vector<int>& bytes);
  bool floating() const { return type == Type::f32 || type == Type::f64; }
  void one(Handler handler) { h = {handler, handler}; }
  /// make(zero): functions for numbers of the type of zero.
  template <class Make>
  void integers(Make make) {
    with_integer(type, [&](auto zero) { h = make(zero); });
  }
  template <class Make>
  void floats(Make make) {
    with_floating(type, [&](auto zero) { h = make(zero); });
  }
};

/// Functions for numbers of the type T of the instruction, where that is an integer, or a floating-point number.
#define INTEGERS(make)            \
  choice.integers([](auto zero) { \
    using T = decltype(zero);     \
    return make;                  \
  })
#define FLOATS(make)            \
  choice.floats([](auto zero) { \
    using T = decltype(zero);   \
    return make;                \
  })

Class class_of(Type type, bool division = false);
/// Executes `inner` with the rounding of the host set to mode `op`.
void with_rounding(Warp& w, const Instruction& i, std::uint32_t mask);
enum Mode { rn = 0, rz, rm, rp, rni, rzi, rmi, rpi };

// Each returns whether the opcode is one of its family. Where it is, but not in this form, there is no function.
bool choose_sum(Choice& choice);         ///< sums, products, quotients, roots, powers
bool choose_bits(Choice& choice);        ///< logic, shifts, fields of bits
bool choose_comparison(Choice& choice);  ///< comparisons, predicates, selections
bool choose_conversion(Choice& choice);  ///< moves, conversions of numbers and of addresses

}  // namespace emulate
