#pragma once

#include <compare>
#include <cstddef>
#include <functional>

namespace dda {

/// A number that counts things of one kind, so that a block cannot be mistaken for an interface point.
/// Explicit on both ends: BlockId{3}, id.value().
template <class Kind>
class Index {
 public:
  constexpr Index() = default;
  explicit constexpr Index(std::size_t value) : value_(value) {}
  constexpr std::size_t value() const { return value_; }
  friend constexpr auto operator<=>(Index, Index) = default;

 private:
  std::size_t value_ = 0;
};

using BlockId = Index<struct BlockKind>;
using PointId = Index<struct PointKind>;

}  // namespace dda

template <class Kind>
struct std::hash<dda::Index<Kind>> {
  std::size_t operator()(dda::Index<Kind> id) const noexcept { return std::hash<std::size_t>{}(id.value()); }
};
