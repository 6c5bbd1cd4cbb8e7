#pragma once

#include <string>
#include <vector>

#include "framework/base/errors.hpp"

namespace dda {

/// A word, number, text in quotes (without them) or sign of gmsh's language.
struct GeoToken {
  enum class Kind { word, number, text, sign };

  Kind kind = Kind::sign;
  std::string text;
  Position where;

  bool is_word(const char* name) const { return kind == Kind::word && text == name; }
  bool is_sign(char sign) const { return kind == Kind::sign && text[0] == sign; }
};

/// The tokens of a .geo file's content. What gmsh would cut otherwise than it looks, texts beyond the length
/// that it takes and zero bytes, is a finding, and ends the list.
std::vector<GeoToken> geo_tokens(const std::string& content, const std::string& file, Findings& findings);

}  // namespace dda
