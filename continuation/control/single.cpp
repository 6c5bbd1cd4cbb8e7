#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "continuation/control/control.hpp"
#include "framework/base/suggestion.hpp"

namespace dda {
namespace {

/// Σ |row_i ḋ_i| + |∂g/∂λ λ̇|: what the rate of a gauge is the sum of, none of it cancelled.
double moved_parts(const Tangent& along, const Functional& gauge) {
  double out = std::abs(gauge.per_load_factor * along.load_factor);
  for (const auto& [block, row] : gauge.rows)
    for (int i = 0; i < row.size(); ++i)
      if (row[i] != 0) out += std::abs(along.d.value({.rows = {{block, row[i] * Vec6::Unit(i)}}}, 0));
  return out;
}

/// Whether a gauge moves along a direction by no more than rounding leaves of parts that cancel, as the mouth of a joint
/// that is rigid until it cracks. The sign of that is none.
bool is_still(const Tangent& along, const Functional& gauge) {
  constexpr double rounding = 1e-10;
  return std::abs(along.rate(gauge)) <= rounding * moved_parts(along, gauge);
}

/// A gauge prescribed step by step in one direction, λ multiplying the reference load.
class GaugeControl final : public Control {
 public:
  GaugeControl(StepKind kind, std::string name, Functional gauge)
      : kind_(kind), name_(std::move(name)), gauge_(std::move(gauge)) {}

  Move next(Walker& walker) override {
    const Tangent& along = walker.leaving();
    return {.kind = kind_,
            .equation = make_gauge_equation(gauge_),
            .rate = is_still(along, gauge_) ? 0 : along.rate(gauge_)};
  }

  std::optional<Stopped> obstacle(const Tangent& along) override {
    const double now = along.rate(gauge_);
    if (is_still(along, gauge_))
      return Stopped{Stop::gauge_stands, fmt::format("'{}' does not move along the path", name_)};
    if (direction_ == 0) direction_ = now > 0 ? 1.0 : -1.0;
    if (now * direction_ > 0) return {};
    if (kind_ == StepKind::load)
      return Stopped{Stop::limit_point,
                     "limit point of the load: load control cannot follow the path down; use `staged` or "
                     "`arc_length`"};
    return Stopped{Stop::snap_back,
                   fmt::format("'{}' snaps back here: {} control cannot follow; use `staged` or `arc_length`",
                               name_, to_string(kind_))};
  }
  double prescribed_rate(const Tangent& along) const override {
    return direction_ == 0 ? 1 : along.rate(gauge_) * direction_;
  }
  std::optional<Functional> held_in_release() const override { return gauge_; }
  double memory() const override { return direction_; }
  void restore(double direction) override { direction_ = direction; }

