#pragma once

#include <string>

#include "framework/base/errors.hpp"

namespace dda {

/// What the user is told when `action` refuses the input; "" when it does not.
template <class Action>
std::string messages(Action action) {
  try {
    action();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace dda
