#include "meshing/files/mesh_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>

#include "framework/base/errors.hpp"

namespace dda {
namespace {

using Entity = MeshContent::Entity;

/// Words of a file, with the line each stands in.
class Words {
 public:
  Words(std::string file, std::string text) : file_(std::move(file)), text_(std::move(text)) {}

  bool at_end() {
    skip_space();
    return at_ == text_.size();
  }
  std::string_view word() {
    skip_space();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return std::string_view(text_).substr(begin, at_ - begin);
  }
  template <class Number>
  Number number(const char* what) {
    const std::string_view text = word();
    Number out{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (error != std::errc{} || end != text.data() + text.size() || text.empty())
      fail(text.empty() ? fmt::format("the file ends where {} is expected", what)
                        : fmt::format("expected {}, got '{}'", what, text));
    return out;
  }
  /// A count of things of which each takes at least two characters.
  std::size_t count(const char* what) {
    const auto out = number<std::size_t>(what);
    if (out > text_.size() / 2) fail(fmt::format("{} {} do not fit into the file", out, what));
    return out;
  }
  void skip(std::size_t words) {
    for (std::size_t i = 0; i < words; ++i)
      if (word().empty()) fail("the file ends too early");
  }
  std::string quoted() {
    const std::size_t begin = text_.find('"', at_), end = text_.find('"', begin + 1);
    if (begin == std::string::npos || end == std::string::npos) fail("expected a name in quotes");
    at_ = end + 1;
    return text_.substr(begin + 1, end - begin - 1);
  }
  /// Goes on behind the end of a section.
  void leave(std::string_view section) {
    const std::string end = "$End" + std::string(section.substr(1));
    const std::size_t found = text_.find(end, at_);
    if (found == std::string::npos) fail("there is no " + end);
    at_ = found + end.size();
  }
  [[noreturn]] void fail(const std::string& what) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    throw InputError({file_, static_cast<int>(line), 1}, what);
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  std::string file_, text_;
  std::size_t at_ = 0;
};

constexpr int line_type = 1, triangle_type = 2, quadrilateral_type = 3, point_type = 15;

int dimension_of(int type) { return type == point_type ? 0 : type == line_type ? 1 : 2; }

class Reader {
 public:
  explicit Reader(Words& words) : words_(words) {}

  /// False when the format is not one of those read here.
  bool read() {
    if (words_.word() != "$MeshFormat") return false;
    const std::string_view version = words_.word();
    if ((version != "4.1" && version != "2.2") || words_.word() != "0") return false;
    is_new_ = version == "4.1";
    words_.leave("$MeshFormat");
    while (!words_.at_end()) {
      const std::string_view section = words_.word();
      if (!section.starts_with('$')) words_.fail(fmt::format("expected a section, got '{}'", section));
      if (section == "$PhysicalNames") read_names();
      if (section == "$Entities") read_entities();
      if (section == "$Nodes") is_new_ ? read_nodes() : read_old_nodes();
      if (section == "$Elements") is_new_ ? read_elements() : read_old_elements();
      words_.leave(section);
    }
    return true;
  }

  MeshContent content;

 private:
  void read_names() {
    const std::size_t count = words_.count("names");
    for (std::size_t i = 0; i < count; ++i) {
      const int dimension = words_.number<int>("a dimension"), tag = words_.number<int>("a tag");
      content.group_names[{dimension, tag}] = words_.quoted();
    }
  }

