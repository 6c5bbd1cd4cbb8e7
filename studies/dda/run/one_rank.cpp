#include "studies/dda/run/one_rank.hpp"

#include <fmt/format.h>

#include "continuation/ranks/ranks.hpp"
#include "framework/base/errors.hpp"

namespace dda {

void require_one_rank(const std::filesystem::path& of, const char* what) {
  if (ranks_of_run())
    throw InputError(Position{of.string()},
                     fmt::format("{}; it was started as {} processes", what, ranks_of_run()->size()));
}

}  // namespace dda
