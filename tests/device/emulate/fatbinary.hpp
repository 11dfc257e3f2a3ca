// Kernels of a program: the PTX and machine code that nvcc puts into it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "machine.hpp"
#include "program.hpp"
#include "ptx.hpp"

namespace emulate {

class Fatbinary {
 public:
  explicit Fatbinary(const void* wrapper);
  const Kernel& kernel(const std::string& name);
  Needs needs(const std::string& name) const;
  /// Address of a variable; 0: there is none.
  std::uint64_t variable(const std::string& name);

 private:
  void load();
  void read_machine_code(const char* elf);
  std::string text_;
  bool compressed_ = false;
  std::unique_ptr<Module> module_;
  Symbols symbols_;
  std::map<std::string, std::unique_ptr<Kernel>> kernels_;
  std::map<std::string, Needs> needs_;
  std::recursive_mutex mutex_;
};

std::string demangled(const std::string& name);

}  // namespace emulate
