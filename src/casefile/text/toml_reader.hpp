// The TOML library, made safe for broken files: toml++ 3.3 has assertions that malformed text reaches ("a = [ }").
// Here they throw MalformedToml in every build, debug or release. Include this and never <toml++/toml.h>.
#pragma once

#include <stdexcept>

namespace softwet {

struct MalformedToml : std::runtime_error {
  MalformedToml() : std::runtime_error("brackets, quotes or keys do not match") {}
};

constexpr void require_toml(bool condition) {
  if (!condition) throw MalformedToml();
}

}  // namespace softwet

#pragma push_macro("NDEBUG")  // with NDEBUG the library would assume what it asserts
#undef NDEBUG
#undef TOML_HEADER_ONLY
#undef TOML_SHARED_LIB
#define TOML_HEADER_ONLY 1
#define TOML_ASSERT(condition) softwet::require_toml(static_cast<bool>(condition))
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
