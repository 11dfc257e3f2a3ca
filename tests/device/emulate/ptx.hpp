// PTX as a compiler writes it: modules with their variables and functions. The body of a function is parsed when it is asked for.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace emulate {

struct Problem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

enum class Type : std::uint8_t { none, pred, u8, u16, u32, u64, s8, s16, s32, s64, b8, b16, b32, b64, f16, f32, f64 };
int size_of(Type);
/// The type of a name without its dot, such as "f64".
std::optional<Type> type_named(std::string_view);

enum class Space : std::uint8_t { generic, global, shared, local, constant, param };

struct Operand {
  enum Kind : std::uint8_t { none, reg, sink, number, name, special, vector, address } kind = none;
  int reg_index = -1;          // in the function
  bool negated = false;        // of a predicate
  bool second = false;         // a second result, which follows a bar
  std::uint64_t bits = 0;      // of a number
  std::string text;            // name of a variable, a label, a special register
  std::int64_t offset = 0;     // of an address, or of a name
  std::vector<Operand> parts;  // elements of a vector or of a list in brackets; the base of an address
};

struct Statement {
  std::string opcode;              // as written, such as "ld.global.v2.f64"
  std::vector<std::string> words;  // between its dots
  int guard = -1;
  bool guard_negated = false;
  std::vector<Operand> operands;
  std::string label;  // this is a label, not an instruction
  int line = 0;
  bool has(std::string_view word) const {
    for (const auto& w : words)
      if (w == word) return true;
    return false;
  }
};

struct Variable {
  std::string name;
  Space space = Space::global;
  Type type = Type::b8;
  std::int64_t align = 1, count = 1;
  bool external = false;
  std::vector<std::pair<std::string, std::uint64_t>>
      values;  // of each element: the name of a variable, or none, and a number
  std::int64_t bytes() const { return count * size_of(type); }
};

struct Function {
  std::string name;
  bool entry = false, parsed = false;
  std::vector<Variable> results, params;
  std::string_view body;  // text between its braces
  int line = 0;
  // When the body is parsed:
  std::vector<Type> regs;
  std::vector<Variable> variables;  // local, shared and call parameters
  std::vector<Statement> statements;
  std::map<std::string, std::vector<std::string>> targets;  // of .branchtargets
  int max_threads = 0;
};

class Module {
 public:
  struct Place {
    int file = 0, line = 0, outer_file = 0, outer_line = 0;  // the outer ones: where it is inlined
  };
  explicit Module(std::string text);
  Function* function(const std::string& name);  // with its body parsed; null: there is none
  const std::vector<Variable>& variables() const { return variables_; }
  /// The place in the sources that a line of PTX comes from, or "" where the compiler did not write it (nvcc -lineinfo does).
  std::string locate(int line) const;

 private:
  std::string text_;
  std::map<std::string, Function> functions_;
  std::vector<Variable> variables_;
  std::map<int, std::string> files_;
  std::map<int, Place> places_;  // by lines of PTX
};

}  // namespace emulate
