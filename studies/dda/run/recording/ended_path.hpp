#pragma once

#include <optional>

#include "continuation/course/point.hpp"
#include "framework/files/run/restart_file.hpp"
#include "studies/dda/case/deck/deck.hpp"

namespace dda {

/// How the path of a run has ended, in its restart: what comes behind it may be taken up without another step of it.
void put_ending(RestartData& data, const std::optional<Ending>& ending);

/// Nothing where the path goes on, or is another one by this deck than it was.
std::optional<Ending> take_ending(const RestartData& data, const DeckFile& deck);

}  // namespace dda
