#include "meshing/files/geo_constants.hpp"

#include <fstream>
#include <iterator>

#include "meshing/files/geo_tokens.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

using Tokens = std::vector<GeoToken>;

/// DefineConstant[ a = 1, b = {2, Name "..."}, c ]: a word begins each entry of the outermost list.
void add_constants(const Tokens& tokens, std::size_t i, std::set<std::string>& out) {
  int depth = 0;
  for (++i; i < tokens.size() && !tokens[i].is_sign(';'); ++i) {
    const GeoToken& token = tokens[i];
    const bool opens = token.is_sign('[') || token.is_sign('(') || token.is_sign('{');
    const bool closes = token.is_sign(']') || token.is_sign(')') || token.is_sign('}');
    depth += opens ? 1 : closes ? -1 : 0;
    const bool begins = depth == 1 && (opens || token.is_sign(','));
    if (begins && i + 1 < tokens.size() && tokens[i + 1].kind == GeoToken::Kind::word)
      out.insert(tokens[i + 1].text);
  }
}

void collect(const fs::path& file, std::set<fs::path>& seen, std::set<std::string>& out) {
  std::error_code error;
  if (!fs::is_regular_file(file, error) || !seen.insert(fs::weakly_canonical(file, error)).second) return;
  std::ifstream stream(file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(stream), {}};
  Findings unused;  // told when the geometry is read
  const Tokens tokens = geo_tokens(content, file.string(), unused);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].is_word("DefineConstant")) add_constants(tokens, i, out);
    const bool includes = tokens[i].is_word("Include") && tokens[i + 1].kind == GeoToken::Kind::text;
    if (includes) collect(file.parent_path() / tokens[i + 1].text, seen, out);
  }
}

}  // namespace

std::set<std::string> constants_of_geometry(const fs::path& file) {
  std::set<fs::path> seen;
  std::set<std::string> out;
  collect(file, seen, out);
  return out;
}

}  // namespace dda
