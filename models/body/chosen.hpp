#pragma once

#include <string>
#include <vector>

#include "framework/base/errors.hpp"
#include "models/body/body.hpp"

namespace dda {

/// Which blocks are meant: those of the regions and of the materials named; all of them where neither is named.
struct Chosen {
  std::vector<std::string> regions, materials;

  /// Throws InputError for a name that the body does not have.
  void require_known(const Body& body, const Position& where) const;
  bool has(const Body& body, BlockId block) const;
};

}  // namespace dda
