#pragma once

#include <nlohmann/json.hpp>

namespace dda {

/// Draft-07 JSON schema of what a file may say, for editors. Under "definitions": "deck", a whole deck; "partial-deck",
/// one that `extends` another or has a `sweep`, which may give what it lacks; "sweep", that section; the families, and
/// "partial-" ones for keys that may add up with those of the deck below.
nlohmann::ordered_json schema_for_editors();

}  // namespace dda
