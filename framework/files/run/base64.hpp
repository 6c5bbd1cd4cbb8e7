#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dda {

/// Base64 with padding, as a browser's `atob` reads it: four characters for three bytes.
std::string base64(std::string_view bytes);

/// An array as it lies in memory; little-endian on every machine this is built for.
template <class Value>
std::string base64_of(std::span<const Value> values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

}  // namespace dda
