#include "fatbinary.hpp"

#include <cxxabi.h>
#include <dlfcn.h>
#include <elf.h>

#include <chrono>
#include <cstring>
#include <string_view>

#include "memory.hpp"
#include "options.hpp"

namespace emulate {

namespace {

template <class T>
T read(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// What nvcc has compressed with Zstandard, with the library of that name where there is one; empty: there is none.
std::string decompressed(std::string_view content, std::size_t bytes) {
  using Decompress = std::size_t(void*, std::size_t, const void*, std::size_t);
  static void* const library = dlopen("libzstd.so.1", RTLD_NOW);
  static auto* const decompress = library ? reinterpret_cast<Decompress*>(dlsym(library, "ZSTD_decompress")) : nullptr;
  std::string text(bytes, '\0');
  if (!decompress || decompress(text.data(), bytes, content.data(), content.size()) != bytes) return {};
  return text;
}

}  // namespace

std::string demangled(const std::string& name) {
  int status = 0;
  char* made = abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status);
  std::string text = made ? made : name;
  std::free(made);
  return text;
}

// A wrapper points to a header (magic number, version, bytes of header, bytes of all). Entries follow it one after another: kind (1: PTX, 2:
// machine code), bytes of header, bytes of content, bytes of compressed content ... bytes when it is decompressed.
Fatbinary::Fatbinary(const void* wrapper) {
  const char* at = read<const char*>(static_cast<const char*>(wrapper) + 8);
  if (read<std::uint32_t>(at) != 0xBA55ED50u) throw Problem("no fat binary");
  const auto header = read<std::uint16_t>(at + 6);
  const char* end = at + header + read<std::uint64_t>(at + 8);
  for (at += header; at < end;) {
    const auto kind = read<std::uint16_t>(at);
    const auto own = read<std::uint32_t>(at + 4);
    const auto bytes = read<std::uint64_t>(at + 8);
    const char* content = at + own;
    std::string_view all(content, bytes);
    std::string own_copy;
    if (bytes > 4 && read<std::uint32_t>(content) == 0xFD2FB528u && own >= 64) {
      own_copy = decompressed(all.substr(0, read<std::uint32_t>(at + 16)), read<std::uint64_t>(at + 56));
      all = own_copy;
    }
    if (kind == 1) {
      if (all.substr(0, 4096).find(".version") == std::string_view::npos)
        compressed_ = true;
      else
        text_ = std::string(all.substr(0, all.find('\0')));
    } else if (kind == 2 && all.starts_with(ELFMAG)) {
      read_machine_code(all.data());
    }
    at = content + bytes;
  }
}

void Fatbinary::read_machine_code(const char* elf) {
  const auto header = read<Elf64_Ehdr>(elf);
  const auto section = [&](int n) {
    return read<Elf64_Shdr>(elf + header.e_shoff + static_cast<std::size_t>(n) * header.e_shentsize);
  };
  const char* names = elf + section(header.e_shstrndx).sh_offset;
  std::map<std::uint32_t, std::string> symbols;
  for (int n = 0; n < header.e_shnum; ++n) {
    const auto s = section(n);
    if (s.sh_type != SHT_SYMTAB) continue;
    const char* text = elf + section(static_cast<int>(s.sh_link)).sh_offset;
    for (std::uint32_t k = 0; k < s.sh_size / sizeof(Elf64_Sym); ++k)
      symbols[k] = text + read<Elf64_Sym>(elf + s.sh_offset + k * sizeof(Elf64_Sym)).st_name;
  }
  for (int n = 0; n < header.e_shnum; ++n) {
    const auto s = section(n);
    const std::string name = names + s.sh_name;
    if (name == ".nv.info") {
      for (const char *at = elf + s.sh_offset, *end = at + s.sh_size; at + 4 <= end;) {
        const auto format = read<std::uint8_t>(at), attribute = read<std::uint8_t>(at + 1);
        const auto value = read<std::uint16_t>(at + 2);
        if (format == 4 && value == 8) {
          Needs& needs = needs_[symbols[read<std::uint32_t>(at + 4)]];
          const auto number = read<std::uint32_t>(at + 8);
          if (attribute == 0x2f) needs.registers = static_cast<int>(number), needs.known = true;
          if (attribute == 0x11) needs.stack = number;
        }
        at += format == 4 ? 4 + value : 4;
      }
    } else if (name.starts_with(".nv.shared.") && !name.starts_with(".nv.shared.reserved")) {
      constexpr std::int64_t reserved = 1024;  // of each team, by the driver; the size of the section includes it
      const auto size = static_cast<std::int64_t>(s.sh_size);
      needs_[name.substr(11)].shared = size < reserved ? size : size - reserved;
    }
  }
}

Needs Fatbinary::needs(const std::string& name) const {
  const auto found = needs_.find(name);
  return found == needs_.end() ? Needs{} : found->second;
}

void Fatbinary::load() {
  if (module_) return;
  if (text_.empty())
    throw Problem(compressed_ ? "the PTX in the program is compressed, and there is no libzstd.so.1: install it, or "
                                "build with NVCC_APPEND_FLAGS=--no-compress"
                              : "the program has no PTX");
  module_ = std::make_unique<Module>(text_);
  for (const Variable& v : module_->variables()) {
    if (v.space == Space::shared) continue;
    const std::uint64_t at =
        memory().allocate(static_cast<std::size_t>(std::max<std::int64_t>(v.bytes(), 1)), "variable " + v.name);
    if (!at) throw Problem("no memory for variable " + v.name);
    std::memset(memory().host(at), 0, static_cast<std::size_t>(v.bytes()));
    symbols_.all[v.name] = {v.space, at, v.bytes()};
  }
  for (const Variable& v : module_->variables()) {
    if (v.space == Space::shared) continue;
    char* to = memory().host(symbols_.all[v.name].address);
    for (const auto& [name, number] : v.values) {
      std::uint64_t value = number;
      if (!name.empty()) {
        const auto found = symbols_.all.find(name);
        if (found == symbols_.all.end()) throw Problem("variable " + v.name + " has the address of " + name);
        value += found->second.address;
      }
      std::memcpy(to, &value, static_cast<std::size_t>(size_of(v.type)));
      to += size_of(v.type);
    }
  }
}

const Kernel& Fatbinary::kernel(const std::string& name) {
  const std::lock_guard lock(mutex_);
  load();
  auto& kernel = kernels_[name];
  if (!kernel) {
    auto made = std::make_unique<Kernel>();
    made->shown = demangled(name);
    made->needs = needs(name);
    const auto start = std::chrono::steady_clock::now();
    translate(*module_, symbols_, name, *made);
    if (options().trace)
      std::fprintf(stderr,
                   "emulate: translated in %.3f s: %zu instructions, %zu blocks, %d values in %d + %d places, %lld "
                   "bytes of local, %lld of shared memory: %.150s\n",
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), made->code.size(),
                   made->blocks.size(), made->values, made->colours64, made->colours32,
                   static_cast<long long>(made->local_bytes), static_cast<long long>(made->static_shared),
                   made->shown.c_str());
    kernel = std::move(made);
  }
  return *kernel;
}

std::uint64_t Fatbinary::variable(const std::string& name) {
  const std::lock_guard lock(mutex_);
  load();
  const auto found = symbols_.all.find(name);
  return found == symbols_.all.end() ? 0 : found->second.address;
}

}  // namespace emulate
