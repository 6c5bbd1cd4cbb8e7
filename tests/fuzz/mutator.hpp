#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace dda::fuzz {

/// Changes texts and bytes at random, the same way for the same seed on every machine.
class Mutator {
 public:
  /// `words` are tokens of the whole corpus, which land where they do not belong.
  Mutator(std::uint64_t seed, const std::vector<std::string>& words) : random_(seed), words_(words) {}

  /// One to a few changes of words, lines or bytes.
  std::string mutated(std::string text, bool is_binary) {
    const std::size_t changes = below(2) == 0 ? 1 : std::size_t{1} << below(4);
    for (std::size_t i = 0; i < changes; ++i)
      is_binary || below(8) == 0 ? change_bytes(text) : change_words(text);
    return text;
  }

  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }

 private:
  void change_bytes(std::string& text) {
    const std::size_t at = below(text.size()), length = std::min(below(64) + 1, text.size() - at);
    switch (below(6)) {
      case 0:
        if (!text.empty()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        if (!text.empty()) text[at] = static_cast<char>(random_());
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), length));
        break;
      case 4:
        text.resize(below(8) == 0 ? at : text.size());
        break;
      default:
        for (std::size_t i = at; i < at + length; ++i) text[i] = static_cast<char>(below(2) ? 0 : random_());
    }
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_word(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' ||
           c == '-' || c == '+';
  }

  void change_words(std::string& text) {
    if (text.empty()) return;
    if (below(8) == 0) return change_line(text);
    const bool is_number_wanted = below(3) > 0;
    std::size_t begin = below(text.size());
    while (begin < text.size() && !(is_number_wanted ? is_digit(text[begin]) : is_word(text[begin]))) ++begin;
    if (begin == text.size()) return;
    while (begin > 0 && is_word(text[begin - 1])) --begin;
    std::size_t end = begin;
    while (end < text.size() && is_word(text[end])) ++end;
    const bool is_number = end > begin && (text[begin] < 'A') && below(8) > 0;
    const std::string old = text.substr(begin, end - begin);
    text.replace(begin, old.size(), is_number ? number(old) : words_[below(words_.size())]);
  }

  void change_line(std::string& text) {
    std::size_t begin = text.rfind('\n', below(text.size()));
    begin = begin == std::string::npos ? 0 : begin + 1;
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string line = text.substr(begin, end - begin);
    if (below(3) == 0) text.insert(begin, std::string(below(4), ' '));
    if (below(2) == 0) text.erase(begin, line.size());
    text.insert(below(2) ? begin : below(text.size()), line);
  }

  /// Near the old one, so that much of it stays valid, or one of those that are seldom right.
  std::string number(const std::string& old) {
    static const std::vector<std::string> factors{"0.1", "0.5", "0.9", "1.0001", "2", "3", "10", "-1"};
    char* end = nullptr;
    const double value = std::strtod(old.c_str(), &end);
    if (below(2) == 0 && *end == 0)
      return std::to_string(value * std::strtod(factors[below(factors.size())].c_str(), nullptr));
    static const std::vector<std::string> numbers{
        "0",     "-0",     "1",        "-1",         "2",
        "1e-12", "1e-300", "1e12",     "1e49",       "-1e49",
        "1e308", "nan",    "inf",      ".5",         "1e",
        "0x10",  "100",    "1000000",  "2147483648", "9223372036854775807",
        "0.1",   "-0.25",  "1e-5",     "1e5",        "3.3",
        "'1'",   "[1]",    "{a: 1}",   "~",          "18446744073709551616",
        "45",    "90",     "0.5",      "1e-3",       "1000",
        "10",    "20",     "50.00001", "99.9999999", "1.0000000001"};
    return numbers[below(numbers.size())];
  }

  std::mt19937_64 random_;
  const std::vector<std::string>& words_;
};

}  // namespace dda::fuzz
