// Words of PTX, one after another.
#pragma once

#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "ptx.hpp"

namespace emulate {

inline bool of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '$' || c == '%' || c == '.';
}

class Reader {
 public:
  Reader(std::string_view text, int line) : text_(text), line_(line) { next(); }
  std::string_view token;  // empty at the end
  int line() const { return line_; }
  std::size_t at() const { return at_; }
  std::size_t begin() const { return token.data() - text_.data(); }
  void next() {
    skip();
    const std::size_t start = at_;
    if (at_ >= text_.size()) {
      token = {};
      return;
    }
    if (text_[at_] == '"') {
      for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
        if (text_[at_] == '\\') ++at_;
      ++at_;
    } else if (of_word(text_[at_])) {
      while (at_ < text_.size() && of_word(text_[at_])) ++at_;
      // "::" within an opcode, such as .shared::cta
      while (at_ + 2 < text_.size() && text_[at_] == ':' && text_[at_ + 1] == ':' && of_word(text_[at_ + 2])) {
        at_ += 2;
        while (at_ < text_.size() && of_word(text_[at_])) ++at_;
      }
    } else {
      ++at_;
    }
    token = text_.substr(start, at_ - start);
  }
  bool take(std::string_view expected) {
    if (token != expected) return false;
    next();
    return true;
  }
  void need(std::string_view expected) {
    if (!take(expected)) fail("expected " + std::string(expected));
  }
  std::string word() {
    std::string found(token);
    next();
    return found;
  }
  std::int64_t integer() {
    const bool minus = take("-");
    const auto value = static_cast<std::int64_t>(bits_of(word()));
    return minus ? -value : value;
  }
  std::uint64_t bits_of(const std::string& text) {
    const char* begin = text.c_str();
    int base = 10;
    if (text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X'))
      begin += 2, base = 16;
    else if (text.size() > 1 && text[0] == '0')
      base = 8;
    return std::strtoull(begin, nullptr, base);
  }
  [[noreturn]] void fail(const std::string& what) {
    throw Problem("PTX, line " + std::to_string(line_) + ": " + what + ", found '" + std::string(token) + "'");
  }
  /// The text between an open brace, which has just been read, and its partner. The next word is the one behind the partner.
  std::string_view braces() {
    const std::size_t start = at_;
    int depth = 1;
    while (at_ < text_.size() && depth > 0) {
      const char c = text_[at_++];
      if (c == '\n') ++line_;
      if (c == '{') ++depth;
      if (c == '}') --depth;
      if (c == '"')
        for (; at_ < text_.size() && text_[at_++] != '"';) {
        }
    }
    const auto inside = text_.substr(start, at_ - 1 - start);
    next();
    return inside;
  }
  void statement_end() {
    while (!token.empty() && token != ";") next();
    next();
  }
  void rest_of_line() {
    const int now = line_;
    while (!token.empty() && line_ == now) next();
  }

 private:
  void skip() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') {
        ++line_, ++at_;
      } else if (c == ' ' || c == '\t' || c == '\r') {
        ++at_;
      } else if (c == '/' && at_ + 1 < text_.size() && text_[at_ + 1] == '/') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else if (c == '/' && at_ + 1 < text_.size() && text_[at_ + 1] == '*') {
        at_ = text_.find("*/", at_) + 2;
      } else {
        return;
      }
    }
  }
  std::string_view text_;
  std::size_t at_ = 0;
  int line_;
};

/// A variable or a parameter behind its space, such as ".align 8 .b8 name[12]"; several names are not written by compilers.
Variable read_variable(Reader& in, Space space);

using SourcePlaces = std::map<int, Module::Place>;
/// Parses the body of a function. Adds to `places` where in the sources its lines come from.
void parse_body(Function& function, SourcePlaces& places);

}  // namespace emulate
