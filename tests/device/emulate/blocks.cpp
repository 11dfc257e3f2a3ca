// The code of a kernel is cut into blocks, which end where lanes may part, meet or end.
#include <algorithm>

#include "translate.hpp"

namespace emulate {

bool is_sync(const std::string& op, const Statement& s) {
  return op == "shfl" || op == "vote" || op == "match" || op == "redux" || op == "elect" ||
         ((op == "bar" || op == "barrier") && s.has("warp"));
}
bool is_barrier(const std::string& op, const Statement& s) {
  return (op == "bar" || op == "barrier") && !s.has("warp");
}
bool no_result(const std::string& op) {
  static const char* all[] = {
      "st",   "red",  "bra",   "bar", "barrier",   "membar", "fence",          "prefetch", "prefetchu",     "ret",
      "exit", "trap", "brkpt", "brx", "nanosleep", "call",   "griddepcontrol", "discard",  "applypriority", "pmevent"};
  return std::find(std::begin(all), std::end(all), op) != std::end(all);
}

int Translator::label(const Statement& s, const std::string& name) {
  const auto found = labels_.find(name);
  if (found == labels_.end()) fail(s, "no label " + name);
  return found->second;
}

bool Translator::ends_block(const Step& step) const {
  if (step.kind != Step::statement) return true;
  const std::string& op = step.s->words[0];
  return op == "trap" || op == "brkpt" || op == "brx" || is_sync(op, *step.s) || is_barrier(op, *step.s);
}

bool Translator::alone(const Step& step) const {
  if (step.kind == Step::host_call) return true;
  if (step.kind != Step::statement) return false;
  const std::string& op = step.s->words[0];
  return is_sync(op, *step.s) || is_barrier(op, *step.s);
}

void Translator::cut() {
  const int count = static_cast<int>(steps_.size());
  std::vector<char> begins(count + 1, 0);
  begins[0] = 1;
  for (const auto& [name, at] : labels_) begins[at] = 1;
  for (int k = 0; k < count; ++k) {
    if (ends_block(steps_[k])) begins[k + 1] = 1;
    if (alone(steps_[k])) begins[k] = 1;
  }
  block_of_.assign(count + 1, 0);
  for (int k = 0; k < count; ++k) {
    if (begins[k]) firsts_.push_back(k);
    block_of_[k] = static_cast<int>(firsts_.size()) - 1;
  }
  block_of_[count] = static_cast<int>(firsts_.size());
  firsts_.push_back(count);
  const int blocks = static_cast<int>(firsts_.size()) - 1;
  successors_.resize(blocks);
  for (int b = 0; b < blocks; ++b) {
    const Step& last = steps_[firsts_[b + 1] - 1];
    const bool guarded = last.guard >= 0;
    if (last.kind == Step::jump) {
      successors_[b].push_back(block_of_[label(*last.s, last.label)]);
      if (guarded) successors_[b].push_back(b + 1);
    } else if (last.kind == Step::leave) {
      if (guarded) successors_[b].push_back(b + 1);
    } else if (last.kind == Step::statement && last.s->words[0] == "brx") {
      for (const std::string& name : table(last))
        successors_[b].push_back(block_of_[label(*last.s, instances_[last.instance].prefix + name)]);
    } else if (b + 1 < blocks) {
      successors_[b].push_back(b + 1);
    }
  }
}

const std::vector<std::string>& Translator::table(const Step& step) {
  const auto& targets = instances_[step.instance].function->targets;
  const auto found = targets.find(step.s->operands.at(1).text);
  if (found == targets.end()) fail(*step.s, "no table of targets");
  return found->second;
}

}  // namespace emulate
