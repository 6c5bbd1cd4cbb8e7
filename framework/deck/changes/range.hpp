#pragma once

#include <vector>

#include "framework/deck/document/node.hpp"

namespace dda {

/// Whether a node is meant as a range: a text with `..` in it.
bool is_range(const Node& node);

/// The values of `1..20`, `0.1..1 step 0.1` or `0.05..10 log 8`, each at the range's position.
///
/// Integers when from, to and step are; other numbers have at most 12 significant digits, so that 0.1..1 step
/// 0.1 gives 0.3. Throws InputError with the reason when it is no range or has more than `at_most` values.
std::vector<Node> read_range(const Node& node, std::size_t at_most);

}  // namespace dda
