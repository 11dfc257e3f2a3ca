// A kernel in the form that is executed. Calls are inlined, registers share places, and each instruction has a function that executes
// it for the 32 lanes of a warp.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ptx.hpp"

namespace emulate {

struct Warp;
struct Instruction;
using Handler = void (*)(Warp&, const Instruction&, std::uint32_t mask);

constexpr std::uint32_t nowhere = ~0u;

/// Where the values of 32 lanes are: bytes from the first register of the warp (base 0), from the first constant of the kernel (1), or from
/// the first special register (2).
struct Place {
  std::uint32_t base = 0, at = nowhere;
};

/// Classes of instructions of PTX, which are counted. Machine code has other numbers.
enum class Class : std::uint8_t {
  fp64,
  fp64_div,
  fp32,
  fp32_div,
  integer,
  convert,
  move,
  predicate,
  load_global,
  store_global,
  load_shared,
  store_shared,
  local,
  param,
  atomic,
  shuffle,
  barrier,
  branch,
  other,
  count
};
const char* name_of(Class);

struct Instruction {
  Handler full = nullptr, part = nullptr;  // for all lanes, and for some
  Handler inner = nullptr;                 // what an instruction with another rounding computes
  std::uint32_t d = nowhere, d2 = nowhere;
  Place a, b, c, e;
  std::int64_t number = 0;  // offset of an address, modes of a conversion, a table of a logic operation ...
  std::uint32_t guard = nowhere;
  bool guard_negated = false;
  Class kind = Class::other;
  Space space = Space::generic;
  std::uint8_t bytes = 0, width = 1;  // of an access: bytes of one element, and number of elements
  bool wide_address = true, param_is_local = false, is_store = false, is_atomic = false;
  std::uint8_t op = 0;     // which operation: of atomics, shuffles, comparisons
  std::uint32_t more = 0;  // first of its places in Kernel::further
  int line = 0;
  const char* opcode = "";
};

/// What ends a block.
struct End {
  enum Kind : std::uint8_t { fall, branch, exit, barrier, warp_sync, table, trap, call_host } kind = fall;
  int target = -1;
  std::uint32_t guard = nowhere;
  bool guard_negated = false;
  // of a barrier:
  Place id, threads;
  bool has_threads = false;
  int reduction = -1;  // 0: popc, 1: and, 2: or
  int ordinal = 0;     // its number among the barriers of the kernel
  Place value;
  bool value_negated = false;
  std::uint32_t result = nowhere;
  Instruction sync;  // a shuffle or a vote of the warp
  Place members;
  std::vector<int> targets;
  std::string callee;
  std::vector<std::int64_t> arguments;  // offsets in the memory of a thread
  std::int64_t answer = -1;
  int line = 0;
};

struct BasicBlock {
  std::uint32_t begin = 0, end = 0;
  End last;
  std::uint32_t classes[int(Class::count)] = {};
};

/// Registers and memory of a kernel, from its machine code; without machine code what it may need.
struct Needs {
  int registers = 32;
  bool known = false;
  std::int64_t shared = 0, stack = 0;
};

struct Kernel {
  std::string name, shown;  // as in PTX, and readable
  std::vector<Instruction> code;
  std::vector<BasicBlock> blocks;
  std::vector<Place> further;
  std::vector<std::uint64_t> constants;  // 32 lanes of each
  std::uint32_t register_bytes = 0;
  std::int64_t local_bytes = 0, static_shared = 0, param_bytes = 0;
  std::vector<std::pair<std::int64_t, std::int64_t>> params;  // offset, bytes
  int max_threads = 0;
  Needs needs;
  const Module* module = nullptr;
  int values = 0, colours64 = 0, colours32 = 0;  // number of registers in PTX, and of places of 8 and of 4 bytes a lane
};

/// Special registers are in memory, 32 lanes of 4 bytes each; the last ones have 8 bytes.
enum Special : std::uint32_t {
  tid_x,
  tid_y,
  tid_z,
  ntid_x,
  ntid_y,
  ntid_z,
  ctaid_x,
  ctaid_y,
  ctaid_z,
  nctaid_x,
  nctaid_y,
  nctaid_z,
  laneid,
  warpid,
  nwarpid,
  smid,
  nsmid,
  gridid,
  lanemask_eq,
  lanemask_le,
  lanemask_lt,
  lanemask_ge,
  lanemask_gt,
  dynamic_shared,
  total_shared,
  clock32,
  zero64,
  clock64 = zero64 + 2,
  special_count = clock64 + 2
};

/// Addresses of variables of a module.
struct Symbols {
  struct Found {
    Space space;
    std::uint64_t address;  // of global and constant memory; the offset of shared memory
    std::int64_t bytes;
  };
  std::map<std::string, Found> all;
};

/// Translates a kernel. Throws a Problem that names the opcode and the kernel where an instruction is not known.
void translate(Module& module, const Symbols& symbols, const std::string& name, Kernel& kernel);

/// Sets the functions, class and modes of an instruction that computes. False: it is not known.
bool choose_arithmetic(const Statement& statement, Instruction& made, const std::vector<int>& widths);
/// Sets the functions, class and modes of a load, a store or an atomic. False: it is not known.
bool choose_access(const Statement& statement, Instruction& made, int register_bytes, int address_bytes);

}  // namespace emulate
