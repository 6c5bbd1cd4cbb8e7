#include "framework/base/suggestion.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace dda {

namespace {

std::string enumerate(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_last = i > 0 && i + 1 == names.size();
    text += (i == 0 ? "" : is_last ? " and " : ", ") + names[i];
  }
  return text;
}

bool is_near(const std::string& name, const std::string& other) {
  const std::size_t distance = edit_distance(name, other);
  return distance <= std::max<std::size_t>(2, name.size() / 3) &&
         distance < std::max(name.size(), other.size());
}

/// But for capitals.
bool is_same_word(const std::string& a, const std::string& b) {
  return std::ranges::equal(
      a, b, {}, [](unsigned char c) { return std::tolower(c); },
      [](unsigned char c) { return std::tolower(c); });
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& names) {
  if (names.empty()) return {};
  for (const std::string& known : names)
    if (known != name && is_same_word(known, name)) return "; did you mean '" + known + "'?";
  const auto nearer = [&](const std::string& x, const std::string& y) {
    return edit_distance(name, x) < edit_distance(name, y);
  };
  const std::string& best = *std::min_element(names.begin(), names.end(), nearer);
  return is_near(name, best) ? "; did you mean '" + best + "'?" : "";
}

std::string suggest(const std::string& name, const std::vector<std::string>& names) {
  if (names.empty()) return "; there are none to choose from";
  if (std::string near = did_you_mean(name, names); !near.empty()) return near;
  return (names.size() == 1 ? "; known is " : "; known are ") + enumerate(names);
}

}  // namespace dda
