#pragma once

#include <string>
#include <vector>

#include "framework/deck/document/node.hpp"

namespace dda {

/// A key that a sweep varies: its dotted path, where it stands, and its values in order.
struct SweptKey {
  std::string name;
  Position where;
  std::vector<Node> values;
};

/// One key, or several that vary together; each has as many values as the others.
struct Axis {
  std::vector<SweptKey> keys;
  std::size_t size() const { return keys.front().values.size(); }
};

/// The axes of a `sweep` section, in its order. Every entry but `zip` is an axis of one key:
///
///     key: [50, 100, {type: voronoi}]     any values
///     key: 1..20                          integers, one by one
///     key: 0.1..1 step 0.1                from, to (at most), step
///     key: 0.05..10 log 8                 8 numbers from 0.05 to 10, each by the same factor above the last
///     zip: {a: [1, 2], b: 5..6}           (a, b) = (1, 5), (2, 6); several of them as a list
///
/// Throws InputError with every finding: what is neither list nor range, a range without numbers, unequal
/// lengths in a zip, a key that is varied twice, more than `max_cases` cases.
std::vector<Axis> read_axes(const Node& sweep);

inline constexpr std::size_t max_cases = 100'000;

/// The product of the axes: of each case the place of its value on every axis. The last axis runs fastest.
std::vector<std::vector<std::size_t>> cases_of(const std::vector<Axis>& axes);

}  // namespace dda
