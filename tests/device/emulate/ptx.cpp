#include "ptx.hpp"

#include <algorithm>

#include "reader.hpp"

namespace emulate {

int size_of(Type type) {
  switch (type) {
    case Type::u16:
    case Type::s16:
    case Type::b16:
    case Type::f16:
      return 2;
    case Type::u32:
    case Type::s32:
    case Type::b32:
    case Type::f32:
    case Type::pred:
      return 4;
    case Type::u64:
    case Type::s64:
    case Type::b64:
    case Type::f64:
      return 8;
    default:
      return 1;
  }
}

std::optional<Type> type_named(std::string_view name) {
  static const std::map<std::string_view, Type> names = {
      {"pred", Type::pred}, {"u8", Type::u8},   {"u16", Type::u16}, {"u32", Type::u32},
      {"u64", Type::u64},   {"s8", Type::s8},   {"s16", Type::s16}, {"s32", Type::s32},
      {"s64", Type::s64},   {"b8", Type::b8},   {"b16", Type::b16}, {"b32", Type::b32},
      {"b64", Type::b64},   {"f16", Type::f16}, {"f32", Type::f32}, {"f64", Type::f64}};
  const auto found = names.find(name);
  if (found == names.end()) return {};
  return found->second;
}

Variable read_variable(Reader& in, Space space) {
  Variable found;
  found.space = space;
  while (in.token.starts_with('.')) {
    if (in.take(".align")) {
      found.align = in.integer();
    } else if (in.take(".ptr")) {
      while (in.token.starts_with('.') && !type_named(in.token.substr(1))) {
        if (in.take(".align"))
          in.integer();
        else
          in.next();
      }
    } else if (in.take(".v2")) {
      found.count = 2;
    } else if (in.take(".v4")) {
      found.count = 4;
    } else {
      const auto type = type_named(in.token.substr(1));
      if (type) found.type = *type;
      in.next();
    }
  }
  found.name = in.word();
  found.align = std::max<std::int64_t>(found.align, size_of(found.type));
  while (in.take("[")) {
    found.count *= in.token == "]" ? 0 : in.integer();
    in.need("]");
  }
  if (in.take("=")) {
    const auto one = [&](auto&& self) -> void {
      if (in.take("{")) {
        while (!in.take("}")) {
          self(self);
          in.take(",");
        }
        return;
      }
      if (in.token.starts_with("generic") || in.token == "mask") {
        const bool generic = in.token.starts_with("generic");
        if (!generic) in.fail("a value that is masked");
        in.next();
        in.need("(");
        std::string name = in.word();
        in.need(")");
        std::uint64_t more = 0;
        if (in.take("+")) more = in.integer();
        found.values.emplace_back(name, more);
        return;
      }
      if (in.token[0] == '-' || std::isdigit(static_cast<unsigned char>(in.token[0]))) {
        if (in.token.starts_with("0d") || in.token.starts_with("0f")) {
          const std::string text = in.word();
          found.values.emplace_back("", std::strtoull(text.c_str() + 2, nullptr, 16));
        } else {
          found.values.emplace_back("", static_cast<std::uint64_t>(in.integer()));
        }
        return;
      }
      std::string name = in.word();
      std::uint64_t more = 0;
      if (in.take("+")) more = in.integer();
      found.values.emplace_back(name, more);
    };
    one(one);
  }
  return found;
}

namespace {

std::vector<Variable> parameters(Reader& in) {
  std::vector<Variable> found;
  while (!in.take(")")) {
    in.need(".param");
    found.push_back(read_variable(in, Space::param));
    in.take(",");
  }
  return found;
}

}  // namespace

Module::Module(std::string text) : text_(std::move(text)) {
  Reader in(text_, 1);
  bool external = false;
  while (!in.token.empty()) {
    const std::string word = in.word();
    if (word == ".version" || word == ".target") {
      in.rest_of_line();
    } else if (word == ".address_size") {
      in.next();
    } else if (word == ".extern") {
      external = true;
    } else if (word == ".visible" || word == ".weak" || word == ".common") {
      external = false;
    } else if (word == ".global" || word == ".const" || word == ".shared") {
      Variable made = read_variable(in, word == ".global"  ? Space::global
                                        : word == ".const" ? Space::constant
                                                           : Space::shared);
      made.external = external;
      external = false;
      variables_.push_back(std::move(made));
      in.need(";");
    } else if (word == ".entry" || word == ".func") {
      Function made;
      made.entry = word == ".entry";
      if (in.take("(")) made.results = parameters(in);
      made.name = in.word();
      if (in.take("(")) made.params = parameters(in);
      while (in.token != "{" && in.token != ";") {
        if (in.take(".maxntid")) {
          made.max_threads = static_cast<int>(in.integer());
          while (in.take(",")) made.max_threads *= static_cast<int>(in.integer());
        } else {
          in.next();
        }
      }
      made.line = in.line();
      if (in.token == ";") {
        in.next();
        functions_.try_emplace(made.name, std::move(made));
      } else {
        made.body = in.braces();
        functions_[made.name] = std::move(made);
      }
      external = false;
    } else if (word == ".file") {
      const int number = static_cast<int>(in.integer());
      std::string file = in.word();
      if (file.size() > 2) files_[number] = file.substr(1, file.size() - 2);
      while (in.take(",")) in.next();
    } else if (word == ".loc") {
      in.rest_of_line();
    } else if (word == ".section") {
      while (in.token != "{") in.next();
      in.braces();
    } else if (word == ".alias" || word == ".pragma") {
      in.statement_end();
    } else if (word == ";") {
    } else {
      in.fail("a directive after '" + word + "'");
    }
  }
}

std::string Module::locate(int line) const {
  auto after = places_.upper_bound(line);
  if (after == places_.begin()) return "";
  const Place& place = (--after)->second;
  const auto named = [&](int file, int at) {
    const auto found = files_.find(file);
    std::string path = found == files_.end() ? "?" : found->second;
    std::size_t cut = path.size();
    for (int part = 0; part < 3 && cut != std::string::npos && cut > 0; ++part) cut = path.rfind('/', cut - 1);
    return (cut == std::string::npos ? path : path.substr(cut + 1)) + ":" + std::to_string(at);
  };
  std::string text = named(place.file, place.line);
  if (place.outer_file > 0) text += ", inlined at " + named(place.outer_file, place.outer_line);
  return text;
}

Function* Module::function(const std::string& name) {
  const auto found = functions_.find(name);
  if (found == functions_.end()) return nullptr;
  Function& function = found->second;
  if (!function.parsed && function.body.data()) parse_body(function, places_);
  return &function;
}

}  // namespace emulate
