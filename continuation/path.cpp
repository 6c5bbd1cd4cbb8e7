#include "continuation/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "continuation/rescue.hpp"

namespace dda {
namespace {

/// A step is tried again with this share of its size when Newton fails.
constexpr double cut = 0.25;
/// Below this share of its first size a step is given up.
constexpr double smallest_share = 1e-4;
/// How many times one step is shortened for the peak or a landing.
constexpr int most_refinements = 20;

State between(const State& a, const State& b, double share) {
  State out = a;
  for (std::size_t i = 0; i < out.d.size(); ++i) out.d[i] += share * (b.d[i] - a.d[i]);
  out.load_factor += share * (b.load_factor - a.load_factor);
  return out;
}

/// The path's load gauge: the deck's by name, else the stage's own.
Functional find_load(const std::string& name, const GaugeBook& book, const Functional& fallback, const Position& where) {
  if (name.empty()) return fallback;
  for (const NamedGauge& gauge : book.gauges)
    if (gauge.name == name) return gauge.functional;
  throw InputError(where, "`load_gauge` names '" + name + "', which is not among the gauges");
}

}  // namespace

Path::Path(Walker& walker, const PathParameters& parameters, const GaugeBook& gauges, std::vector<Landing> landings)
    : walker_(walker),
      parameters_(parameters),
      driver_(parameters.control.make(gauges)),
      load_(find_load(parameters.load_gauge, gauges, walker.system().loading().load, parameters.where)),
      landings_(std::move(landings)) {}

PathMemory Path::memory() const {
  PathMemory out = memory_;
  out.driver = driver_->memory();
  return out;
}

void Path::restore(const PathMemory& memory) {
  memory_ = memory;
  driver_->restore(memory.driver);
}

double Path::load_of(const State& state) const {
  return (memory_.direction < 0 ? -1 : 1) * load_.value(state.d, state.load_factor);
}

double Path::displacement_of(const State& state) const {
  const Loading& loading = walker_.system().loading();
  double sum = std::inner_product(state.d.begin(), state.d.end(), loading.reference_work.begin(), 0.0);
  for (const WorkPair& pair : loading.driven) sum += pair.displacement.value(state.d, state.load_factor);
  return sum;
}

double Path::displacement_rate(const Tangent& tangent) const { return displacement_of({tangent.d, 0}); }

std::optional<Point> Path::end(Ending::Kind kind, std::string reason) {
  ending_ = {kind, std::move(reason)};
  return {};
}

std::optional<Point> Path::next() {
  if (ending_.kind != Ending::Kind::running) return {};
  if (interrupted_ && interrupted_()) return end(Ending::Kind::interrupted, "interrupted");
  if (at_end()) return {};
  return take_step();
}

bool Path::at_end() {
  if (walker_.effort().accepted >= parameters_.stop.steps) {
    end(Ending::Kind::goal_reached, fmt::format("{} steps", parameters_.stop.steps));
    return true;
  }
  constexpr double nothing = 1e-9;
  if (memory_.peak_load > 0 && std::abs(load_of(walker_.state())) <= nothing * memory_.peak_load &&
      walker_.here().dissipated > 0) {
    end(Ending::Kind::goal_reached, "complete rupture");
    return true;
  }
  return false;
}

std::optional<Point> Path::take_step() {
  if (walker_.leaving().d.empty())
    return end(Ending::Kind::stopped_early, "the tangent stiffness is singular here");
  const bool cracked = walker_.here().dissipated > 0 || walker_.leaving().dissipates;
  if (!cracked) return event_step();
  if (const std::string why = driver_->obstacle(walker_.leaving()); !why.empty()) return end(Ending::Kind::stopped_early, why);
  const Move move = driver_->next(walker_);
  if (!move.to_event) return controlled_step(move);
  if (!walker_.leaving().dissipates) return event_step();
  auto point = sequential_step("event", std::numeric_limits<double>::min());
  return point ? point : end(Ending::Kind::stopped_early, "no interface limits the load any more");
}

std::optional<Point> Path::event_step() {
  const double amount = next_event(walker_);
  if (!std::isfinite(amount)) return linear_step();
  driver_->obstacle(walker_.leaving());  // fixes the direction of a prescribed gauge on the elastic branch
  const Move move = event_move(walker_);
  std::string why;
  const auto candidate = try_step(move, amount, why);
  if (!candidate) {
    if (driver_->may_be_rescued())
      if (auto point = sequential_step("sequentially_linear", memory_.last_quantum)) return point;
    return end(Ending::Kind::stopped_early, "the next initiation was not found: " + why);
  }
  if (const auto crossing = first_crossing(*candidate))
    if (auto point = land(*candidate, *crossing, "event")) return point;
  memory_.step = 0;
  return keep(*candidate, move.control);
}

/// Nothing can crack any more: the response is linear up to the full reference load.
std::optional<Point> Path::linear_step() {
  const double rest = 1 - walker_.state().load_factor;
  if (walker_.here().dissipated > 0)
    return end(Ending::Kind::stopped_early, "no interface can crack any further under this load");
  if (rest <= 0) return end(Ending::Kind::goal_reached, "nothing can crack; the full reference load is applied");
  const Move move{.control = "load", .equation = make_gauge_control({.rows = {}, .per_load_factor = 1}), .arc = {},
                  .rate = walker_.leaving().load_factor};
  std::string why;
  const auto candidate = try_step(move, rest / walker_.leaving().load_factor, why);
  if (!candidate) return end(Ending::Kind::stopped_early, why);
  if (const auto crossing = first_crossing(*candidate))
    if (auto point = land(*candidate, *crossing, move.control)) return point;
  return keep(*candidate, move.control);
}

std::optional<Point> Path::controlled_step(const Move& move) {
  const bool known = memory_.step > 0 && memory_.step_control == move.control;
  double amount = bounded(known ? memory_.step : first_amount());
  if (load_of(walker_.ahead(amount)) <= 0 && load_of(walker_.state()) > 0)
    if (auto point = rupture()) return point;
  const double smallest = smallest_share * amount;
  std::string why;
  for (int refinements = 0; amount > smallest;) {
    const auto candidate = try_step(move, amount, why);
    if (!candidate) {
      if (load_of(walker_.ahead(amount / cut)) <= 0)
        if (auto point = rupture()) return point;
      amount *= cut;
      continue;
    }
    if (const auto share = before_peak(*candidate, amount); share && refinements++ < most_refinements) {
      report("refined", "the step crosses the limit point");
      ++walker_.effort().rejected;
      amount *= *share;
      continue;
    }
    if (const auto crossing = first_crossing(*candidate)) {
      if (auto point = land(*candidate, *crossing, move.control)) return point;
      amount *= 0.5 * std::max(crossing->share, 0.1);
      continue;
    }
    resize(*candidate, amount, move);
    return keep(*candidate, move.control);
  }
  if (auto point = rupture()) return point;
  if (driver_->may_be_rescued())
    if (auto point = sequential_step("sequentially_linear", memory_.last_quantum)) return point;
  if (const std::string turned = turning_point(); !turned.empty()) return end(Ending::Kind::stopped_early, turned);
  return end(Ending::Kind::stopped_early, fmt::format("{} control found no next equilibrium: {}", move.control, why));
}

std::optional<Candidate> Path::try_step(const Move& move, double amount, std::string& why) {
  const Attempt tried = attempt(move, amount);
  if (!tried.converged) {
    why = tried.reason;
    report("rejected", fmt::format("{}: {}", move.control, why));
    return {};
  }
  Candidate candidate = walker_.evaluate(tried);
  why = objection(candidate);
  if (why.empty()) return candidate;
  ++walker_.effort().rejected;
  report("rejected", fmt::format("{}: {}", move.control, why));
  return {};
}

Attempt Path::attempt(const Move& move, double amount) {
  if (!move.arc) {
    const double step = move.to_event ? 1.0 : amount * move.rate;
    return walker_.attempt(*move.equation, step, walker_.ahead(amount));
  }
  ArcLength arc = *move.arc;
  arc.length *= amount * move.rate;
  return walker_.attempt(arc);
}

/// Work of the step that neither storage nor dissipation explains: quadrature error, or a jump [FL].
double Path::unaccounted(const Candidate& candidate) const {
  const Candidate& here = walker_.here();
  return std::abs((candidate.work - here.work) - (candidate.stored - here.stored) -
                  (candidate.dissipated - here.dissipated));
}

/// Why a converged state is not the next point of this path; "" when it is.
std::string Path::objection(const Candidate& candidate) const {
  const Candidate& here = walker_.here();
  const double dissipated = candidate.dissipated - here.dissipated, work = candidate.work - here.work;
  const double missing = unaccounted(candidate);
  constexpr double of_dissipation = 0.1, of_total = 0.02, of_work = 0.01;
  if (missing > of_dissipation * std::max(dissipated, of_total * candidate.dissipated) + of_work * std::abs(work))
    return fmt::format("the step jumps: {:.1e} of its work is unaccounted for", missing / std::abs(work));
  const double before = load_of(walker_.state()), after = load_of(candidate.state);
  if (here.dissipated > 0 && dissipated <= 0 && after < before && walker_.leaving().dissipates)
    return "the step retraces the unloading branch";
  return {};
}

/// Share of the step at which the limit point is to be sought, when the step crosses it and the peak is not yet
/// bracketed: where the tangents of both ends meet, an upper bound of a concave load and exact at a kink.
std::optional<double> Path::before_peak(const Candidate& candidate, double) const {
  const double dissipated = candidate.dissipated - walker_.here().dissipated;
  if (dissipated <= 0 || !walker_.leaving().dissipates || !candidate.arriving.dissipates) return {};
  const double sign = memory_.direction < 0 ? -1 : 1;
  const double rise = sign * walker_.leaving().rate(load_) * dissipated;
  const double fall = sign * candidate.arriving.rate(load_) * dissipated;
  if (rise <= 0 || fall >= 0) return {};
  const double from = load_of(walker_.state()), to = load_of(candidate.state);
  const double share = (to - from - fall) / (rise - fall);
  const double top = from + share * rise, highest = std::max({from, to, memory_.peak_load});
  if (top <= highest * (1 + parameters_.peak_tolerance)) return {};
  return std::clamp(share, 0.1, 0.9);
}

std::vector<Landing> Path::present_landings() const {
  std::vector<Landing> out = landings_;
  if (parameters_.stop.load_below > 0 && memory_.peak_load > 0)
    out.push_back({"load", load_, (memory_.direction < 0 ? -1 : 1) * parameters_.stop.load_below * memory_.peak_load,
                   true});
  return out;
}

std::optional<Path::Crossing> Path::first_crossing(const Candidate& candidate) const {
  std::optional<Crossing> first;
  for (const Landing& landing : present_landings()) {
    const double from = walker_.value(landing.gauge);
    const double to = landing.gauge.value(candidate.state.d, candidate.state.load_factor);
    constexpr double on_it = 1e-7;
    if (std::abs(from - landing.value) <= on_it * std::max(std::abs(landing.value), std::abs(to - from))) continue;
    if ((from - landing.value) * (to - landing.value) > 0) continue;
    const double share = (landing.value - from) / (to - from);
    if (!first || share < first->share) first = Crossing{landing, share};
  }
  return first;
}

std::optional<Point> Path::land(const Candidate& beyond, const Crossing& crossing, const std::string& control) {
  const Landing& landing = crossing.landing;
  const double step = landing.value - walker_.value(landing.gauge);
  const auto equation = make_gauge_control(landing.gauge);
  const Attempt tried = walker_.attempt(*equation, step, between(walker_.state(), beyond.state, crossing.share));
  if (!tried.converged) return {};
  Candidate candidate = walker_.evaluate(tried);
  constexpr double round_off = 1e-9;
  if (!objection(candidate).empty() || candidate.dissipated > beyond.dissipated * (1 + round_off)) {
    ++walker_.effort().rejected;
    return {};
  }
  Point point = keep(std::move(candidate), control);
  point.landed.push_back(fmt::format("{}={:g}", landing.name, landing.value));
  if (landing.ends_path)
    end(Ending::Kind::goal_reached,
        landing.name == "load" ? fmt::format("load below {:g} % of its peak", 100 * parameters_.stop.load_below)
                               : fmt::format("{} reached {:g}", landing.name, landing.value));
  return point;
}

/// Lands on zero load: where the last crack of the structure breaks.
std::optional<Point> Path::rupture() {
  const double load = load_.value(walker_.state().d, walker_.state().load_factor);
  const double rate = walker_.leaving().rate(load_);
  if (load * rate >= 0) return {};
  const auto equation = make_gauge_control(load_);
  const Attempt tried = walker_.attempt(*equation, -load, walker_.ahead(-load / rate));
  if (!tried.converged) return {};
  Candidate candidate = walker_.evaluate(tried);
  if (!objection(candidate).empty()) {
    ++walker_.effort().rejected;
    return {};
  }
  Point point = keep(std::move(candidate), "load");
  point.landed.push_back("complete rupture");
  end(Ending::Kind::goal_reached, "complete rupture");
  return point;
}

/// Looks beyond the point where a control ends, by dissipation: the driver's own word if the path turns against it.
std::string Path::turning_point() {
  if (!walker_.leaving().dissipates) return {};
  for (const double share : {0.01, 0.1, 1.0}) {
    std::string why;
    const auto beyond = try_step(dissipation_move(walker_), share * memory_.last_quantum, why);
    if (!beyond) continue;
    if (std::string turned = driver_->obstacle(beyond->arriving); !turned.empty()) return turned;
  }
  return {};
}

std::optional<Point> Path::sequential_step(const std::string& control, double quantum) {
  const auto found = sequentially_linear(walker_.system(), walker_.state(), quantum);
  if (!found) return {};
  const double dissipated = walker_.here().dissipated;
  const double released = walker_.jump(found->state, found->history);
  memory_.jump_energy += released;
  memory_.step = 0;
  if (control != "event") {
    ++walker_.effort().rescues;
    report("rescued", fmt::format("sequentially linear steps dissipated {:.3e}", walker_.here().dissipated - dissipated));
  }
  Candidate here = walker_.here();
  --walker_.effort().accepted;
  Point point = keep(std::move(here), control);
  point.jump_energy = released;
  return point;
}

/// The first step after a crack: small against the load and against what the fastest point may still open.
double Path::first_amount() const {
  const Tangent& leaving = walker_.leaving();
  if (!leaving.dissipates) return 0.25 * std::min(next_event(walker_), std::max(1e-3, std::abs(walker_.state().load_factor)));
  constexpr double of_load = 0.02, of_opening = 0.1;
  const double load_rate = std::abs(leaving.rate(load_));
  double amount = load_rate > 0 ? of_load * std::abs(load_of(walker_.state())) / load_rate
                                : std::numeric_limits<double>::infinity();
  const System& system = walker_.system();
  const auto laws = system.laws(walker_.state().d, walker_.state().load_factor);
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    if (!system.history()[p].loading) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const double rate = point.law->opening_gradient(laws.opening[p]).dot(system.equilibrium().opening(p, leaving.d));
    const double left = point.law->rupture_kappa(point.stiffness) - system.kappa(p, system.history()[p]);
    if (rate > 0 && left > 0) amount = std::min(amount, of_opening * left / rate);
  }
  return amount;
}

