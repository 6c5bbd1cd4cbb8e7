#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "deck_templates.hpp"
#include "framework/base/loaded.hpp"
#include "framework/files/whole_file.hpp"
#include "studies/dda/commands/commands.hpp"

namespace dda {
namespace {

/// What editors find the schema of decks by; nothing where the program was not installed with it.
std::string schema_line() {
  const std::filesystem::path schema = installation() / "share" / "ddapath" / "deck.schema.json";
  std::error_code error;
  if (!std::filesystem::exists(schema, error)) return {};
  return fmt::format("# yaml-language-server: $schema={}\n", schema.string());
}

}  // namespace

std::vector<std::string> deck_template_names() {
  std::vector<std::string> names;
  for (const auto& [name, text] : deck_templates) names.emplace_back(name);
  return names;
}

int command_new(const CommandLine& line) {
  const auto* chosen =
      std::ranges::find_if(deck_templates, [&](const auto& one) { return one.first == line.topic; });
  const std::filesystem::path file =
      line.page.empty() ? std::filesystem::path(line.topic + ".yaml") : line.page;
  if (std::filesystem::exists(file))
    throw InputError(Position{file.string()}, "is there already; give another name with --out");
  write_whole(file, schema_line() + std::string(chosen->second));
  fmt::print("{}: a deck to begin with; next: dda run {}\n", file.string(), file.string());
  return 0;
}

}  // namespace dda
