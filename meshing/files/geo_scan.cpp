#include "meshing/files/geo_scan.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "meshing/files/geo_tokens.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr const char* advice = "; `--trust-geo` allows everything";

/// What each refused word does.
const std::map<std::string, std::string>& refused_words() {
  static const std::string runs = "runs a program", writes = "writes a file",
                           ends = "ends gmsh before its end";
  static const std::map<std::string, std::string> words{{"SystemCall", runs},
                                                        {"System", runs},
                                                        {"OnelabRun", runs},
                                                        {"NonBlockingSystemCall", runs},
                                                        {"ExternalProcess", runs},
                                                        {"SendToServer", "sends data away"},
                                                        {"Plugin", "may do anything a plugin does"},
                                                        {"Save", writes},
                                                        {"CreateDir", "makes a folder"},
                                                        {"LogFileName", writes},
                                                        {"Exit", ends},
                                                        {"Abort", ends},
                                                        {"Sleep", "waits"}};
  return words;
}

bool is_below(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(file, error), top = fs::weakly_canonical(folder, error);
  const auto [end, unused] = std::mismatch(top.begin(), top.end(), whole.begin(), whole.end());
  return end == top.end();
}

class Scan {
 public:
  Scan(const std::vector<fs::path>& folders, Findings& findings) : folders_(folders), findings_(findings) {}

  void file(const fs::path& path) {
    std::error_code error;
    if (!seen_.insert(fs::weakly_canonical(path, error)).second) return;
    std::ifstream stream(path, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    if (content.starts_with("$MeshFormat")) return;  // a mesh, which is data
    const std::vector<GeoToken> tokens = geo_tokens(content, path.string(), findings_);
    for (std::size_t i = 0; i < tokens.size(); ++i)
      if (tokens[i].kind == GeoToken::Kind::word) word(tokens, i, path);
  }

 private:
  using Tokens = std::vector<GeoToken>;

  void refuse(const GeoToken& token, const std::string& why) {
    findings_.add(token.where, "'" + token.text + "' " + why + advice);
  }

  void word(const Tokens& tokens, std::size_t i, const fs::path& path) {
    const GeoToken& token = tokens[i];
    const bool is_last = i + 1 == tokens.size();
    if (const auto found = refused_words().find(token.text); found != refused_words().end())
      return refuse(token, found->second);
    // Print.Background is an option.
    if (token.is_word("Print") && (is_last || !tokens[i + 1].is_sign('.')))
      return refuse(token, "writes a file");
    if ((token.is_word("Macro") || token.is_word("Function")) && !is_last && tokens[i + 1].is_sign('('))
      return refuse(token, "with its commands in a text hides what they do");
    if ((token.is_word("Printf") || token.is_word("Sprintf")) && is_redirected(tokens, i))
      return refuse(token, "writes a file");
    if (token.is_word("Merge") || token.is_word("MergeWithBoundingBox") || token.is_word("Include"))
      return included(tokens, i, path);
    if (token.is_word("ShapeFromFile") || token.is_word("ListFromFile") || token.is_word("FileName"))
      read(tokens, i, path);
  }

  /// Whether a '>' follows the parenthesis behind the word.
  static bool is_redirected(const Tokens& tokens, std::size_t i) {
    int depth = 0;
    for (++i; i < tokens.size(); ++i) {
      if (tokens[i].is_sign('(') || tokens[i].is_sign('[')) ++depth;
      if (tokens[i].is_sign(')') || tokens[i].is_sign(']')) --depth;
      if (depth <= 0) break;
    }
    return i + 1 < tokens.size() && tokens[i + 1].is_sign('>');
  }

  void included(const Tokens& tokens, std::size_t i, const fs::path& path) {
    const bool is_plain =
        i + 2 < tokens.size() && tokens[i + 1].kind == GeoToken::Kind::text && tokens[i + 2].is_sign(';');
    if (!is_plain) return refuse(tokens[i], "must name its file in quotes");
    if (const fs::path other = place(tokens[i + 1], path); !other.empty()) file(other);
  }

  /// Every text up to the end of the statement may be the file.
  void read(const Tokens& tokens, std::size_t i, const fs::path& path) {
    bool has_name = false;
    for (const std::size_t word = i++; i < tokens.size() && !tokens[i].is_sign(';'); ++i) {
      if (tokens[i].kind == GeoToken::Kind::text) place(tokens[i], path), has_name = true;
      if (tokens[i].kind == GeoToken::Kind::word) return refuse(tokens[word], "must name its file in quotes");
    }
    if (!has_name)
      refuse(tokens[std::min(i, tokens.size() - 1)], "ends a statement that names no file in quotes");
  }

  /// The file that a text names, relative to the one it stands in; "" where it is none to be read.
  fs::path place(const GeoToken& name, const fs::path& from) {
    const fs::path file = from.parent_path() / name.text;
    const bool is_inside =
        std::ranges::any_of(folders_, [&](const fs::path& folder) { return is_below(file, folder); });
    if (!is_inside) return refuse(name, "lies outside the folder of the deck or the geometry"), fs::path();
    std::error_code error;
    return fs::is_regular_file(file, error) ? file : fs::path();
  }

  const std::vector<fs::path>& folders_;
  Findings& findings_;
  std::set<fs::path> seen_;
};

}  // namespace

void refuse_commands(const fs::path& file, const std::vector<fs::path>& folders, Findings& findings) {
  Scan(folders, findings).file(file);
}

}  // namespace dda
