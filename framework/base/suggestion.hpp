#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dda {

/// Fewest insertions, deletions and substitutions of one letter that turn a into b (Levenshtein); a metric.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// "; did you mean 'strength'?" where a name is near enough to one that is not known, "" where none is.
std::string did_you_mean(const std::string& name, const std::vector<std::string>& names);

/// What to say after an unknown name: "; did you mean 'strength'?" or "; known are a, b and c".
///
/// Suggests the nearest name within max(2, length/3) edits, provided that some letters survive.
std::string suggest(const std::string& name, const std::vector<std::string>& names);

}  // namespace dda
