#include "framework/deck/writing/node_json.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace dda {
namespace {

template <class T>
bool reads_as(const std::string& text, T& value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

Json scalar(const Node& node) {
  std::int64_t integer = 0;
  double number = 0;
  if (node.quoted) return node.text;
  if (node.text == "true" || node.text == "false") return node.text == "true";
  if (reads_as(node.text, integer)) return integer;
  if (reads_as(node.text, number) && std::isfinite(number)) return number;
  return node.text;
}

}  // namespace

Json to_json(const Node& node) {
  if (node.is_null()) return nullptr;
  if (node.is_scalar()) return scalar(node);
  Json out = node.is_map() ? Json::object() : Json::array();
  for (const Node& item : node.items) out.push_back(to_json(item));
  for (const NodeEntry& entry : node.entries) out[entry.key] = to_json(entry.value);
  return out;
}

}  // namespace dda
