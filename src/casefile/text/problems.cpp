// Messages about a case, one line each.
#include "casefile/text/problems.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace softwet {
namespace {

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// Its beginning, where a text is too long for a message.
std::string shortened(const std::string& text) {
  constexpr std::size_t most = 200;
  return text.size() <= most ? text : text.substr(0, most) + "...";
}

}  // namespace

bool Problems::about(const std::string& name) const {
  return std::any_of(kept_.begin(), kept_.end(), [&](const CaseError& error) {
    const std::string& key = error.key;
    if (key.empty() || name.compare(0, key.size(), key) != 0) return false;
    return name.size() == key.size() || name[key.size()] == '.' || name[key.size()] == '[';
  });
}

void Problems::throw_if_any() const {
  if (kept_.empty()) return;
  std::string text;
  for (const CaseError& error : kept_) text += (text.empty() ? "" : "\n") + std::string(error.what());
  if (kept_.size() >= most)
    text += fmt::format("\n{} mistakes are enough for one message, there may be more; correct these first", most);
  throw Error(Exit::invalid_input, text);
}

void Problems::add(const CaseError& error) {
  kept_.push_back(error);
  if (kept_.size() >= most) throw_if_any();
}

void reject(const std::string& place, const std::string& key, const std::string& text, const std::string& problem,
            const std::string& remedy, const std::string& about) {
  const std::string value = text.empty() ? "" : " = " + shortened(text);
  throw CaseError(about.empty() ? key : about,
                  one_line(fmt::format("{}: {}{}: {}; {}", shortened(place), shortened(key), value, problem, remedy)));
}

}  // namespace softwet
