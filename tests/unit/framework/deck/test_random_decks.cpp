#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string_view>

#include "unit/framework/deck/deck_example.hpp"

namespace dda {
namespace {

/// One edit of a text: a letter replaced, inserted or deleted, a piece repeated, a word of YAML put in.
std::string edited(std::string text) {
  static const std::vector<std::string> words = {
      "{", "}",  "[", "]", ": ", "- ",   "\n",    "\t", "&a ",   "*a", "!!",   "|\n",
      "'", "\"", "#", "%", "0",  ".nan", "1e999", "~",  "---\n", "? ", "<<: ", "\x80"};
  const auto at = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
  const auto length = *rc::gen::inRange<std::size_t>(0, 20);
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return text.insert(at, *rc::gen::elementOf(words));
    case 1:
      return text.erase(at, length);
    case 2:
      return text.insert(at, text.substr(at, length));
    default:
      return text.replace(at, at < text.size() ? 1 : 0, 1, *rc::gen::arbitrary<char>());
  }
}

/// A deck is read or refused with at least one finding; nothing else may happen.
bool is_read_or_refused(const std::string& text) {
  try {
    const auto deck = example::deck_schema().read(parse_yaml(text, "random.yaml"));
    example::deck_schema().read(parse_yaml(to_yaml(example::deck_schema().echo(deck)), "echo.yaml"));
    return true;
  } catch (const InputError& error) {
    return !error.findings().empty() && error.findings()[0].where.file == "random.yaml";
  }
}

RC_GTEST_PROP(RandomDecks, EditedDecksAreReadOrRefused, ()) {
  std::string text = example::full_deck;
  const int edits = *rc::gen::inRange(1, 6);
  for (int i = 0; i < edits; ++i) text = edited(text);
  RC_ASSERT(is_read_or_refused(text));
}

RC_GTEST_PROP(RandomDecks, NoiseIsReadOrRefused, (std::string text)) { RC_ASSERT(is_read_or_refused(text)); }

}  // namespace
}  // namespace dda
