// Bodies of functions of PTX: their statements, registers and variables.
#include <charconv>

#include "reader.hpp"

namespace emulate {

namespace {

class BodyParser {
 public:
  BodyParser(Function& function, SourcePlaces& places)
      : f_(function), in_(function.body, function.line), places_(places) {}
  void parse() {
    scopes_.emplace_back();
    while (!in_.token.empty()) statement();
    f_.parsed = true;
  }

 private:
  void statement() {
    if (in_.take(";")) return;
    if (in_.take("{")) {
      scopes_.emplace_back();
      return;
    }
    if (in_.take("}")) {
      scopes_.pop_back();
      return;
    }
    if (in_.token.starts_with('.')) return directive();
    Statement made;
    made.line = in_.line();
    if (in_.take("@")) {
      made.guard_negated = in_.take("!");
      made.guard = reg(in_.word());
    }
    made.opcode = in_.word();
    if (in_.take(":")) {
      if (in_.token == ".callprototype" || in_.token == ".branchtargets") {
        const bool branches = in_.token == ".branchtargets";
        in_.next();
        if (!branches) return in_.statement_end();
        auto& list = f_.targets[made.opcode];
        while (in_.token != ";") {
          list.push_back(in_.word());
          in_.take(",");
        }
        return;
      }
      made.label = made.opcode;
      f_.statements.push_back(std::move(made));
      return;
    }
    std::size_t start = 0;
    for (;;) {
      const std::size_t end = made.opcode.find('.', start);
      made.words.push_back(made.opcode.substr(start, end - start));
      if (end == std::string::npos) break;
      start = end + 1;
    }
    while (in_.token != ";") {
      if (in_.token.empty()) in_.fail("an instruction has no end");
      made.operands.push_back(operand());
      if (in_.token == "|") {  // a second destination
        in_.next();
        made.operands.push_back(operand());
        made.operands.back().second = true;
      }
      in_.take(",");
    }
    in_.next();
    f_.statements.push_back(std::move(made));
  }
  void directive() {
    const std::string name = in_.word();
    if (name == ".reg") {
      while (in_.token.starts_with('.') && !type_named(in_.token.substr(1))) in_.next();  // .v2 does not occur
      const auto type = type_named(std::string_view(in_.token).substr(1));
      if (!type) in_.fail("a register's type");
      in_.next();
      do {
        const std::string base = in_.word();
        if (in_.take("<")) {
          const int count = static_cast<int>(in_.integer());
          in_.need(">");
          scopes_.back().ranges.push_back({base, static_cast<int>(f_.regs.size()), count});
          f_.regs.insert(f_.regs.end(), static_cast<std::size_t>(count), *type);
        } else {
          scopes_.back().single[base] = static_cast<int>(f_.regs.size());
          f_.regs.push_back(*type);
        }
      } while (in_.take(","));
      in_.need(";");
    } else if (name == ".local" || name == ".shared" || name == ".param" || name == ".const" || name == ".global") {
      const Space space = name == ".local"    ? Space::local
                          : name == ".shared" ? Space::shared
                          : name == ".param"  ? Space::param
                          : name == ".const"  ? Space::constant
                                              : Space::global;
      Variable made = read_variable(in_, space);
      const std::string unique = made.name + "#" + std::to_string(f_.variables.size());
      scopes_.back().variables[made.name] = unique;
      made.name = unique;
      f_.variables.push_back(std::move(made));
      in_.need(";");
    } else if (name ==
               ".loc") {  // .loc file line column[, function_name label[ + number], inlined_at file line column]
      const int now = in_.line();
      Module::Place place;
      place.file = static_cast<int>(in_.integer());
      place.line = static_cast<int>(in_.integer());
      in_.next();
      while (!in_.token.empty() && in_.line() == now) {
        if (in_.take("inlined_at")) {
          place.outer_file = static_cast<int>(in_.integer());
          place.outer_line = static_cast<int>(in_.integer());
        }
        in_.next();
      }
      places_[now] = place;
    } else if (name == ".file") {
      in_.rest_of_line();
    } else {
      in_.statement_end();  // .pragma and others
    }
  }
  int reg_or_none(const std::string& name) const {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
      if (const auto found = scope->single.find(name); found != scope->single.end()) return found->second;
      for (const auto& range : scope->ranges) {
        if (name.size() <= range.base.size() || name.compare(0, range.base.size(), range.base) != 0) continue;
        int number = 0;
        const char* end = name.data() + name.size();
        if (std::from_chars(name.data() + range.base.size(), end, number).ptr == end && number < range.count)
          return range.first + number;
      }
    }
    return -1;
  }
  int reg(const std::string& name) {
    const int found = reg_or_none(name);
    if (found < 0) in_.fail("no register " + name);
    return found;
  }
  std::string variable_name(const std::string& name) const {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
      if (const auto found = scope->variables.find(name); found != scope->variables.end()) return found->second;
    return name;
  }
  Operand operand() {
    Operand made;
    if (in_.take("[")) {
      made.kind = Operand::address;
      made.parts.push_back(operand());
      while (!in_.take("]")) {
        if (in_.take("+"))
          made.offset += in_.integer();
        else if (in_.token == "-")
          made.offset += in_.integer();
        else
          in_.fail("an address");
      }
      made.offset += made.parts[0].offset;
      return made;
    }
    if (in_.token == "{" || in_.token == "(") {
      const char* end = in_.token == "{" ? "}" : ")";
      in_.next();
      made.kind = Operand::vector;
      while (!in_.take(end)) {
        made.parts.push_back(operand());
        in_.take(",");
      }
      return made;
    }
    if (in_.take("!")) {
      made = operand();
      made.negated = true;
      return made;
    }
    if (in_.token == "-" || std::isdigit(static_cast<unsigned char>(in_.token[0]))) {
      made.kind = Operand::number;
      const bool minus = in_.take("-");
      const std::string text = in_.word();
      if (text.size() > 2 && text[0] == '0' && (text[1] == 'd' || text[1] == 'D')) {
        made.bits = std::strtoull(text.c_str() + 2, nullptr, 16);
      } else if (text.size() > 2 && text[0] == '0' && (text[1] == 'f' || text[1] == 'F')) {
        made.bits = std::strtoull(text.c_str() + 2, nullptr, 16);
      } else {
        made.bits = in_.bits_of(text);
        if (minus) made.bits = -made.bits;
      }
      return made;
    }
    const std::string text = in_.word();
    if (text == "_") {
      made.kind = Operand::sink;
      return made;
    }
    if (const int found = reg_or_none(text); found >= 0) {
      made.kind = Operand::reg;
      made.reg_index = found;
      return made;
    }
    if (text[0] == '%') {
      made.kind = Operand::special;
      made.text = text;
      return made;
    }
    made.kind = Operand::name;
    made.text = variable_name(text);
    if (in_.token == "+") {
      in_.next();
      made.offset = in_.integer();
    }
    return made;
  }
  struct Range {
    std::string base;
    int first, count;
  };
  struct Scope {
    std::map<std::string, int> single;
    std::vector<Range> ranges;
    std::map<std::string, std::string> variables;
  };
  Function& f_;
  Reader in_;
  SourcePlaces& places_;
  std::vector<Scope> scopes_;
};

}  // namespace

void parse_body(Function& function, SourcePlaces& places) { BodyParser(function, places).parse(); }

}  // namespace emulate