/// No step may be predicted to change load or displacement by more than the deck allows.
double Path::bounded(double amount) const {
  const double load_rate = std::abs(walker_.leaving().rate(load_));
  const double displacement_rate_now = std::abs(displacement_rate(walker_.leaving()));
  if (load_rate > 0 && memory_.peak_load > 0)
    amount = std::min(amount, parameters_.step.largest * memory_.peak_load / load_rate);
  constexpr double of_displacement = 5;  // displacement may grow by half in one step of the default size
  if (displacement_rate_now > 0 && memory_.largest_displacement > 0)
    amount = std::min(amount, of_displacement * parameters_.step.largest * memory_.largest_displacement / displacement_rate_now);
  return amount;
}

/// The next step from how far this one strayed from its tangent.
void Path::resize(const Candidate& candidate, double amount, const Move& move) {
  const State predicted = walker_.ahead(amount);
  const double load = std::abs(load_of(predicted) - load_of(candidate.state)) /
                      std::max(memory_.peak_load, std::abs(load_of(candidate.state)));
  const double displacement =
      std::abs(displacement_of(predicted) - displacement_of(candidate.state)) /
      std::max(memory_.largest_displacement, std::abs(displacement_of(candidate.state)));
  constexpr double balance_share = 0.005;  // of the accuracy, for the energy a step leaves unaccounted for
  const double strayed = std::max({load, displacement, unaccounted(candidate) / candidate.work / balance_share, 1e-12});
  memory_.step = amount * std::clamp(std::sqrt(parameters_.step.accuracy / strayed), 0.3, 2.0);
  memory_.step_control = move.control;
}

Point Path::keep(Candidate candidate, const std::string& control) {
  Point out;
  out.control = control;
  out.newton_iterations = candidate.newton_iterations;
  const double load = load_.value(candidate.state.d, candidate.state.load_factor);
  if (memory_.direction == 0 && load != 0) memory_.direction = load > 0 ? 1 : -1;
  if (const double here = load_of(candidate.state); here > memory_.peak_load) {
    memory_.peak_load = here;
    out.is_highest = true;
  }
  memory_.largest_displacement = std::max(memory_.largest_displacement, std::abs(displacement_of(candidate.state)));
  if (const double quantum = candidate.dissipated - walker_.here().dissipated; quantum > 0)
    memory_.last_quantum = quantum;
  walker_.accept(std::move(candidate));
  out.step = walker_.effort().accepted;
  return out;
}

}  // namespace dda
