#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/body/body.hpp"
#include "models/body/random_field.hpp"
#include "models/parameters.hpp"

namespace dda {

/// An interface of the deck, made.
struct Interface {
  std::string name;
  std::shared_ptr<const InterfaceLaw> law;
  std::shared_ptr<const Treatment> treatment;
  PointRule points = PointRule::gauss;
  /// Beside blocks of second order.
  PointRule second_order_points = PointRule::gauss;
  std::optional<RandomField> field = {};
  double energy_exponent = 0;
  std::optional<Vec2> crack_normal = {};  ///< a unit vector
  std::optional<WaterParameters> water = {};
  Position where;
  int index = -1;
  // What the sides asked for, for one message per interface.
  std::size_t raised = 0, refused = 0;
  bool misses_linear_stress = false;                             ///< its points beside blocks of second order
  double worst_ratio = std::numeric_limits<double>::infinity();  ///< reachable k over the slope
  double worst_size = 0;                                         ///< [L]

  /// Whether its points have laws of their own.
  bool is_local() const { return field || crack_normal || water; }
};

/// Cracks through the blocks of a region: the interface whose law they have there, and the bonds that its inner sides
/// become.
struct ThroughBlocks {
  Interface bond;
  std::size_t law = 0;   ///< of the interfaces
  double stiffness = 0;  ///< k of a cut in units of that of the block's sides
};

/// The interfaces of a deck, made, and which of them a side belongs to. What does not fit together is a finding.
class InterfaceBook {
 public:
  InterfaceBook(const Body& body, const ModelParameters& model, Findings& findings);

  /// By curve, else a bond in regions through which cracks run, else by material pair, else a bond.
  Interface& of_side(const Side& side);
  /// Of a region that some entry of `cracks` names; null of others.
  const ThroughBlocks* through(int region) const {
    const auto found = through_.find(region);
    return found == through_.end() ? nullptr : &found->second;
  }
  Interface& law_of(const ThroughBlocks& through) { return interfaces_[through.law]; }
  std::vector<Interface>& interfaces() { return interfaces_; }
  const Interface& bond() const { return bond_; }

 private:
  void add(const std::string& name, const InterfaceParameters& p);
  void check_release(const InterfaceParameters& p, const Interface& made);
  void check_plane(const InterfaceParameters& p, const Interface& made);
  void add_field(const FieldParameters& field, Interface& interface);
  void add_crack_normal(const Vec2& normal, Interface& interface);
  void add_water_between_bodies(const WaterParameters& water, Interface& interface);
  void add_water(const WaterParameters& water, Interface& interface);
  void check_names();
  std::string unknown_material(const std::string& name) const;
  void add_crack(const CrackParameters& p);
  /// What to say after the name of an interface that there is not.
  std::string suggested(const std::string& name) const;
  void add_through(int region, const CrackParameters& p);
  std::optional<std::size_t> law_through(const CrackParameters& p, const std::string& material);
  const std::string& material_name(BlockId id) const {
    return body_.assembly.regions[static_cast<std::size_t>(body_.block(id).region)].material;
  }

  const Body& body_;
  const ModelParameters& model_;
  Findings& findings_;
  std::vector<Interface> interfaces_;
  Interface bond_;
  std::map<int, ThroughBlocks> through_;  ///< by region
  std::map<std::string, int> by_curve_;
  std::map<std::pair<std::string, std::string>, int> by_pair_;
};

}  // namespace dda
