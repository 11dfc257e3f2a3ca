// A kernel is translated; the functions that it calls are inlined.
#include "program.hpp"

#include <algorithm>

#include "translate.hpp"

namespace emulate {

const char* name_of(Class c) {
  static const char* names[] = {"fp64",        "fp64_div",     "fp32",      "fp32_div",    "integer",
                                "convert",     "move",         "predicate", "load_global", "store_global",
                                "load_shared", "store_shared", "local",     "param",       "atomic",
                                "shuffle",     "barrier",      "branch",    "other"};
  return names[int(c)];
}

void Translator::run(const std::string& name) {
  Function* f = module_.function(name);
  if (!f || !f->body.data()) throw Problem("no kernel " + name + " in the PTX of this module");
  k_.name = name;
  k_.module = &module_;
  k_.max_threads = f->max_threads;
  std::int64_t at = 0;
  for (const Variable& p : f->params) {
    at = (at + p.align - 1) / p.align * p.align;
    params_[p.name] = at;
    k_.params.emplace_back(at, p.bytes());
    at += p.bytes();
  }
  k_.param_bytes = at;
  instances_.push_back({f, true, add_registers(*f), {}, ""});
  place_variables(0);
  inline_function(0, 0);
  labels_["exit#"] = static_cast<int>(steps_.size());
  steps_.emplace_back();
  steps_.back().kind = Step::leave;
  k_.local_bytes = (local_ + 15) / 16 * 16;
  dynamic_at_ = (k_.static_shared + 15) / 16 * 16;
  if (uses_dynamic_) k_.static_shared = dynamic_at_;
  cut();
  place_registers();
  decode();
}

void Translator::fail(const Statement& s, const std::string& what) {
  throw Problem(what + ": '" + s.opcode + "', line " + std::to_string(s.line) + " of the PTX of kernel " + k_.name);
}

int Translator::add_registers(const Function& f) {
  const int first = static_cast<int>(types_.size());
  types_.insert(types_.end(), f.regs.begin(), f.regs.end());
  return first;
}

void Translator::place_variables(int n) {
  Instance& in = instances_[n];
  for (const Variable& v : in.function->variables) {
    if (v.space == Space::local || v.space == Space::param) {
      local_ = (local_ + v.align - 1) / v.align * v.align;
      in.local[v.name] = local_;
      local_ += std::max<std::int64_t>(v.bytes(), 1);
    } else if (v.space == Space::shared) {
      shared_[in.function->name + v.name] = place_shared(v);
    }
  }
}

std::int64_t Translator::place_shared(const Variable& v) {
  k_.static_shared = (k_.static_shared + v.align - 1) / v.align * v.align;
  const std::int64_t at = k_.static_shared;
  k_.static_shared += v.bytes();
  return at;
}

void Translator::note_names(int n, const Operand& o) {
  if (o.kind == Operand::name) {
    if (instances_[n].local.count(o.text) || params_.count(o.text) ||
        shared_.count(instances_[n].function->name + o.text) || shared_.count(o.text))
      return;
    for (const Variable& v : module_.variables())
      if (v.name == o.text && v.space == Space::shared) {
        if (v.external)
          uses_dynamic_ = true;
        else
          shared_[v.name] = place_shared(v);
      }
  }
  for (const Operand& part : o.parts) note_names(n, part);
}

void Translator::inline_function(int n, int depth) {
  if (depth > 24) throw Problem("functions call each other in kernel " + k_.name);
  const std::string prefix = instances_[n].prefix;
  Function* f = instances_[n].function;
  for (const Statement& s : f->statements) {
    if (!s.label.empty()) {
      labels_[prefix + s.label] = static_cast<int>(steps_.size());
      continue;
    }
    const std::string& op = s.words[0];
    for (const Operand& o : s.operands) note_names(n, o);
    Step step;
    step.s = &s;
    step.instance = n;
    step.guard = s.guard < 0 ? -1 : s.guard + instances_[n].first_register;
    step.guard_negated = s.guard_negated;
    if (op == "bra") {
      step.kind = Step::jump;
      step.label = prefix + s.operands.at(0).text;
    } else if (op == "ret" && !instances_[n].kernel) {
      step.kind = Step::jump;
      step.label = prefix + "end#";
    } else if (op == "ret" || op == "exit") {
      step.kind = Step::leave;
    } else if (op == "call") {
      inline_call(n, s, step, depth);
      continue;
    }
    steps_.push_back(std::move(step));
  }
  labels_[prefix + "end#"] = static_cast<int>(steps_.size());
}

void Translator::inline_call(int n, const Statement& s, Step step, int depth) {
  std::size_t at = 0;
  std::vector<std::string> results, arguments;
  if (s.operands[0].kind == Operand::vector) {
    for (const Operand& o : s.operands[0].parts) results.push_back(o.text);
    at = 1;
  }
  if (s.operands.at(at).kind != Operand::name) fail(s, "an indirect call");
  const std::string callee = s.operands[at].text;
  if (at + 1 < s.operands.size())
    for (const Operand& o : s.operands[at + 1].parts) arguments.push_back(o.text);
  const std::string behind = instances_[n].prefix + "call" + std::to_string(steps_.size()) + "#";
  if (step.guard >= 0) {
    Step skip = step;
    skip.kind = Step::jump;
    skip.guard_negated = !step.guard_negated;
    skip.label = behind;
    steps_.push_back(std::move(skip));
  }
  const auto place = [&](const std::string& name) {
    const auto found = instances_[n].local.find(name);
    if (found == instances_[n].local.end()) fail(s, "no parameter " + name);
    return found->second;
  };
  Function* f = module_.function(callee);
  if (!f) fail(s, "no function " + callee);
  if (!f->body.data()) {
    step.kind = Step::host_call;
    step.guard = -1;
    step.call.kind = End::call_host;
    step.call.callee = callee;
    step.call.line = s.line;
    for (const std::string& name : arguments) step.call.arguments.push_back(place(name));
    if (!results.empty()) step.call.answer = place(results[0]);
    steps_.push_back(std::move(step));
  } else {
    const int made = static_cast<int>(instances_.size());
    instances_.push_back({f, false, add_registers(*f), {}, instances_[n].prefix + std::to_string(made) + "/"});
    for (std::size_t k = 0; k < f->params.size(); ++k)
      instances_[made].local[f->params[k].name] = place(arguments.at(k));
    for (std::size_t k = 0; k < f->results.size() && k < results.size(); ++k)
      instances_[made].local[f->results[k].name] = place(results[k]);
    place_variables(made);
    inline_function(made, depth + 1);
  }
  labels_[behind] = static_cast<int>(steps_.size());
}

void translate(Module& module, const Symbols& symbols, const std::string& name, Kernel& kernel) {
  Translator(module, symbols, kernel).run(name);
}

}  // namespace emulate
