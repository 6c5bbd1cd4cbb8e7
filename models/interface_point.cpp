#include "models/interface_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "framework/base/suggestion.hpp"
#include "models/interface/scaled_law.hpp"
#include "models/locked_joints.hpp"
#include "models/treatment/trace_constant.hpp"

namespace dda {
namespace {

/// k is kept this far above the steepest softening slope: the trial law then falls at most three times as
/// steeply.
constexpr double comfortable_margin = 1.5;
/// Below this the trial law has no usable softening branch left.
constexpr double smallest_margin = 1.02;

/// An interface of the deck, made.
struct Interface {
  std::string name;
  std::shared_ptr<const InterfaceLaw> law;
  std::shared_ptr<const Treatment> treatment;
  PointRule points = PointRule::gauss;
  std::optional<RandomField> field = {};
  double energy_exponent = 0;
  Position where;
  int index = -1;
  // What the sides asked for, for one message per interface.
  std::size_t raised = 0, refused = 0;
  double worst_ratio = std::numeric_limits<double>::infinity();  ///< reachable k over the slope
  double worst_size = 0;                                         ///< [L]
};

/// Shares of the side and weights of its points.
std::vector<std::pair<double, double>> quadrature(PointRule rule) {
  const double g = 0.5 / std::sqrt(3.0);
  switch (rule) {
    case PointRule::vertices:
      return {{0.0, 0.5}, {1.0, 0.5}};
    case PointRule::midpoint:
      return {{0.5, 1.0}};
    case PointRule::gauss:
      break;
  }
  return {{0.5 - g, 0.5}, {0.5 + g, 0.5}};
}

/// Exactly closed points cannot open one by one unless each has a corner of its own to move: of two Gauss
/// points on a side, the second holds what the first lets go.
PointRule usual_points(const Treatment& treatment) {
  return treatment.multiplier() == Multiplier::none ? PointRule::gauss : PointRule::vertices;
}

/// Finds the interface of a side and makes its points.
class PointMaker {
 public:
  PointMaker(const Body& body, const ModelParameters& model, Findings& findings)
      : body_(body), model_(model), findings_(findings) {
    for (const auto& [name, parameters] : model.interfaces) add(name, parameters);
    bond_.law = interface_laws().choose("bonded").make();
    bond_.treatment = treatments().choose("consistent").make();
    check_names();
    for (std::size_t i = 0; i < body.assembly.num_blocks(); ++i) faces_.push_back(face(BlockId{i}));
  }

  InterfaceSet make() {
    InterfaceSet out;
    const auto& sides = body_.assembly.sides;
    for (std::size_t s = 0; s < sides.size(); ++s) add_side(s, interface_of(sides[s]), out);
    const auto middle =
        std::ranges::stable_partition(out.points, [](const auto& p) { return p.is_active(); });
    out.num_active = static_cast<std::size_t>(middle.begin() - out.points.begin());
    for (Interface& interface : interfaces_) {
      out.names.push_back(interface.name);
      out.laws.push_back(interface.law);
      report(interface, out.notices);
    }
    out.laws.push_back(bond_.law);
    return out;
  }

 private:
  void add(const std::string& name, const InterfaceParameters& p) {
    Interface made{.name = name,
                   .law = p.law.make(),
                   .treatment = p.treatment.make(),
                   .points = {},
                   .where = p.where,
                   .index = static_cast<int>(interfaces_.size())};
    made.points = p.points.value_or(usual_points(*made.treatment));
    check_release(p, made);
    if (p.field) add_field(*p.field, made);
    if (p.between.empty())
      by_curve_[name] = made.index;
    else
      by_pair_[ordered(p.between[0], p.between[1])] = made.index;
    for (const std::string& material : p.between)
      if (!model_.material_names.contains(material)) findings_.add(p.where, unknown_material(material));
    interfaces_.push_back(std::move(made));
  }

  /// A release holds the trial opening of a point and lets its traction go. A multiplier's traction is not
  /// that of its trial opening while the side's other point holds the side: it would pass the envelope
  /// unseen.
  void check_release(const InterfaceParameters& p, const Interface& made) {
    if (made.law->releases_at_once() && made.treatment->multiplier() != Multiplier::none)
      findings_.add(p.where, fmt::format("interface '{}': the law '{}' releases at once, which joints with "
                                         "multipliers ('{}') cannot follow without passing its strength; use "
                                         "the treatment 'consistent' or 'penalty', or a law that softens",
                                         made.name, p.law.name(), p.treatment.name()));
  }

