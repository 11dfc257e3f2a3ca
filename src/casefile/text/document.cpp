// TOML text to a Document.
#include "casefile/text/document.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "case/error.hpp"
#include "casefile/text/syntax_hint.hpp"
#include "casefile/text/walker.hpp"

namespace softwet {
namespace {

/// Keeps what is wrong with a line that is no TOML, and empties it so that the rest can be read. Throws where nothing
/// better is known than what the library says.
void take_out_line(std::string& text, const std::string& place, long line, std::string_view problem,
                   Problems& problems) {
  const std::string where = fmt::format("{}:{}", place, line);
  const auto hint = syntax_hint(text, line);
  problems.keep([&] {
    if (hint) reject(where, hint->key, hint->value, hint->problem, hint->remedy);
    if (problem.find("redefine") != std::string_view::npos)
      reject(where, std::string(problem), "", "a key or table appears twice",
             "keep one of them; where there are several loads, each begins with [[load]]");
    reject(where, "this is not TOML", "", std::string(problem), "see 'softwet init' for a case to start from");
  });
  if (!hint) problems.throw_if_any();
  std::size_t begin = 0;
  for (long number = 1; number < line; ++number) begin = text.find('\n', begin) + 1;
  text.erase(begin, std::min(text.find('\n', begin), text.size()) - begin);
}

bool is_malformed(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const MalformedToml&) {
    return true;
  } catch (const toml::parse_error&) {
  }
  return false;
}

/// The line at which the library gave up without saying where: the shortest beginning of the text with that fate. It
/// reads from the front, so longer beginnings share the fate and the line is found by bisection.
long line_of_malformed(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n', end + 1))
    ends.push_back(end + 1);
  const auto healthy = [&](std::size_t end) { return !is_malformed(text.substr(0, end)); };
  return 1 + (std::partition_point(ends.begin(), ends.end(), healthy) - ends.begin());
}

toml::table parse_file(std::string text, const std::string& place, Problems& problems) {
  for (;;) {  // each turn takes a line out, and the number of problems is limited
    try {
      return toml::parse(text, place);
    } catch (const toml::parse_error& error) {
      take_out_line(text, place, static_cast<long>(error.source().begin.line), error.description(), problems);
    } catch (const MalformedToml& error) {
      take_out_line(text, place, line_of_malformed(text), error.what(), problems);
    }
  }
}

/// Some editors save in UTF-16: a mark of two bytes at the beginning, or a zero in every second byte.
void refuse_other_encodings(std::string_view text, const std::string& place) {
  const std::string_view mark = text.substr(0, 2), zeros = text.substr(0, 200);
  const bool marked = mark == "\xff\xfe" || mark == "\xfe\xff";
  if (marked || (zeros.find('\0') < 2 && zeros.size() > 3 && zeros[0] != zeros[1]))
    throw Error(
        Exit::invalid_input,
        fmt::format(
            "{}: the file is in UTF-16; save it in UTF-8, for example with 'iconv -f UTF-16 -t UTF-8 {} > new.toml'",
            place, place));
  if (text.find('\0') != std::string_view::npos)
    throw Error(Exit::invalid_input, fmt::format("{}: the file is not text, it holds bytes that are zero; give the "
                                                 "path of a case, for example cases/tensotaxis_pull_2d.toml",
                                                 place));
}

}  // namespace

Document read_document(std::string_view text, const std::string& place, Problems& problems) {
  refuse_other_encodings(text, place);
  Document document;
  document.place = place;
  const toml::table table = parse_file(std::string(text), place, problems);
  if (table.empty()) {
    problems.throw_if_any();
    throw Error(Exit::invalid_input,
                fmt::format("{}: the file is empty; 'softwet init FILE' writes a complete case to start from", place));
  }
  Walker(document, place, Lines::counted, problems).walk(table, "", 0);
  return document;
}

}  // namespace softwet
