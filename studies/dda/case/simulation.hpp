#pragma once

#include <functional>
#include <memory>

#include "continuation/path/path.hpp"
#include "framework/messages/timings.hpp"
#include "meshing/quality.hpp"
#include "studies/dda/case/deck/deck.hpp"

namespace dda {

/// Deck → Scene → Assembly → Equilibrium → Path, each made once from the one before.
class Simulation {
 public:
  /// Meshes and assembles; throws InputError with what the deck's scene and model do not allow.
  Simulation(const Deck& deck, Timings& timings);

  const Deck& deck() const { return deck_; }
  const Assembly& assembly() const { return *assembly_; }
  const Body& body() const { return *body_; }
  const Equilibrium& equilibrium() const { return *equilibrium_; }
  /// Cracks through blocks; null without.
  const CrackFront* cracks() const { return front_.get(); }
  const CrackedStructure* cracked() const { return cracked_.get(); }
  /// Cuts the blocks as they were cut in a run that goes on.
  void restore_cracks(const std::vector<Cut>& cuts, std::vector<CrackFront::Memory> memory);
  /// Told before a crack changes unknowns and points, and then how they follow from earlier ones.
  void when_grown(std::function<void()> before, std::function<void(const Growth&)> after) {
    grows_ = std::move(before);
    has_grown_ = std::move(after);
  }

  /// Told before the loads of a stage are held, and once the next one has begun.
  void when_held(std::function<void(const StageEnd&)> before, std::function<void()> after) {
    holds_ = std::move(before);
    has_held_ = std::move(after);
  }

  /// Factorises and stands at the start. Call before `walker` and `path`.
  void prepare();
  /// Brings the dead stages to full value; "" or why that failed.
  std::string apply_dead_loads();
  /// Holds the loads of the followed stage at a load factor, and stands at the beginning of the next one.
  void hold_loads(double load_factor);
  /// Stands in the stage that is followed after these, with the supports that were there.
  void go_through(const StageHistory& history);
  /// The path of the followed stages, with the deck's landings.
  void begin_path();
  /// Holds the loads as they are and goes on with the last stage of the deck, which has come since. Throws InputError for one
  /// that cannot serve; the path then goes on as it did.
  void go_on_with_last_stage(const std::string& reason);
  /// Goes on by the control that the deck names by now. Throws InputError for one that cannot serve here.
  void switch_control();
  Walker& walker() { return *walker_; }
  const Walker& walker() const { return *walker_; }
  Stepper& stepper() { return *stepper_; }
  Path& path() { return *path_; }
  const Path& path() const { return *path_; }
  System& system() { return *system_; }
  const System& system() const { return *system_; }
  /// Throws InputError for materials without density, named after what asks for it.
  void require_density(const std::string& asker) const;
  /// What was adapted to the scene or is worth knowing about it; complete after `prepare`.
  const std::vector<std::string>& notices() const { return notices_; }
  /// What may be behind steps that fail or lead nowhere, joints that lock or are tied more often than blocks can move: the
  /// end of the reasons of such stops; "" where nothing is.
  const std::string& hindrance() const { return hindrance_; }
  const GaugeBook& gauges() const { return gauges_; }
  const Loading& loading() const { return equilibrium_->stages().back(); }
  /// Place in the deck's `stages` of the one whose loads are followed.
  std::size_t followed_stage() const {
    return deck_.followed_stages().at(equilibrium_->held_load_factors().size());
  }

 private:
  void assemble();
  /// Throws InputError for stages that apply nothing.
  void require_loads() const;
  /// Throws InputError for a goal at which the path starts, and for gauges that there are not.
  void require_way() const;
  /// Throws InputError for a control that names no known gauge, that cannot serve, or whose steps have no size to
  /// be set.
  void require_control() const;
  /// Throws InputError for a record of places, gauges or sizes that there are not.
  void require_record() const;
  /// Throws InputError for more eigenvalues than there are, or than fit into memory.
  void require_eigenvalues() const;
  std::vector<Landing> landings() const;
  std::vector<Leg> legs() const;
  const Functional& gauge(const std::string& name, const Position& where) const;
  /// Throws InputError for what structures with cracks through blocks cannot be asked for.
  void require_cracks() const;
  /// Puts in and takes away the supports that the followed stage does.
  void change_supports(const SupportChange& change);
  /// The same at the state as it is.
  void change_supports();
  /// Blocks that are large beside what the cohesive zone needs.
  void note_coarse_cracks();
  BlockStress elastic_stress(const Loading& loading);
  void begin_cracks();
  Aims look_up();

  const Deck& deck_;
  Timings& timings_;
  std::unique_ptr<const Assembly> assembly_;
  std::unique_ptr<CrackGeometry> crack_geometry_;
  std::unique_ptr<const Body> body_;
  std::unique_ptr<CrackFront> front_;
  std::unique_ptr<Equilibrium> equilibrium_;
  std::unique_ptr<CrackedStructure> cracked_;
  std::function<void()> grows_;
  std::function<void(const Growth&)> has_grown_;
  std::function<void(const StageEnd&)> holds_;
  std::function<void()> has_held_;
  std::unique_ptr<System> system_;
  std::unique_ptr<Stepper> stepper_;
  std::unique_ptr<Walker> walker_;
  std::unique_ptr<Path> path_;
  GaugeBook gauges_;
  std::vector<std::string> notices_;
  std::string hindrance_;
};

}  // namespace dda
