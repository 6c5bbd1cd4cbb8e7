#include "meshing/files/geo_tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace dda {
namespace {

constexpr std::size_t longest_text = 1023;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

class Scanner {
 public:
  Scanner(const std::string& content, const std::string& file) : content_(content), file_(file) {}

  bool at_end() {
    skip();
    return at_ >= content_.size();
  }
  GeoToken next() {
    const Position where = here();
    const char c = content_[at_];
    if (c == '"' || c == '\'') return quoted(c, where);
    const std::size_t begin = at_;
    if (is_letter(c)) {
      while (is_letter(peek()) || is_digit(peek())) step();
      return {GeoToken::Kind::word, content_.substr(begin, at_ - begin), where};
    }
    if (is_digit(c)) {
      pass_number();
      return {GeoToken::Kind::number, content_.substr(begin, at_ - begin), where};
    }
    step();
    return {GeoToken::Kind::sign, std::string(1, c), where};
  }

 private:
  Position here() const { return {file_, line_, static_cast<int>(at_ - line_begin_) + 1}; }
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < content_.size() ? content_[at_ + ahead] : '\0';
  }
  void step() {
    if (content_[at_++] != '\n') return;
    ++line_;
    line_begin_ = at_;
  }
  void step_to(std::size_t end) {
    while (at_ < std::min(end, content_.size())) step();
  }
  void skip() {
    for (;;) {
      const std::size_t begin = at_;
      while (is_space(peek())) step();
      if (peek() == '/' && peek(1) == '/') step_to(content_.find('\n', at_));
      if (peek() == '/' && peek(1) == '*') {
        const std::size_t end = content_.find("*/", at_ + 2);
        step_to(end == std::string::npos ? end : end + 2);
      }
      if (at_ == begin) return;
    }
  }
  void pass_number() {
    while (is_digit(peek())) step();
    if (peek() == '.') step();
    while (is_digit(peek())) step();
    if (peek() != 'e' && peek() != 'E') return;
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if (!is_digit(peek(1 + sign))) return;
    step_to(at_ + 1 + sign);
    while (is_digit(peek())) step();
  }
  GeoToken quoted(char quote, const Position& where) {
    const std::size_t begin = at_ + 1, end = std::min(content_.find(quote, begin), content_.size());
    if (end - begin > longest_text)
      throw InputError(where, fmt::format("a text of more than {} letters, which gmsh cuts", longest_text));
    step_to(end + 1);
    return {GeoToken::Kind::text, content_.substr(begin, end - begin), where};
  }

  const std::string& content_;
  const std::string& file_;
  std::size_t at_ = 0, line_begin_ = 0;
  int line_ = 1;
};

}  // namespace

std::vector<GeoToken> geo_tokens(const std::string& content, const std::string& file, Findings& findings) {
  std::vector<GeoToken> out;
  if (content.find('\0') != std::string::npos) {
    findings.add({file, 0, 0}, "is no text: it has zero bytes");
    return out;
  }
  Scanner scanner(content, file);
  try {
    while (!scanner.at_end()) out.push_back(scanner.next());
  } catch (const InputError& error) {
    findings.add(error);
  }
  return out;
}

}  // namespace dda
