#pragma once

#include <nlohmann/json.hpp>

#include "framework/base/vec2.hpp"

namespace dda {

inline nlohmann::ordered_json json_of(const Vec2& x) { return nlohmann::ordered_json::array({x.x(), x.y()}); }

}  // namespace dda
