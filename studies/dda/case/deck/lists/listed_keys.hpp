#pragma once

#include <map>
#include <string>

#include "framework/base/errors.hpp"
#include "framework/deck/document/node.hpp"

namespace dda {

/// Keys of a deck that parameter lists have set: where, and the full name of the parameter.
using ListedKeys = std::map<std::string, Finding>;

/// What is wrong with a deck, of values that lists have set said by their parameters' names and places.
InputError said_by_lists(const InputError& error, const ListedKeys& listed, const Node& root);

}  // namespace dda
