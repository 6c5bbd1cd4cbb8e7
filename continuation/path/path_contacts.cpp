// Steps of structures that slide, open and close while nothing cracks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "continuation/contact/contact_piece.hpp"
#include "continuation/path/path.hpp"

namespace dda {
namespace {

/// Share of its displacement by which a mechanism moves on while the load stays.
constexpr double mechanism_way = 0.1;

/// How many joints slide and how many are apart.
struct ContactCount {
  int slide = 0, open = 0;
};

ContactCount count_contacts(const Walker& walker) {
  const System& system = walker.system();
  const LawValues laws = system.laws(walker.state().d, walker.state().load_factor);
  ContactCount out;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const History& h = system.history()[p];
    const auto contact = point.law->contact(h, point.stiffness);
    if (!contact) continue;
    const ContactPiece piece = piece_at(*contact, laws.opening[p], h.sliding);
    if (piece == ContactPiece::open)
      ++out.open;
    else if (piece != ContactPiece::stuck)
      ++out.slide;
  }
  return out;
}

}  // namespace

double next_contact_change(const Walker& walker) {
  const System& system = walker.system();
  const LawValues laws = system.laws(walker.state().d, walker.state().load_factor);
  const std::vector<Vec2>& rates = walker.leaving().opening;
  double fastest = 0, widest = 0;
  for (std::size_t p = 0; p < rates.size(); ++p) {
    fastest = std::max(fastest, rates[p].norm());
    widest = std::max(widest, laws.opening[p].norm());
  }
  constexpr double round_off = 1e-10;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < rates.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const auto contact = point.law->contact(system.history()[p], point.stiffness);
    if (!contact || rates[p].norm() <= round_off * fastest) continue;
    const ContactPiece piece = piece_at(*contact, laws.opening[p], system.history()[p].sliding);
    const auto end = end_of_piece(*contact, piece, laws.opening[p], rates[p]);
    if (end && end->length * rates[p].norm() > round_off * widest) nearest = std::min(nearest, end->length);
  }
  return nearest;
}

/// Load factor beyond the present one at which the next point reaches its strength; infinite where none does,
/// and where strength is lost at once also where what slides and turns goes on as a mechanism long before.
double Path::amount_to_event() const {
  const double amount = next_event(walker_);
  const bool is_far = releases_at_once_ && std::isfinite(amount) && walker_.system().has_contacts() &&
                      is_mechanism(walker_.ahead(amount));
  return is_far ? std::numeric_limits<double>::infinity() : amount;
}

/// Whether joints may slide, open or close although nothing cracks. Where strength may yet be lost at once
/// the release finds what follows.
bool Path::can_slide() const {
  return walker_.system().has_contacts() && !(releases_at_once_ && std::isfinite(amount_to_event()));
}

/// The control of a structure that slides: the control's own where it prescribes a gauge, else the
/// displacement on which the load works, which goes on where the load does not.
Move Path::sliding_move() {
  Move own = control_->next(walker_);
  const bool serves = !own.to_event && own.control != "dissipation" && own.rate != 0;
  if (serves) return own;
  return {.control = "displacement",
          .equation = make_gauge_equation(displacement_),
          .arc = {},
          .rate = displacement_rate(walker_.leaving())};
}

/// Along the leaving tangent to the first wanted value; infinite when none lies ahead.
double Path::amount_to_landing() const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Landing& landing : present_landings()) {
    const double rate = walker_.leaving().rate(landing.gauge);
    const double amount = (landing.value - walker_.value(landing.gauge)) / rate;
    if (!landing.only_falling && amount > 0) nearest = std::min(nearest, amount);
  }
  return nearest;
}

/// Whether the structure moves on by as much as makes a mechanism while its load stays.
bool Path::moves_freely() const {
  const double moved = std::abs(displacement_rate(walker_.leaving())),
               along = mechanism_way * std::abs(displacement_of(walker_.state()));
  return moved > 0 &&
         std::abs(walker_.leaving().rate(load_)) * along / moved <= standing_load(load_of(walker_.state()));
}

