#include "continuation/modules/loca/parameter_list.hpp"

#include <charconv>
#include <optional>

namespace dda {
namespace {

template <class Number>
std::optional<Number> parse(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

void set_scalar(const std::string& key, const Node& value, Teuchos::ParameterList& into) {
  const std::string& text = value.text;
  if (value.quoted)
    into.set(key, text);
  else if (text == "true" || text == "false")
    into.set(key, text == "true");
  else if (const auto integer = parse<int>(text))
    into.set(key, *integer);
  else if (const auto number = parse<double>(text))
    into.set(key, *number);
  else
    into.set(key, text);
}

}  // namespace

void merge(const Node& from, Teuchos::ParameterList& into) {
  for (const NodeEntry& entry : from.entries) {
    if (entry.value.is_map())
      merge(entry.value, into.sublist(entry.key));
    else if (entry.value.is_scalar())
      set_scalar(entry.key, entry.value, into);
    else
      throw InputError(entry.where, "parameter lists take scalars and maps; '" + entry.key + "' is neither");
  }
}

}  // namespace dda