  /// A field that does not vary leaves the law as it is.
  void add_field(const FieldParameters& field, Interface& interface) {
    if (!std::isfinite(interface.law->initial_kappa(1)))
      return findings_.add(interface.where, "`field` needs a law with a strength that can vary");
    if (field.coefficient_of_variation == 0) return;
    interface.field.emplace(field);
    interface.energy_exponent = field.energy_exponent;
  }

  void check_names() {
    const auto& curves = body_.assembly.curves;
    for (const auto& [name, index] : by_curve_)
      if (std::ranges::find(curves, name) == curves.end())
        findings_.add(
            interfaces_[static_cast<std::size_t>(index)].where,
            fmt::format("the scene has no interface curve '{}'{}; or give `between: [a, b]` for a pair of "
                        "materials",
                        name, suggest(name, curves)));
    for (const std::string& curve : curves)
      if (!by_curve_.contains(curve))
        findings_.add(
            model_.where,
            fmt::format("the scene names an interface '{}' that `interfaces` does not describe", curve));
  }

  std::string unknown_material(const std::string& name) const {
    std::vector<std::string> known;
    for (const auto& [known_name, choice] : model_.material_names) known.push_back(known_name);
    return fmt::format("unknown material '{}'{}", name, suggest(name, known));
  }

  static std::pair<std::string, std::string> ordered(std::string a, std::string b) {
    return a < b ? std::pair(std::move(a), std::move(b)) : std::pair(std::move(b), std::move(a));
  }

  /// What a place of an interface is made of.
  struct Local {
    double factor = 1;
    std::shared_ptr<const InterfaceLaw> law;
  };
  static Local local_law(const Interface& interface, const Vec2& x) {
    if (!interface.field) return {1, interface.law};
    const double f = interface.field->factor(x), opening = std::pow(f, interface.energy_exponent - 1);
    return {f, std::make_shared<const ScaledLaw>(interface.law, f, opening)};
  }

  /// By curve, else by material pair, else a bond.
  Interface& interface_of(const Side& side) {
    if (side.curve)
      if (const auto found = by_curve_.find(body_.assembly.curves[static_cast<std::size_t>(*side.curve)]);
          found != by_curve_.end())
        return interfaces_[static_cast<std::size_t>(found->second)];
    const auto found = by_pair_.find(ordered(material_name(side.first), material_name(side.second)));
    return found != by_pair_.end() ? interfaces_[static_cast<std::size_t>(found->second)] : bond_;
  }

  const std::string& material_name(BlockId id) const {
    return body_.assembly.regions[static_cast<std::size_t>(body_.block(id).region)].material;
  }

  BlockFace face(BlockId id) const {
    const Mat3 c = body_.material(id).stiffness();
    return {c, trace_constant(body_.block(id), c), body_.material(id).modulus()};
  }

  SideFaces faces_of(const Side& side) const {
    const Vec2 edge = side.end - side.start;
    const double distance =
        (body_.block(side.second).moments.centroid - body_.block(side.first).moments.centroid).norm();
    return {faces_[side.first.value()], faces_[side.second.value()], distance, edge.norm(),
            Vec2(edge.y(), -edge.x()) / edge.norm()};
  }

