// Instructions get their operands and functions.
#include <algorithm>
#include <map>
#include <string_view>

#include "lanes.hpp"
#include "translate.hpp"

namespace emulate {

void Translator::decode() {
  const int blocks = static_cast<int>(successors_.size());
  for (int b = 0; b < blocks; ++b) {
    BasicBlock made;
    made.begin = static_cast<std::uint32_t>(k_.code.size());
    for (int k = firsts_[b]; k < firsts_[b + 1]; ++k) {
      const Step& step = steps_[k];
      if (ends_block(step)) {
        end(step, b, made);
      } else {
        Instruction i = instruction(step);
        ++made.classes[int(i.kind)];
        k_.code.push_back(i);
      }
    }
    made.end = static_cast<std::uint32_t>(k_.code.size());
    k_.blocks.push_back(std::move(made));
  }
}

void Translator::end(const Step& step, int b, BasicBlock& made) {
  End& last = made.last;
  last.line = step.s ? step.s->line : 0;
  if (step.guard >= 0) {
    last.guard = place_of_[step.guard];
    last.guard_negated = step.guard_negated;
  }
  if (step.kind == Step::jump) {
    last.kind = End::branch;
    last.target = successors_[b][0];
    ++made.classes[int(Class::branch)];
    return;
  }
  if (step.kind == Step::leave) {
    last.kind = End::exit;
    ++made.classes[int(Class::branch)];
    return;
  }
  if (step.kind == Step::host_call) {
    last = step.call;
    return;
  }
  const Statement& s = *step.s;
  const int n = step.instance;
  const std::string& op = s.words[0];
  if (op == "trap" || op == "brkpt") {
    last.kind = End::trap;
  } else if (op == "brx") {
    last.kind = End::table;
    last.value = place(s, n, s.operands[0], 4);
    last.targets = successors_[b];
    ++made.classes[int(Class::branch)];
  } else if (is_barrier(op, s)) {
    end_with_barrier(step, made);
  } else {
    end_with_sync(step, made);
  }
}

/// A barrier of the block of threads.
void Translator::end_with_barrier(const Step& step, BasicBlock& made) {
  End& last = made.last;
  const Statement& s = *step.s;
  const int n = step.instance;
  last.kind = End::barrier;
  last.ordinal = barriers_++;
  ++made.classes[int(Class::barrier)];
  std::size_t at = 0;
  if (s.has("red")) {
    last.reduction = s.has("popc") ? 0 : s.has("and") ? 1 : 2;
    last.result = result(n, s.operands[at++]);
    const Operand& value = s.operands.back();
    last.value = place(s, n, value, 4);
    last.value_negated = value.negated;
  }
  if (s.has("arrive")) fail(s, "not known");
  last.id = place(s, n, s.operands.at(at++), 4);
  if (at + (last.reduction >= 0 ? 1 : 0) < s.operands.size()) {
    last.has_threads = true;
    last.threads = place(s, n, s.operands[at], 4);
  }
}

/// Lanes of a warp that do something together.
void Translator::end_with_sync(const Step& step, BasicBlock& made) {
  End& last = made.last;
  const Statement& s = *step.s;
  const int n = step.instance;
  const std::string& op = s.words[0];
  last.kind = End::warp_sync;
  Instruction& i = last.sync;
  i.line = s.line;
  i.opcode = s.opcode.c_str();
  ++made.classes[int(op == "bar" || op == "barrier" ? Class::barrier : Class::shuffle)];
  static const std::map<std::string_view, int> ops = {{"up", 0},   {"down", 1}, {"bfly", 2}, {"idx", 3},
                                                      {"all", 10}, {"any", 11}, {"uni", 12}, {"ballot", 13}};
  i.op = 255;
  for (const auto& word : s.words)
    if (const auto found = ops.find(word); found != ops.end()) i.op = static_cast<std::uint8_t>(found->second);
  if (op == "bar" || op == "barrier") {
    i.op = 20;
    last.members = place(s, n, s.operands.at(0), 4);
  } else if (op == "shfl") {
    std::size_t at = 0;
    i.d = result(n, s.operands[at++]);
    if (s.operands[at].second) i.d2 = result(n, s.operands[at++]);
    i.a = place(s, n, s.operands.at(at++), 4);
    i.b = place(s, n, s.operands.at(at++), 4);
    i.c = place(s, n, s.operands.at(at++), 4);
    last.members = place(s, n, s.operands.at(at), 4);
  } else if (op == "vote") {
    i.d = result(n, s.operands[0]);
    i.a = place(s, n, s.operands.at(1), 4);
    i.number = s.operands[1].negated;
    last.members = place(s, n, s.operands.at(2), 4);
  } else if (op == "match") {
    std::size_t at = 0;
    i.op = s.has("any") ? 30 : 31;
    i.d = result(n, s.operands[at++]);
    if (s.operands[at].second) i.d2 = result(n, s.operands[at++]);
    i.bytes = s.has("b64") ? 8 : 4;
    i.a = place(s, n, s.operands.at(at++), i.bytes);
    last.members = place(s, n, s.operands.at(at), 4);
  } else if (op == "redux") {
    static const std::map<std::string_view, int> reductions = {{"add", 40}, {"min", 41}, {"max", 42},
                                                               {"and", 43}, {"or", 44},  {"xor", 45}};
    for (const auto& word : s.words)
      if (const auto found = reductions.find(word); found != reductions.end())
        i.op = static_cast<std::uint8_t>(found->second);
    i.number = s.has("s32");
    i.d = result(n, s.operands[0]);
    i.a = place(s, n, s.operands.at(1), 4);
    last.members = place(s, n, s.operands.at(2), 4);
  } else {
    fail(s, "not known");
  }
  if (i.op == 255) fail(s, "not known");
}

/// A load, a store or an atomic.
void Translator::set_access(const Step& step, Instruction& i) {
  const Statement& s = *step.s;
  const int n = step.instance;
  const std::string& op = s.words[0];
  const auto& o = s.operands;
  const std::size_t where = op == "st" || op == "red" ? 0 : 1;
  const Operand& target = o.at(where);
  const Operand& base = target.parts.at(0);
  i.number = target.offset;
  int address_bytes = 8;
  if (base.kind == Operand::reg) {
    i.a = {0, place_of_[base.reg_index + instances_[n].first_register]};
    address_bytes = width(n, base);
  } else {
    if (base.kind == Operand::name) i.number -= base.offset;
    i.a = place(s, n, base, 8);
  }
  const bool has_value = op != "ld" && op != "ldu";
  const std::size_t value_at = op == "st" || op == "red" ? 1 : 2;
  const Operand* value = op == "ld" || op == "ldu" ? &o[0] : &o.at(value_at);
  const bool vector = value->kind == Operand::vector;
  int bytes = 0;
  const Type type = [&] {
    for (auto word = s.words.rbegin(); word != s.words.rend(); ++word)
      if (const auto t = type_named(*word)) return *t;
    return Type::none;
  }();
  const auto of = [&](const Operand& one) {
    if (one.kind == Operand::reg) bytes = std::max(bytes, width(n, one));
  };
  if (vector)
    for (const Operand& part : value->parts) of(part);
  else
    of(*value);
  if (bytes == 0) bytes = std::max(4, size_of(type));
  if (!choose_access(s, i, bytes, address_bytes)) fail(s, "not known");
  const bool loads = op == "ld" || op == "ldu";
  if (vector) {
    i.more = static_cast<std::uint32_t>(k_.further.size());
    if (static_cast<int>(value->parts.size()) != i.width) fail(s, "a vector");
    for (const Operand& part : value->parts)
      k_.further.push_back(loads ? Place{0, result(n, part)} : place(s, n, part, bytes));
  } else if (loads) {
    i.d = result(n, *value);
  } else if (has_value) {
    i.b = place(s, n, *value, bytes);
  }
  if (op == "atom") i.d = result(n, o[0]);
  if ((op == "atom" || op == "red") && value_at + 1 < o.size()) i.c = place(s, n, o[value_at + 1], bytes);
  if (i.space == Space::param)
    i.param_is_local = !(instances_[n].kernel && (base.kind != Operand::name || params_.count(base.text)));
}

Instruction Translator::instruction(const Step& step) {
  const Statement& s = *step.s;
  const int n = step.instance;
  const std::string& op = s.words[0];
  Instruction i;
  i.line = s.line;
  i.opcode = s.opcode.c_str();
  if (step.guard >= 0) {
    i.guard = place_of_[step.guard];
    i.guard_negated = step.guard_negated;
  }
  const auto& o = s.operands;
  if (op == "ld" || op == "ldu" || op == "st" || op == "atom" || op == "red") {
    set_access(step, i);
    return i;
  }
  if (op == "mov" && (o[0].kind == Operand::vector || o[1].kind == Operand::vector)) {
    const bool joins = o[1].kind == Operand::vector;
    const Operand& parts = joins ? o[1] : o[0];
    i.op = joins ? 1 : 2;
    i.width = static_cast<std::uint8_t>(parts.parts.size());
    const int bytes = s.has("b128") ? 16 : s.has("b64") ? 8 : 4;
    if (bytes == 16) fail(s, "not known");
    i.bytes = static_cast<std::uint8_t>(bytes / i.width);
    i.more = static_cast<std::uint32_t>(k_.further.size());
    for (const Operand& part : parts.parts)
      k_.further.push_back(joins ? place(s, n, part, 4) : Place{0, result(n, part)});
    if (joins)
      i.d = result(n, o[0]);
    else
      i.a = place(s, n, o[1], bytes);
  } else if (op == "activemask") {
    i.d = result(n, o[0]);
    i.kind = Class::other;
    i.full = i.part = [](Warp& w, const Instruction& self, std::uint32_t mask) {
      auto* d = target<std::uint32_t>(w, self.d);
      for (std::uint32_t m = mask; m; m &= m - 1) d[std::countr_zero(m)] = mask;
    };
    return i;
  } else if (op == "lop3" && o.size() == 5) {
    i.d = result(n, o[0]);
    i.a = place(s, n, o[1], 4), i.b = place(s, n, o[2], 4), i.c = place(s, n, o[3], 4);
    i.number = static_cast<std::int64_t>(o[4].bits);
  } else if (!no_result(op)) {
    std::size_t at = 0;
    i.d = result(n, o[at++]);
    if (at < o.size() && o[at].second) i.d2 = result(n, o[at++]);
    const std::size_t shift = at - 1;
    Place* all[] = {&i.a, &i.b, &i.c, &i.e};
    for (int k = 0; at < o.size() && k < 4; ++k, ++at) {
      if (o[at].kind == Operand::vector) fail(s, "not known");
      *all[k] = place(s, n, o[at], number_bytes(s, at - shift));
    }
    for (const Operand& one : o)
      if (one.negated && op != "setp" && op != "selp") fail(s, "a negated operand");
    if (i.d == nowhere && i.d2 == nowhere) {  // nobody reads it
      i.full = i.part = [](Warp&, const Instruction&, std::uint32_t) {};
      return i;
    }
  }
  std::vector<int> widths;
  for (const Operand& one : o)
    widths.push_back(one.kind == Operand::reg ? width(n, one)
                                              : std::max(4, one.kind == Operand::number ? number_bytes(s, 1) : 4));
  if (!choose_arithmetic(s, i, widths)) fail(s, "not known");
  return i;
}

}  // namespace emulate
