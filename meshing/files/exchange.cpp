#include "meshing/files/exchange.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace dda {
namespace {

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Appends.
class Packer {
 public:
  template <Plain T>
  void plain(T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Container>
  void size_of(Container& container) {
    std::size_t count = container.size();
    plain(count);
  }

  std::string bytes;
};

/// Takes from the front.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <Plain T>
  void plain(T& value) {
    if (bytes_.size() < sizeof value) fail();
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
  }
  /// Every entry takes at least a byte.
  template <class Container>
  void size_of(Container& container) {
    std::size_t count = 0;
    plain(count);
    if (count > bytes_.size()) fail();
    container.resize(count);
  }
  void require_end() const {
    if (!bytes_.empty()) fail();
  }

 private:
  [[noreturn]] static void fail() { throw std::runtime_error("the process that meshes sent something else"); }

  std::string_view bytes_;
};

/// The members of a thing, in one order for both directions.
template <class Archive, Plain T>
void pass(Archive& archive, T& value) {
  archive.plain(value);
}

template <class Archive>
void pass(Archive& archive, std::string& text) {
  archive.size_of(text);
  for (char& letter : text) archive.plain(letter);
}

template <class Archive, class T>
void pass(Archive& archive, std::vector<T>& list);

/// One member after another.
template <class Archive, class... Members>
requires(sizeof...(Members) > 1) void pass(Archive& archive, Members&... members) {
  (pass(archive, members), ...);
}

template <class Archive>
void pass(Archive& archive, Vec2& x) {
  pass(archive, x.x(), x.y());
}

template <class Archive>
void pass(Archive& archive, std::pair<std::string, Vec2>& point) {
  pass(archive, point.first, point.second);
}

template <class Archive>
void pass(Archive& archive, Position& where) {
  pass(archive, where.file, where.line, where.column);
}

template <class Archive>
void pass(Archive& archive, Finding& finding) {
  pass(archive, finding.where, finding.what);
}

template <class Archive>
void pass(Archive& archive, Region& region) {
  pass(archive, region.name, region.material);
}

template <class Archive>
void pass(Archive& archive, Polygon& polygon) {
  pass(archive, polygon.vertices);
}

template <class Archive>
void pass(Archive& archive, Shape& shape) {
  pass(archive, shape.figure.outline, shape.figure.holes, shape.region, shape.where);
}

template <class Archive>
void pass(Archive& archive, NamedLine& line) {
  pass(archive, line.role, line.name, line.points, line.where, line.from_file);
}

template <class Archive>
void pass(Archive& archive, Cell& cell) {
  pass(archive, cell.outline, cell.region);
}

template <class Archive>
void pass(Archive& archive, Cells& cells) {
  pass(archive, cells.cells, cells.lines);
}

template <class Archive, class T>
void pass(Archive& archive, std::vector<T>& list) {
  archive.size_of(list);
  for (T& item : list) pass(archive, item);
}

template <class Archive>
void pass(Archive& archive, Layout& layout) {
  std::vector<std::pair<std::string, Vec2>> points{layout.points.begin(), layout.points.end()};
  pass(archive, layout.regions, layout.shapes, layout.lines, points, layout.where, layout.meshing_seconds);
  layout.points = {points.begin(), points.end()};
}

template <class Archive>
void pass(Archive& archive, ElementWish& wish) {
  bool is_refined = wish.refine.has_value();
  pass(archive, wish.size, wish.quads, is_refined);
  if (!is_refined) return;
  if (!wish.refine) wish.refine.emplace();
  pass(archive, wish.refine->curve, wish.refine->size, wish.refine->growth);
}

}  // namespace

template <class T>
std::string packed(const T& value) {
  Packer packer;
  pass(packer, const_cast<T&>(value));  // which a Packer only reads
  return std::move(packer.bytes);
}

template <class T>
T unpacked(std::string_view bytes) {
  T value;
  Unpacker unpacker(bytes);
  pass(unpacker, value);
  unpacker.require_end();
  return value;
}

template std::string packed(const Layout&);
template std::string packed(const Cells&);
template std::string packed(const ElementWish&);
template std::string packed(const std::vector<Finding>&);
template Layout unpacked(std::string_view);
template Cells unpacked(std::string_view);
template ElementWish unpacked(std::string_view);
template std::vector<Finding> unpacked(std::string_view);

}  // namespace dda
