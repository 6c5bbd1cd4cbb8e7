#include "studies/dda/record/path/events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

/// A quantity at the two ends of a step, with its rates times the width of the step.
struct Cubic {
  double start, end, start_slope, end_slope;

  double value(double x) const {
    const double y = 1 - x;
    return y * y * (1 + 2 * x) * start + x * x * (1 + 2 * y) * end +
           x * y * (y * start_slope - x * end_slope);
  }
  /// Where its derivative vanishes inside the step, when the slopes have opposite signs.
  double extremum() const {
    const double c = start_slope, b = 2 * (3 * (end - start) - 2 * start_slope - end_slope),
                 a = 3 * (start_slope + end_slope - 2 * (end - start));
    double low = 0, high = 1;
    for (int halving = 0; halving < 60; ++halving) {
      const double x = 0.5 * (low + high), slope = c + x * (b + x * a);
      (slope * start_slope > 0 ? low : high) = x;
    }
    return low;
  }
  /// Where the tangents of both ends meet.
  double bound() const {
    const double share = (end - start - end_slope) / (start_slope - end_slope);
    return start + std::clamp(share, 0.0, 1.0) * start_slope;
  }
};

/// What no continuous path led to.
bool is_jump(const Point& point) {
  return point.jump_energy != 0 || point.kind == StepKind::release ||
         point.kind == StepKind::load_increments || point.kind == StepKind::jump;
}

/// Marks what lies at the last row, and is an event only if the path goes on from it.
constexpr const char* pending = "pending";

}  // namespace

Json passed_events(const Json& list) {
  Json out = Json::array();
  for (const Json& event : list)
    if (!event.contains(pending)) out.push_back(event);
  return out;
}

PathEvents::PathEvents(const Measures& measures, const Walker& start, int step, Json known)
    : measures_(measures), list_(std::move(known)) {
  for (Json& event : list_) event.erase(pending);
  before_ = station(start, step);
  largest_.assign(before_.values.size(), 0);
  remember_sizes(before_);
}

void PathEvents::remember_sizes(const CsvTable& curve) {
  for (std::size_t i = 0; i < largest_.size(); ++i)
    for (const double value : curve.numbers(i == 0 ? column::load : measures_.names()[i - 1].name))
      largest_[i] = std::max(largest_[i], std::abs(value));
  remember_sizes(before_);
}

/// Displacements share one size: a gauge that hardly moves beside the others has no turning points.
void PathEvents::remember_sizes(const Station& at) {
  double displacement = 0;
  for (std::size_t i = 0; i < largest_.size(); ++i)
    largest_[i] = std::max(largest_[i], std::abs(at.values[i]));
  for (const std::size_t gauge : measures_.displacements())
    displacement = std::max(displacement, largest_[1 + gauge]);
  for (const std::size_t gauge : measures_.displacements()) largest_[1 + gauge] = displacement;
}

PathEvents::Station PathEvents::station(const Walker& walker, int step) const {
  const Candidate& here = walker.here();
  const Tangent &in = here.arriving, &out = walker.leaving();
  Station now{.step = step,
              .values = {walker.value(measures_.load())},
              .in = {},
              .out = {},
              .load_factor = here.state.load_factor,
              .load_factor_in = in.load_factor,
              .load_factor_out = out.load_factor,
              .dissipated = here.dissipated,
              .dissipates_in = !in.d.empty() && in.dissipates,
              .dissipates_out = !out.d.empty() && out.dissipates,
              .num_negative = here.num_negative,
              .num_negative_work = here.num_negative_work,
              .surplus = here.surplus()};
  const auto rate = [](const Tangent& tangent, const Functional& gauge) {
    return tangent.d.empty() ? std::numeric_limits<double>::quiet_NaN() : tangent.rate(gauge);
  };
  now.in.push_back(rate(in, measures_.load()));
  now.out.push_back(rate(out, measures_.load()));
  for (std::size_t i = 0; i < measures_.num_gauges(); ++i) {
    const Functional& gauge = measures_.functionals()[i];
    now.values.push_back(walker.value(gauge));
    now.in.push_back(rate(in, gauge));
    now.out.push_back(rate(out, gauge));
  }
  return now;
}

bool PathEvents::is_smooth(const Station& now) const {
  return before_.dissipates_out && now.dissipates_in && now.dissipated > before_.dissipated;
}

PathEvents::Station PathEvents::between(const Station& now, double share) const {
  Station out = before_;
  const double width = now.dissipated - before_.dissipated;
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] =
        Cubic{before_.values[i], now.values[i], width * before_.out[i], width * now.in[i]}.value(share);
  out.load_factor =
      Cubic{before_.load_factor, now.load_factor, width * before_.load_factor_out, width * now.load_factor_in}
          .value(share);
  out.dissipated += share * width;
  return out;
}