  void read_entities() {
    std::size_t counts[4];
    for (std::size_t& count : counts) count = words_.count("entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::size_t i = 0; i < counts[dimension]; ++i) read_entity(dimension);
  }

  void read_entity(int dimension) {
    Entity& entity = content.entities[{dimension, words_.number<int>("a tag")}];
    if (dimension == 0) {
      const double x = words_.number<double>("x"), y = words_.number<double>("y");
      entity.place = Vec2(x, y);
      words_.skip(1);
    } else {
      words_.skip(6);  // bounding box
    }
    const std::size_t groups = words_.count("groups");
    for (std::size_t i = 0; i < groups; ++i) entity.groups.insert(std::abs(words_.number<int>("a group")));
    if (dimension > 0) words_.skip(words_.count("borders"));
  }

  void read_place(std::size_t tag) {
    const double x = words_.number<double>("x"), y = words_.number<double>("y"),
                 z = words_.number<double>("z");
    content.places[tag] = Vec2(x, y);
    content.width = std::max({content.width, std::abs(x), std::abs(y)});
    content.height = std::max(content.height, std::abs(z));
  }

  void read_nodes() {
    const std::size_t blocks = words_.count("blocks of nodes"), all = words_.count("nodes");
    content.places.reserve(all);
    words_.skip(2);
    for (std::size_t b = 0; b < blocks; ++b) {
      const auto dimension = words_.count("a dimension");
      words_.skip(1);
      const bool parametric = words_.number<int>("0 or 1") != 0;
      std::vector<std::size_t> tags(words_.count("nodes"));
      for (std::size_t& tag : tags) tag = words_.number<std::size_t>("a node's number");
      for (const std::size_t tag : tags) {
        read_place(tag);
        if (parametric) words_.skip(dimension);
      }
    }
  }

  void read_old_nodes() {
    const std::size_t count = words_.count("nodes");
    content.places.reserve(count);
    for (std::size_t i = 0; i < count; ++i) read_place(words_.number<std::size_t>("a node's number"));
  }

  void read_element(int dimension, int entity, int type) {
    std::vector<std::size_t>& nodes = content.entities[{dimension, entity}].nodes[type];
    for (std::size_t i = 0; i < num_nodes(type); ++i) {
      nodes.push_back(words_.number<std::size_t>("a node's number"));
      if (!content.places.contains(nodes.back()))
        words_.fail(fmt::format("there is no node {}", nodes.back()));
    }
  }

  void require_known(int type) {
    if (num_nodes(type) == 0)
      words_.fail("the mesh has elements that are no three-node triangles or four-node quadrilaterals");
  }

  void read_elements() {
    const std::size_t blocks = words_.count("blocks of elements");
    words_.skip(3);
    for (std::size_t b = 0; b < blocks; ++b) {
      const int dimension = words_.number<int>("a dimension"), entity = words_.number<int>("a tag"),
                type = words_.number<int>("a type");
      require_known(type);
      const std::size_t count = words_.count("elements");
      for (std::size_t i = 0; i < count; ++i) {
        words_.skip(1);
        read_element(dimension, entity, type);
      }
    }
  }

  void read_old_elements() {
    const std::size_t count = words_.count("elements");
    for (std::size_t i = 0; i < count; ++i) {
      words_.skip(1);
      const int type = words_.number<int>("a type");
      require_known(type);
      const std::size_t tags = words_.count("tags");
      if (tags < 2) words_.fail("an element needs two tags, its physical group and its entity");
      const int group = words_.number<int>("a group"), entity = words_.number<int>("an entity");
      words_.skip(tags - 2);
      const int dimension = dimension_of(type);
      if (group != 0) content.entities[{dimension, entity}].groups.insert(std::abs(group));
      read_element(dimension, entity, type);
    }
  }

  Words& words_;
  bool is_new_ = true;
};

}  // namespace

std::size_t num_nodes(int element_type) {
  switch (element_type) {
    case point_type:
      return 1;
    case line_type:
      return 2;
    case triangle_type:
      return 3;
    case quadrilateral_type:
      return 4;
    default:
      return 0;
  }
}

std::optional<MeshContent> read_mesh_content(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  Words words(file, {std::istreambuf_iterator<char>(stream), {}});
  Reader reader(words);
  if (!reader.read()) return {};
  return std::move(reader.content);
}

}  // namespace dda
