// How a kernel is translated from PTX: calls are inlined, the code is cut into blocks, registers get places, and instructions get their
// functions.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "program.hpp"

namespace emulate {

/// A function at one of its calls.
struct Instance {
  Function* function = nullptr;
  bool kernel = false;
  int first_register = 0;
  std::map<std::string, std::int64_t> local;  // places of variables and of parameters in the memory of a thread
  std::string prefix;
};

/// An instruction of a kernel after its calls are inlined.
struct Step {
  enum Kind { statement, jump, leave, host_call } kind = statement;
  const Statement* s = nullptr;
  int instance = 0;
  int guard = -1;
  bool guard_negated = false;
  std::string label;  // of a jump
  End call;
};

bool is_sync(const std::string& op, const Statement& s);     ///< of the lanes of a warp: shuffles, votes ...
bool is_barrier(const std::string& op, const Statement& s);  ///< of a block of threads
bool no_result(const std::string& op);                       ///< of an opcode

/// Translates one kernel. Functions take `n`, the number of the instance of a function whose names operands use.
class Translator {
 public:
  Translator(Module& module, const Symbols& symbols, Kernel& kernel) : module_(module), symbols_(symbols), k_(kernel) {}
  void run(const std::string& name);

 private:
  [[noreturn]] void fail(const Statement& s, const std::string& what);

  // Calls are inlined: program.cpp.
  int add_registers(const Function& f);
  void place_variables(int n);
  std::int64_t place_shared(const Variable& v);
  void note_names(int n, const Operand& o);
  void inline_function(int n, int depth);
  void inline_call(int n, const Statement& s, Step step, int depth);

  // The code is cut into blocks: blocks.cpp.
  int label(const Statement& s, const std::string& name);
  bool ends_block(const Step& step) const;
  bool alone(const Step& step) const;  ///< whether a block holds nothing but this
  void cut();
  const std::vector<std::string>& table(const Step& step);

  // Registers get places: registers.cpp.
  template <class Use>
  void registers_of(const Operand& o, int n, Use use);
  /// Calls read(register), write(register).
  template <class Read, class Write>
  void effects(const Step& step, Read read, Write write);
  static bool shares_places(const Step& step);
  void place_registers();

  // Where operands lie: operands.cpp.
  Place constant(std::uint64_t bits, int bytes);
  std::uint64_t address(const Statement& s, int n, const std::string& name);
  static Place special(const Statement& s, const std::string& name);
  Place place(const Statement& s, int n, const Operand& o, int bytes);
  std::uint32_t result(int n, const Operand& o);
  int width(int n, const Operand& o);
  /// Bytes of an operand that is a number.
  static int number_bytes(const Statement& s, std::size_t index);

  // Instructions get their functions: decode.cpp.
  void decode();
  void end(const Step& step, int b, BasicBlock& made);
  void end_with_barrier(const Step& step, BasicBlock& made);
  void end_with_sync(const Step& step, BasicBlock& made);
  void set_access(const Step& step, Instruction& i);
  Instruction instruction(const Step& step);

  Module& module_;
  const Symbols& symbols_;
  Kernel& k_;
  std::vector<Instance> instances_;
  std::vector<Type> types_;
  std::vector<Step> steps_;
  std::map<std::string, int> labels_;
  std::map<std::string, std::int64_t> params_, shared_;
  std::int64_t local_ = 0, dynamic_at_ = 0;
  bool uses_dynamic_ = false;
  int barriers_ = 0;
  std::vector<int> block_of_, firsts_;
  std::vector<std::vector<int>> successors_;
  std::vector<std::uint32_t> place_of_;
  std::map<std::pair<std::uint64_t, int>, std::uint32_t> constants_;
};

}  // namespace emulate