  void add_side(std::size_t index, Interface& interface, InterfaceSet& out) {
    const Side& side = body_.assembly.sides[index];
    const Vec2 edge = side.end - side.start;
    const Vec2 centre = body_.block(side.first).moments.centroid,
               other = body_.block(side.second).moments.centroid;
    const SideFaces faces = faces_of(side);
    const auto places = quadrature(interface.points);
    std::vector<Local> laws;
    for (const auto& [xi, share] : places) laws.push_back(local_law(interface, side.start + xi * edge));
    const double k = stiffness(interface, laws, faces, side);
    const Treatment& treatment = *interface.treatment;
    const BlockId node{body_.assembly.num_blocks() + out.num_nodes};
    if (treatment.multiplier() == Multiplier::unknown) ++out.num_nodes;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto& [xi, share] = places[i];
      const bool is_separate = laws[i].law->contact({}, k).has_value();
      InterfacePoint point{.first = side.first,
                           .second = side.second,
                           .x = side.start + xi * edge,
                           .normal = faces.normal,
                           .weight = share * edge.norm() * body_.thickness,
                           .stiffness = k,
                           .law = laws[i].law.get(),
                           .interface = interface.index,
                           .side = index,
                           .rows = {},
                           .multiplier = treatment.multiplier(),
                           .node = node,
                           .column = static_cast<int>(2 * i),
                           .perturbation = treatment.perturbation(is_separate),
                           .physical_stiffness = physical_stiffness(treatment, faces, k, is_separate),
                           .spring_unit = spring_unit(faces),
                           .strength_factor = laws[i].factor};
      point.rows = treatment.rows(faces, displacement_rows(point.x - centre),
                                  displacement_rows(point.x - other), point.trial_stiffness());
      out.points.push_back(std::move(point));
      if (interface.field) out.laws.push_back(std::move(laws[i].law));
    }
    out.has_fields = out.has_fields || interface.field.has_value();
  }

  /// p̄, at most what the multipliers' own compliance δ/((1 + δ) k) leaves of it where bodies only touch.
  static double physical_stiffness(const Treatment& treatment, const SideFaces& faces, double k,
                                   bool is_separate) {
    const double own = treatment.physical_stiffness(faces),
                 perturbation = treatment.perturbation(is_separate);
    const double largest = is_separate && perturbation > 0 ? k * (1 + perturbation) / perturbation
                                                           : std::numeric_limits<double>::infinity();
    return std::max(k, std::min(own, largest));
  }

  /// The treatment's k, raised where a steep law needs it.
  double stiffness(Interface& interface, const std::vector<Local>& laws, const SideFaces& faces,
                   const Side& side) {
    const double beta = interface.law->shear_weight();
    const double own = interface.treatment->stiffness(faces) / std::min(1.0, beta * beta);
    double slope = 0;
    for (const Local& local : laws) slope = std::max(slope, local.law->steepest_slope());
    if (own >= comfortable_margin * slope) return own;
    const double largest = interface.treatment->largest_stiffness(faces) / std::min(1.0, beta * beta);
    const double raised = std::clamp(comfortable_margin * slope, own, std::max(own, largest));
    note(interface, raised / slope, raised > own, std::sqrt(body_.block(side.first).moments.area));
    return raised;
  }

  static void note(Interface& interface, double ratio, bool raised, double size) {
    if (ratio < smallest_margin)
      ++interface.refused;
    else if (raised)
      ++interface.raised;
    if (ratio >= interface.worst_ratio) return;
    interface.worst_ratio = ratio;
    interface.worst_size = size;
  }

  void report(const Interface& interface, std::vector<std::string>& notices) {
    if (interface.refused > 0)
      findings_.add(
          interface.where,
          fmt::format("the blocks are too large for the softening of interface '{}' ({} sides): with blocks "
                      "of size {:.3g} the joint reaches {:.3g} times the softening slope and needs {:g}; use "
                      "blocks below {:.3g}, or a larger fracture energy",
                      interface.name, interface.refused, interface.worst_size, interface.worst_ratio,
                      smallest_margin, interface.worst_size * interface.worst_ratio / comfortable_margin));
    if (interface.raised > 0)
      notices.push_back(
          fmt::format("interface '{}': joint stiffness raised on {} sides, its softening is steep for "
                      "blocks of this size",
                      interface.name, interface.raised));
  }

  const Body& body_;
  const ModelParameters& model_;
  Findings& findings_;
  std::vector<Interface> interfaces_;
  Interface bond_;
  std::map<std::string, int> by_curve_;
  std::map<std::pair<std::string, std::string>, int> by_pair_;
  std::vector<BlockFace> faces_;
};

}  // namespace

InterfaceSet make_interface_points(const Body& body, const ModelParameters& model, Findings& findings) {
  InterfaceSet out = PointMaker(body, model, findings).make();
  std::ranges::move(locked_joints(body, out), std::back_inserter(out.notices));
  return out;
}

}  // namespace dda
