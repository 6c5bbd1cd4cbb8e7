#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace dda {

/// Prints what a run can do without: what cannot be written, on a full disk say, is left out, where fmt::print throws.
template <class... Values>
void tell(std::FILE* stream, fmt::format_string<Values...> text, Values&&... values) {
  std::fputs(fmt::format(text, std::forward<Values>(values)...).c_str(), stream);
}

}  // namespace dda
