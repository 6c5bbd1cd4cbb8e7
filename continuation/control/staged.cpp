#include "continuation/control/control.hpp"

namespace dda {
namespace {

struct StagedParameters {};

/// Event to the first crack, dissipation while points load, event again where nothing dissipates.
class Staged final : public Control {
 public:
  Move next(Walker& walker) override {
    return walker.leaving().dissipates ? dissipation_move(walker) : event_move(walker);
  }
  bool may_be_rescued() const override { return true; }
};

Schema<StagedParameters> staged_schema() {
  return Schema<StagedParameters>(
      "Event control to the first crack, dissipation control after it, event again where nothing "
      "dissipates.");
}
std::unique_ptr<Control> make_staged(const StagedParameters&, const GaugeBook&) {
  return std::make_unique<Staged>();
}

/// Dissipation control alone; the elastic branch before it is crossed by the event control.
class DissipationOnly final : public Control {
 public:
  Move next(Walker& walker) override { return dissipation_move(walker); }
  std::string obstacle(const Tangent& along) override {
    return along.dissipates ? "" : "nothing dissipates here: dissipation control cannot go on; use `staged`";
  }
};

struct DissipationParameters {};
Schema<DissipationParameters> dissipation_schema() {
  return Schema<DissipationParameters>("The dissipated energy is prescribed (after the first crack).");
}
std::unique_ptr<Control> make_dissipation(const DissipationParameters&, const GaugeBook&) {
  return std::make_unique<DissipationOnly>();
}

/// Event control alone: from initiation to initiation with frozen damage, a sequentially linear analysis.
class EventOnly final : public Control {
 public:
  Move next(Walker& walker) override { return event_move(walker); }
  bool sizes_steps() const override { return false; }
};

struct EventParameters {};
Schema<EventParameters> event_schema() {
  return Schema<EventParameters>(
      "From initiation to initiation with frozen damage (sequentially linear); energy jumps are booked.");
}
std::unique_ptr<Control> make_event(const EventParameters&, const GaugeBook&) {
  return std::make_unique<EventOnly>();
}

}  // namespace

DDA_REGISTER(controls(), "staged", staged_schema(), make_staged);
DDA_REGISTER(controls(), "dissipation", dissipation_schema(), make_dissipation);
DDA_REGISTER(controls(), "event", event_schema(), make_event);

}  // namespace dda