void PathEvents::begin_stage(const Walker& walker) { before_ = station(walker, before_.step); }

void PathEvents::number_stages(int number) {
  stage_ = number;
  for (Json& event : list_)
    if (number > 0 && !event.contains("stage")) event["stage"] = number;
}

std::set<EventKind> PathEvents::add(const Point& point, const Walker& walker, bool is_last) {
  const Station now = station(walker, point.step);
  remember_sizes(now);
  std::set<EventKind> out;
  if (now.dissipates_out && !before_.dissipates_out && before_.dissipated == 0)
    out.insert(EventKind::first_crack);
  if (find_extremum(0, now, is_jump(point), is_last)) out.insert(EventKind::limit_point);
  for (const std::size_t gauge : measures_.displacements())
    if (find_extremum(1 + gauge, now, is_jump(point), is_last)) out.insert(EventKind::turning_point);
  if (find_bifurcation(now, point, is_last)) out.insert(EventKind::bifurcation);
  if (!point.landed.empty()) out.insert(EventKind::landing);
  if (point.kind == StepKind::release) out.insert(EventKind::release);
  if (is_last) out.insert(EventKind::end);
  before_ = now;
  if (point.switched) before_.surplus.reset();  // the other branch counts its own
  return out;
}

Json PathEvents::extremum(std::size_t quantity, bool is_maximum) const {
  Json out{{"kind", quantity == 0 ? "limit_point" : "turning_point"}};
  out["of"] = quantity == 0 ? "load" : measures_.names()[quantity - 1].name;
  out["extremum"] = is_maximum ? "maximum" : "minimum";
  return out;
}

bool PathEvents::find_extremum(std::size_t quantity, const Station& now, bool is_jump, bool is_last) {
  const double change = now.values[quantity] - before_.values[quantity];
  const bool smooth = !is_jump && is_smooth(now);
  const double from = before_.out[quantity], arrives = smooth ? now.in[quantity] : change;
  constexpr double round_off = 1e-9;
  const double width = now.dissipated - before_.dissipated;
  bool found = false;
  if (smooth && from * arrives < 0 && std::abs(from * width) > round_off * largest_[quantity]) {
    const Cubic cubic{before_.values[quantity], now.values[quantity], width * from, width * arrives};
    const double share = cubic.extremum(), value = cubic.value(share);
    Json event = extremum(quantity, from > 0);
    event["located"] = "in_step";
    event["uncertainty"] = std::abs(cubic.bound() - value) / largest_[quantity];
    list_event(std::move(event), between(now, share));
    found = true;
  }
  const bool moves = std::abs(change) > round_off * largest_[quantity];
  if (moves && arrives * now.out[quantity] < 0) {
    Json event = extremum(quantity, arrives > 0);
    event["located"] = "at_step";
    event["uncertainty"] = 0.0;
    if (is_last) event[pending] = true;
    list_event(std::move(event), now);
    found |= !is_last;
  }
  return found;
}

bool PathEvents::find_bifurcation(const Station& now, const Point& point, bool is_last) {
  if (!now.surplus || !before_.surplus || *now.surplus == *before_.surplus) return false;
  const bool may_be_even =
      now.num_negative == now.num_negative_work && before_.num_negative == before_.num_negative_work;
  if (!may_be_even && (*now.surplus - *before_.surplus) % 2 == 0) return false;
  const bool is_bracketed = std::ranges::find(point.landed, "bifurcation") != point.landed.end();
  const bool is_exact =
      point.kind == StepKind::event || point.kind == StepKind::initiation || point.kind == StepKind::corner;
  Json event{{"kind", "bifurcation"}};
  event["negative_eigenvalues"] = {before_.num_negative.value_or(0), now.num_negative.value_or(0)};
  event["located"] = is_bracketed || is_exact ? "at_step" : "in_step";
  constexpr double bracket = 1e-6;
  event["uncertainty"] = is_bracketed ? bracket
                         : is_exact   ? 0.0
                                      : std::abs(now.values[0] - before_.values[0]) / largest_[0];
  if (point.switched) event["switched"] = true;
  if (is_last) event[pending] = true;
  list_event(std::move(event), now);
  return !is_last;
}

void PathEvents::list_event(Json event, const Station& at) {
  event["step"] = at.step;
  if (stage_ > 0) event["stage"] = stage_;
  event["load"] = at.values[0];
  event["load_factor"] = at.load_factor;
  event["dissipated_energy"] = at.dissipated;
  Json gauges = Json::object();
  for (std::size_t i = 0; i < measures_.num_gauges(); ++i)
    gauges[measures_.names()[i].name] = at.values[i + 1];
  event["gauges"] = std::move(gauges);
  list_.push_back(std::move(event));
}

}  // namespace dda
