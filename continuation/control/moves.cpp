#include <algorithm>
#include <limits>

#include "continuation/contact/contact_piece.hpp"
#include "continuation/control/control.hpp"
#include "continuation/state/reach.hpp"

namespace dda {

namespace {

/// Along the leaving tangent, of the points that `is_meant` names.
template <class Meant>
double nearest_initiation(const Walker& walker, Meant is_meant) {
  const System& system = walker.system();
  const State& at = walker.state();
  const LawValues laws = system.laws(at);
  const std::vector<Vec2>& rates = walker.leaving().opening;
  double fastest = 0;
  for (const Vec2& rate : rates) fastest = std::max(fastest, rate.norm());
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    constexpr double round_off = 1e-12;  // a point moving more slowly does not move
    const Vec2 rate = (rates[p].array().abs() > round_off * fastest).select(rates[p], 0.0);
    if (system.is_broken(p) || !is_meant(system.history()[p])) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    nearest =
        std::min(nearest, reach({*point.law, system.history()[p], point.stiffness}, laws.opening[p], rate));
  }
  return nearest;
}

}  // namespace

double next_event(const Walker& walker) {
  return nearest_initiation(walker, [](const History&) { return true; });
}

double next_new_crack(const Walker& walker) {
  return nearest_initiation(walker, [](const History& h) { return !h.loading; });
}

double next_corner(const Walker& walker) {
  const System& system = walker.system();
  const State& at = walker.state();
  const LawValues laws = system.laws(at);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const History& h = system.history()[p];
    if (!h.loading || system.is_broken(p)) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const double rate =
        point.law->opening_gradient(laws.opening[p], h, point.stiffness).dot(walker.leaving().opening[p]);
    const double left = point.law->next_corner(h, point.stiffness) - system.kappa(p);
    if (rate > 0) nearest = std::min(nearest, left / rate);
  }
  return nearest;
}

Move event_move(const Walker& walker) {
  return {
      .kind = StepKind::event, .equation = make_event_equation(walker.system()), .rate = 1, .to_event = true};
}

Move load_move(const Walker& walker, StepKind kind) {
  return {.kind = kind,
          .equation = make_gauge_equation({.rows = {}, .per_load_factor = 1}),
          .rate = walker.leaving().load_factor};
}

Move dissipation_move(const Walker& walker) {
  return {.kind = StepKind::dissipation, .equation = make_dissipation_equation(walker.system()), .rate = 1};
}

std::optional<ContactChange> find_contact_change(const Walker& walker) {
  const System& system = walker.system();
  const LawValues laws = system.laws(walker.state());
  const std::vector<Vec2>& rates = walker.leaving().opening;
  double fastest = 0, widest = 0;
  for (std::size_t p = 0; p < rates.size(); ++p) {
    fastest = std::max(fastest, rates[p].norm());
    widest = std::max(widest, laws.opening[p].norm());
  }
  constexpr double round_off = 1e-10, hair = 1e-9, grazing = 1e-6;
  std::optional<ContactChange> nearest;
  for (std::size_t p = 0; p < rates.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const auto contact = point.law->contact(system.history()[p], point.stiffness);
    if (!contact || rates[p].norm() <= round_off * fastest) continue;
    const ContactPiece piece = piece_at(*contact, laws.opening[p], system.history()[p].sliding);
    const auto end = end_of_piece(*contact, piece, laws.opening[p], rates[p]);
    const bool is_ahead = end && end->length * rates[p].norm() > round_off * widest;
    if (!is_ahead || (nearest && end->length >= nearest->amount)) continue;
    const Vec2 normal = change_between(*contact, piece, end->to).v;
    const Vec2 across = normal.dot(rates[p]) < 0 ? Vec2(-normal) : normal;
    const double crossing = std::max(across.normalized().dot(rates[p]), grazing * rates[p].norm());
    nearest = {end->length, end->length + hair * widest / crossing, p, across};
  }
  return nearest;
}

double next_contact_change(const Walker& walker) {
  const auto change = find_contact_change(walker);
  return change ? change->amount : std::numeric_limits<double>::infinity();
}

Move contact_move(const Walker& walker, const ContactChange& change) {
  return opening_move(walker, change.point, walker.leaving().opening[change.point]);
}

Move opening_move(const Walker& walker, std::size_t point, const Vec2& part) {
  const System& system = walker.system();
  return {.kind = StepKind::corner,
          .equation = make_gauge_equation(
              system.equilibrium().opening_gauge(system.loading(), point, part.normalized())),
          .rate = part.norm()};
}

}  // namespace dda
