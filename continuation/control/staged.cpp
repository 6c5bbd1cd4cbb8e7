#include "continuation/control/control.hpp"

namespace dda {
namespace {

/// Event to the first crack, dissipation while points load, event again where nothing dissipates.
class Staged final : public Control {
 public:
  Move next(Walker& walker) override {
    return walker.leaving().dissipates ? dissipation_move(walker) : event_move(walker);
  }
  bool may_be_rescued() const override { return true; }
};

Schema<NoParameters> staged_schema() {
  return Schema<NoParameters>(
      "Event control to the first crack, dissipation control after it, event again where nothing "
      "dissipates.");
}

/// Dissipation control alone; the elastic branch before it is crossed by the event control.
class DissipationOnly final : public Control {
 public:
  Move next(Walker& walker) override { return dissipation_move(walker); }
  std::optional<Stopped> obstacle(const Tangent& along) override {
    if (along.dissipates) return {};
    return Stopped{Stop::nothing_dissipates,
                   "nothing dissipates here: dissipation control cannot go on; use `staged`"};
  }
};

Schema<NoParameters> dissipation_schema() {
  return Schema<NoParameters>("The dissipated energy is prescribed (after the first crack).");
}

/// Event control alone: from initiation to initiation with frozen damage, a sequentially linear analysis.
class EventOnly final : public Control {
 public:
  Move next(Walker& walker) override { return event_move(walker); }
  bool sizes_steps() const override { return false; }
};

Schema<NoParameters> event_schema() {
  return Schema<NoParameters>(
      "From initiation to initiation with frozen damage (sequentially linear): the κ of one point grows by "
      "8 % at a time, ahead of its opening. What is spent ahead is booked as negative `jump_energy`, some "
      "percent of the dissipated energy while cracks grow.");
}

}  // namespace

DDA_REGISTER(controls(), "staged", staged_schema(), make_of<Staged>);
DDA_REGISTER(controls(), "dissipation", dissipation_schema(), make_of<DissipationOnly>);
DDA_REGISTER(controls(), "event", event_schema(), make_of<EventOnly>);

}  // namespace dda