 private:
  StepKind kind_;
  std::string name_;
  Functional gauge_;
  double direction_ = 0;  ///< in which the gauge moves from where it first moves in the stage; 0 before
};

Schema<NoParameters> load_schema() {
  return Schema<NoParameters>("The load factor is prescribed; ends at the limit point.");
}
std::unique_ptr<Control> make_load(const NoParameters&, const GaugeBook&) {
  return std::make_unique<GaugeControl>(StepKind::load, "load factor",
                                        Functional{.rows = {}, .per_load_factor = 1});
}

struct GaugeControlParameters {
  std::string gauge;
  Position where;
};

/// The named gauge of the book, or the first of its kind.
const NamedGauge& find_gauge(const GaugeControlParameters& p, const GaugeBook& book, const std::string& first,
                             const std::string& control) {
  const std::string& wanted = p.gauge.empty() ? first : p.gauge;
  std::vector<std::string> names;
  for (const NamedGauge& gauge : book.gauges) {
    if (gauge.name == wanted) return gauge;
    names.push_back(gauge.name);
  }
  if (wanted.empty())
    throw InputError(
        p.where, fmt::format("{} control needs a gauge: add one to `gauges` or name it in `gauge`", control));
  throw InputError(p.where, fmt::format("unknown gauge '{}'{}", wanted, suggest(wanted, names)));
}

Schema<GaugeControlParameters> gauge_schema(const std::string& text, const std::string& fallback) {
  using P = GaugeControlParameters;
  return Schema<P>(text).text(
      "gauge", &P::gauge,
      {.fallback = "", .text = "Name of the gauge that is prescribed; " + fallback + " if empty."});
}
std::unique_ptr<Control> make_displacement(const GaugeControlParameters& p, const GaugeBook& book) {
  const NamedGauge& gauge = find_gauge(p, book, book.first_displacement, "displacement");
  return std::make_unique<GaugeControl>(StepKind::displacement, gauge.name, gauge.functional);
}
std::unique_ptr<Control> make_opening(const GaugeControlParameters& p, const GaugeBook& book) {
  const NamedGauge& gauge = find_gauge(p, book, book.first_opening, "opening");
  return std::make_unique<GaugeControl>(StepKind::opening, gauge.name, gauge.functional);
}

struct ArcLengthParameters {
  Metric metric = Metric::openings;
  double load_share = 0.1;
};

/// Arc length, measured along the leaving tangent t = (d', λ')/‖(d', λ')‖,
///
///     N = ⟨d', d − d_start⟩ + θ² λ' (λ − λ_start) − s
///
/// with the inner product of the metric. The weight θ of the load factor is fixed once, by its share of the
/// elastic response.
class ArcLengthControl final : public Control {
 public:
  explicit ArcLengthControl(const ArcLengthParameters& p) : p_(p) {}

  Move next(Walker& walker) override {
    const Tangent& leaving = walker.leaving();
    std::vector<double> weighted = leaving.d;
    walker.system().apply_metric(p_.metric, weighted);
    const double displacement =
        std::sqrt(std::inner_product(weighted.begin(), weighted.end(), leaving.d.begin(), 0.0));
    if (weight_ == 0)
      weight_ = std::sqrt(p_.load_share / (1 - p_.load_share)) * displacement / std::abs(leaving.load_factor);
    const double norm = std::hypot(displacement, weight_ * leaving.load_factor);
    Functional along{.rows = {}, .per_load_factor = weight_ * weight_ * leaving.load_factor / norm};
    along.add_rows(1 / norm, weighted);
    return {.kind = StepKind::arc_length, .equation = make_gauge_equation(std::move(along)), .rate = norm};
  }
  double memory() const override { return weight_; }
  void restore(double weight) override { weight_ = weight; }

 private:
  ArcLengthParameters p_;
  double weight_ = 0;
};

Schema<ArcLengthParameters> arc_schema() {
  using P = ArcLengthParameters;
  return Schema<P>("Arc length: the distance travelled in displacements and load is prescribed.")
      .one_of(
          "metric", &P::metric, {{"openings", Metric::openings}, {"natural", Metric::natural}},
          {.fallback = Metric::openings,
           .text =
               "What distance is: of the interface openings, or (`natural`) of all displacements, rotations "
               "and strains, which the elastic blocks move too: smaller steps along a crack, and each has a "
               "solution of its own for all unknowns."})
      .number("load_share", &P::load_share,
              {.fallback = 0.1,
               .bounds = strictly_between(0, 1),
               .text = "Share of the load factor in the squared length of the first, elastic step."});
}

}  // namespace

DDA_REGISTER(controls(), "load", load_schema(), make_load);
DDA_REGISTER(controls(), "displacement",
             gauge_schema("A displacement is prescribed, the load factor follows.", "the first displacement"),
             make_displacement);
DDA_REGISTER(controls(), "opening",
             gauge_schema("A relative displacement (CMOD, CMSD) is prescribed.",
                          "the first relative displacement"),
             make_opening);
DDA_REGISTER(controls(), "arc_length", arc_schema(), make_of<ArcLengthControl>);

}  // namespace dda
