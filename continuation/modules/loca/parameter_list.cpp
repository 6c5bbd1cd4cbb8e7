#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "continuation/solve/loca.hpp"

namespace dda {
namespace {

/// Shortest text that reads back to the same bits.
std::string text_of(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

ListEntry entry_of(const Teuchos::ParameterEntry& value) {
  using enum ListEntry::Type;
  if (value.isType<bool>()) return {{}, {}, boolean, value.getValue<bool>(nullptr) ? "true" : "false"};
  if (value.isType<int>()) return {{}, {}, integer, std::to_string(value.getValue<int>(nullptr))};
  if (value.isType<double>()) return {{}, {}, number, text_of(value.getValue<double>(nullptr))};
  if (value.isType<std::string>()) return {{}, {}, text, value.getValue<std::string>(nullptr)};
  throw std::runtime_error("its type is none of bool, int, double and string");
}

void collect(const Teuchos::ParameterList& list, const std::vector<std::string>& lists,
             std::vector<ListEntry>& out) {
  for (auto at = list.begin(); at != list.end(); ++at) {
    const std::string& name = list.name(at);
    const Teuchos::ParameterEntry& value = list.entry(at);
    if (value.isList()) {
      std::vector<std::string> deeper = lists;
      deeper.push_back(name);
      collect(list.sublist(name), deeper, out);
      continue;
    }
    ListEntry entry = entry_of(value);
    entry.lists = lists;
    entry.name = name;
    out.push_back(std::move(entry));
  }
}

void set(const ListEntry& entry, Teuchos::ParameterList& list) {
  switch (entry.type) {
    case ListEntry::Type::boolean:
      list.set(entry.name, entry.value == "true");
      return;
    case ListEntry::Type::integer:
      list.set(entry.name, std::stoi(entry.value));
      return;
    case ListEntry::Type::number:
      list.set(entry.name, std::stod(entry.value));
      return;
    case ListEntry::Type::text:
      list.set(entry.name, entry.value);
  }
}

}  // namespace
}  // namespace dda

/// What continuation/solve/loca.cpp loads.
extern "C" void dda_read_parameter_list(const std::filesystem::path& file, std::vector<dda::ListEntry>& out) {
  dda::collect(*Teuchos::getParametersFromXmlFile(file.string()), {}, out);
}

/// Likewise.
extern "C" void dda_parameter_list_text(const std::vector<dda::ListEntry>& entries, std::string& out) {
  Teuchos::ParameterList list("ddapath");
  for (const dda::ListEntry& entry : entries) {
    Teuchos::ParameterList* at = &list;
    for (const std::string& name : entry.lists) at = &at->sublist(name);
    dda::set(entry, *at);
  }
  std::ostringstream text;
  Teuchos::writeParameterListToXmlOStream(list, text);
  out = text.str();
}