/// By how much a load may change that stays.
double Path::standing_load(double load) const {
  constexpr double same = 1e-6;
  return std::max(same * std::abs(load), smallest_load());
}

/// Nothing cracks, but joints slide, open or close. The first change of a contact is landed on; from there
/// the path is followed until a wanted value or a mechanism. Where no contact will change any more the
/// response is linear for good.
std::optional<Point> Path::sliding_step() {
  if (const std::string why = control_->obstacle(walker_.leaving()); !why.empty())
    return end(Ending::Kind::stopped_early, why);
  const double change = next_contact_change(walker_), goal = amount_to_landing();
  const bool is_loaded = walker_.here().stored > 0;
  if (!std::isfinite(change) && is_loaded) {
    const bool may_release = releases_at_once_ && std::isfinite(next_event(walker_));
    if (!std::isfinite(goal) && !may_release && !moves_freely()) return linear_for_good();
    constexpr double beyond = 1.001;
    if (std::isfinite(goal))
      if (auto point = land_ahead(beyond * goal, true)) return point;
  }
  const bool is_far =
      std::isfinite(change) && std::abs(walker_.leaving().rate(load_)) * change > smallest_load();
  if (is_far && walker_.here().dissipated == 0 && !memory_.has_slid)
    if (auto point = first_slip(change)) return point;
  const Move move = sliding_move();
  if (memory_.step == 0 || memory_.step_control != move.control) {
    constexpr double part = 0.25;
    double amount =
        is_loaded && std::isfinite(change) ? part * change : 1 / std::abs(walker_.leaving().load_factor);
    if (memory_.has_slid && is_loaded)
      amount = part * std::abs(walker_.state().load_factor / walker_.leaving().load_factor);
    amount = std::max(amount, sliding_amount());
    memory_.step = amount * unit_of(move);
    memory_.step_control = move.control;
  }
  const State before = walker_.state();
  auto point = controlled_step(move);
  if (point) {
    memory_.has_slid = memory_.has_slid || std::isfinite(change);
    note_mechanism(*point, before);
  }
  return point;
}

/// Exactly to where the first joint begins to slide, or opens or closes.
std::optional<Point> Path::first_slip(double change) {
  if (auto point = land_ahead(change)) return point;
  const Move move{.control = "event",
                  .equation = make_gauge_equation({.rows = {}, .per_load_factor = 1}),
                  .arc = {},
                  .rate = walker_.leaving().load_factor};
  std::string why;
  const auto candidate = try_step(move, change, why);
  if (!candidate) return {};
  memory_.has_slid = true;
  memory_.step = 0;
  Point point = keep(*candidate, move.control);
  point.landed.emplace_back("first contact change");
  return point;
}

/// No contact changes any more: up to the full reference load, unless contacts have changed on the way.
std::optional<Point> Path::linear_for_good() {
  if (memory_.has_slid || walker_.here().dissipated > 0)
    return end(Ending::Kind::goal_reached,
               fmt::format("no joint cracks, slides, opens or closes any more beyond a load factor of {:g}",
                           walker_.state().load_factor));
  return linear_step();
}

/// A mechanism moves on while the load stays.
void Path::note_mechanism(Point& point, const State& before) {
  const double load = load_of(walker_.state()), change = std::abs(load - load_of(before));
  const double along = std::abs(displacement_of(walker_.state()) - displacement_of(before));
  if (change > standing_load(load) || along < mechanism_way * std::abs(displacement_of(before))) return;
  const ContactCount count = count_contacts(walker_);
  const std::string text =
      fmt::format("{} as a mechanism at a load factor of {:.9g}: {} points slide, {} are open",
                  count.slide > 0 ? "slides" : "turns", walker_.state().load_factor, count.slide, count.open);
  if (!memory_.is_mechanism) {
    report("mechanism", text);
    point.landed.emplace_back("mechanism");
  }
  memory_.is_mechanism = true;
  const auto is_goal = [](const Landing& landing) { return landing.ends_leg && !landing.only_falling; };
  if (ending_.kind == Ending::Kind::running && !std::ranges::any_of(present_landings(), is_goal))
    end(Ending::Kind::goal_reached, text);
}

}  // namespace dda
