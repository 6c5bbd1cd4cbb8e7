#pragma once

#include <memory>
#include <optional>
#include <string>

#include "continuation/control/step_kind.hpp"
#include "continuation/control/stop.hpp"
#include "continuation/detour/increment/load_solver.hpp"
#include "continuation/walk/walker.hpp"
#include "framework/deck/family.hpp"

namespace dda {

/// What a control wants next.
struct Move {
  StepKind kind = StepKind::event;  ///< for the record
  std::shared_ptr<ControlEquation> equation;
  double rate = 0;        ///< change of the control's s per unit of the leaving tangent; the sign counts
  bool to_event = false;  ///< s runs from 0 to 1 and ends on the next initiation
};

/// What leads along the path, a deck's `path.control`: the equation that closes equilibrium in the next step.
///
/// Those of single.cpp keep to one equation; `staged` chooses among them. What is common to all (first crack
/// located by the event equation, step sizes, limit point, landing, rescue) is the Path's.
class Control {
 public:
  virtual ~Control() = default;
  /// The next move from where the walker stands.
  virtual Move next(Walker& walker) = 0;
  /// Why this control cannot go along this direction although equilibria do; nothing when it can.
  virtual std::optional<Stopped> obstacle(const Tangent&) { return {}; }
  /// Rate, along a direction, of what is prescribed; positive where the control goes on.
  virtual double prescribed_rate(const Tangent&) const { return 1; }
  /// What stays while points are released at once; nothing = their own opening.
  virtual std::optional<Functional> held_in_release() const { return {}; }
  /// First load increment, what it brings beyond its strength released, in units of the load at the first
  /// crack; 0 = no increments.
  virtual double load_increment() const { return 0; }
  /// What finds the equilibrium of an increment; null without increments.
  virtual LoadSolver* load_solver() { return nullptr; }
  /// Whether its steps have a size that can be set.
  virtual bool sizes_steps() const { return true; }
  /// Why this control cannot follow the path of this structure; "" when it can.
  virtual std::string refusal(const Equilibrium&) const { return {}; }
  /// Whether a jump may carry on where this control fails.
  virtual bool may_be_rescued() const { return false; }
  /// The one number a control remembers from its first step; a restart brings it back.
  virtual double memory() const { return 0; }
  virtual void restore(double) {}
};

/// Gauges by name and by kind, for controls that need one.
struct GaugeBook {
  std::vector<NamedGauge> gauges;
  std::string first_displacement, first_opening;  ///< names, "" when the deck has none
};

using ControlFamily = Family<Control, const GaugeBook&>;
using ControlChoice = Choice<Control, const GaugeBook&>;

/// The registry behind `path.control`.
ControlFamily& controls();

/// The event equation with its exact prediction; to_event.
Move event_move(const Walker& walker);
/// The load factor prescribed.
Move load_move(const Walker& walker, StepKind kind = StepKind::load);
/// The dissipation equation.
Move dissipation_move(const Walker& walker);

/// Load factor, beyond the present one along the leaving tangent, at which the next unbroken point reaches
/// its κ; infinite when none does. Exact while no crack opens or closes on the way.
double next_event(const Walker& walker);
/// The same of points that are not loading now, in the unit of the leaving tangent.
double next_new_crack(const Walker& walker);
/// Along the leaving tangent to where the first joint begins to slide or to stick, opens or closes, while
/// nothing cracks; infinite when none does. One that stands at such a corner counts as having passed it.
double next_contact_change(const Walker& walker);

/// That change: how far it is along the leaving tangent, and whose it is.
struct ContactChange {
  double amount = 0;  ///< to it
  double beyond = 0;  ///< a hair more: across the corner by 1e-9 of the widest opening
  std::size_t point = 0;
  Vec2 across = Vec2::Zero();  ///< normal to the corner, towards the piece behind
};
std::optional<ContactChange> find_contact_change(const Walker& walker);
/// The opening of its point prescribed, in the direction in which it goes there: it goes on whichever way the path leads
/// after the change, and the control's quantity may not.
Move contact_move(const Walker& walker, const ContactChange& change);
/// The opening of a point prescribed along a part of its rate.
Move opening_move(const Walker& walker, std::size_t point, const Vec2& part);
/// Where the first of the loading points passes the next corner of its softening curve.
double next_corner(const Walker& walker);

}  // namespace dda
