#pragma once

#include <array>
#include <string>
#include <vector>

#include "continuation/state/system.hpp"

namespace dda {

/// What of an accepted equilibrium tells whether a path gets anywhere.
struct Station {
  std::vector<double> movements;  ///< openings of points and displacements [L]
  double load_factor = 0;
  double dissipated = 0;   ///< [FL]
  bool is_rescue = false;  ///< no control led to it
  int leg = 0;             ///< of the path's programme

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit, const std::string& name) {
    visit((name + ".movements").c_str(), self.movements);
    visit((name + ".load_factor").c_str(), self.load_factor);
    visit((name + ".dissipated").c_str(), self.dissipated);
    visit((name + ".is_rescue").c_str(), self.is_rescue);
    visit((name + ".leg").c_str(), self.leg);
  }
};

/// Watches a path for standing still: movements, load factor and dissipated energy all stay within a
/// share of their largest so far, for a number of accepted steps in a row; the more steps, the larger the
/// share. A structure that has not moved by 1e-13 of its size has not moved, whatever its load factor. And for going round,
/// as arc length does between two corners at which it turns: coming back in one leg, time and again, to within 1e-4 of a
/// place, which is another one after 1, 2, 4, 8 ... steps, so that rounds of any length are seen.
class Standstill {
 public:
  /// `size` is the structure's [L].
  explicit Standstill(double size = 0) : smallest_(1e-13 * size) {}

  /// Takes in the next accepted equilibrium; how long the path has stood still, "" while it moves. Once told, that is
  /// forgotten: the path may be resumed in another way.
  std::string add(const Station& now);

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("standstill.smallest", self.smallest_);
    visit("standstill.largest_movement", self.largest_movement_);
    visit("standstill.largest_load_factor", self.largest_load_factor_);
    visit("standstill.largest_dissipated", self.largest_dissipated_);
    for (std::size_t i = 0; i < self.watches_.size(); ++i) {
      auto& watch = self.watches_[i];
      const std::string name = "standstill.watch" + std::to_string(i);
      visit((name + ".count").c_str(), watch.count);
      visit((name + ".has_begun").c_str(), watch.has_begun);
      Station::visit(watch.from, visit, name);
    }
    visit("standstill.round.steps", self.round_.steps);
    visit("standstill.round.length", self.round_.length);
    visit("standstill.round.returns", self.round_.returns);
    visit("standstill.round.is_away", self.round_.is_away);
    Station::visit(self.round_.from, visit, "standstill.round");
  }

 private:
  struct Watch {
    double share;
    int most;
    bool of_rescues;  ///< counts these alone
    int count = 0;
    bool has_begun = false;
    Station from = {};
  };

  struct Round {
    Station from = {};
    int steps = 0, length = 1;  ///< since `from`, and after how many another place is taken
    int returns = 0;
    bool is_away = false;
  };

  bool has_moved(const Watch& watch, const Station& now) const;
  std::string note_round(const Station& now);
  void forget();

  double smallest_;  ///< movement that counts [L]
  double largest_movement_ = 0, largest_load_factor_ = 0, largest_dissipated_ = 0;
  Round round_;
  std::array<Watch, 3> watches_{Watch{1e-10, 8, false}, Watch{1e-6, 50, false}, Watch{1e-4, 25, true}};
};

/// Where some interface points are: "(x, y) on 'name'", at most three of them.
std::string places_of(const System& system, const std::vector<std::size_t>& points);

/// The points at which something is going on: those that load, slide or are being released; if there are
/// none, the one nearest its strength.
std::vector<std::size_t> active_points(const System& system, const State& at);

}  // namespace dda
