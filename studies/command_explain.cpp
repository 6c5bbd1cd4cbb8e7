#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/explain.hpp"
#include "studies/commands.hpp"

namespace dda {

int command_explain(const CommandLine& line) {
  if (line.json)
    fmt::print("{}\n", deck_schema().json_schema().dump(2));
  else
    fmt::print("{}", explain(deck_schema(), line.topic));
  return 0;
}

}  // namespace dda
