#pragma once

#include <array>
#include <charconv>
#include <string>

namespace dda {

/// The shortest decimal text that reads back to exactly the same number; "nan" and "inf" where it is none.
inline std::string shortest(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

}  // namespace dda
