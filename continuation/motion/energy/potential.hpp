#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "continuation/bodies/bonds.hpp"
#include "continuation/bodies/sliders.hpp"
#include "continuation/motion/energy/block_sum.hpp"
#include "continuation/motion/energy/clamped_springs.hpp"
#include "continuation/motion/energy/damping.hpp"

namespace dda {

/// Energies of a scene, by what stores them [F L].
struct StoredEnergies {
  double strain = 0, springs = 0, bonds = 0, contact = 0, friction = 0;
  double impacts = 0;  ///< taken by impacts under way, which may still give it back

  double of_contacts() const { return contact + friction; }
  double sum() const { return strain + springs + bonds + contact + friction + impacts; }
};

/// Friction of a bond that is bounded by a given closing.
struct RubbingBond {
  std::size_t bond = 0;
  double closing = 0;      ///< [L]
  double per_closing = 0;  ///< W k tan φ [F/L]

  double bound() const { return per_closing * closing; }  ///< μ N [F]
};

/// What the step minimises beside inertia: Π(z) = strain + springs + bonds + contact + friction + damping − f·z.
///
/// Forces are a vector of 6 per body, and curvatures a symmetric matrix over the bodies that are not held: of every part
/// its semidefinite share, so that Newton's directions lead down; joints that soften as they do, or by their secant.
class Potential {
 public:
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::SparseMatrix<double>;

  /// Whether joints remember what a step has done to them, or stay as damaged as they are.
  enum class Histories { grow, frozen };

  Potential(const MovingScene& scene, const MeetingSearch& search, const std::vector<Bond>& bonds,
            const DampingRates& damping = {});
  void set_histories(Histories histories) { histories_ = histories; }
  /// Bodies go through each other.
  void leave_out_meetings() { has_meetings_ = false; }

  /// Where the step begins: frames of bonds, and motions of sliders, are from there; what may meet is what does there.
  void begin(const Poses& start);
  /// How the steps that begin from now on are damped, if they are.
  void set_damped(Damping::Step step) { damped_ = std::move(step); }
  void set_sliders(std::vector<Slider> sliders) { sliders_ = std::move(sliders); }
  const std::vector<Slider>& sliders() const { return sliders_; }
  /// Bonds that are cracked or crack at a place, with the closings there.
  std::vector<RubbingBond> rubbing(const Poses& at) const;
  /// Friction of these is bounded by the closings given, that of all others by their own.
  void set_rubbing(const std::vector<RubbingBond>& bonds);
  bool has_friction() const { return !sliders_.empty() || has_rubbing_; }
  const std::vector<Bond>& bonds() const { return bonds_; }
  BondState state_of(std::size_t bond, const Poses& at) const {
    return dda::state_of(bonds_[bond], frames_[bond], at);
  }
  void set_candidates(std::vector<MeetingSearch::Pair> pairs) { pairs_ = std::move(pairs); }
  const std::vector<MeetingSearch::Pair>& candidates() const { return pairs_; }

  /// ∂Π/∂z; of held bodies what it takes to hold them.
  Vector gradient(const Poses& at) const;
  /// Adds the part of contacts and sliders of it.
  void add_meeting_forces(const Poses& at, Vector& out) const;
  /// How joints that soften enter the curvature: by their tangent, or by their secant, which is never negative.
  enum class Softening { tangent, secant };
  /// The lower triangle of ∂²Π/∂z² + c M of what moves, and the forces on it where held bodies go ways: none when these
  /// are empty.
  struct Curvature {
    const Matrix& matrix;
    const std::vector<ClampedSpring>& springs;  ///< contacts and sliders, and contacts that may come
    Vector pull;
    bool has_new_pattern;  ///< since the last time
  };
  Curvature curvature(const Poses& at, double per_square_time, Softening softening, const Poses& ways);
  StoredEnergies stored(const Poses& at) const;
  /// What damping spends on the way there [F L].
  double spent_by_damping(const Poses& at) const { return damping_ ? damping_->spent(at) : 0; }
  /// Π, what joints and sliders would spend on the way included [F L].
  double value(const Poses& at) const;
  /// What rounding of places may leave of the forces on each body, those of inertia c M included: stiffness times
  /// 4 ε |x|, summed [F].
  std::vector<double> rounding(const Poses& at, double per_square_time) const;
  /// What meets; the candidates must be those of ways that lead there.
  std::vector<Meeting> meetings(const Poses& at) const;
  /// Pairs that may meet on the way, and all meetings at a place, whatever the candidates.
  std::vector<MeetingSearch::Pair> all_candidates(const Poses& from, const Poses& to) const {
    return search_.candidates(from, to);
  }
  std::vector<Meeting> meetings_anywhere(const Poses& at) const {
    return search_.find(search_.candidates(at, at), at);
  }
  double free_share(const Poses& z, const Poses& dz) const { return search_.free_share(pairs_, z, dz); }

  /// The row of a body in what moves; −1 of a held one.
  int row_of(std::size_t body) const { return rows_[body]; }
  Eigen::Index num_moving() const { return num_moving_; }

 private:
  const std::vector<Meeting>& near(const Poses& at) const;
  template <class Visit>
  void for_each_meeting(const Poses& at, Visit visit) const {
    for (const Meeting& meeting : near(at))
      if (meeting.distance < scene_.meeting.reach) visit(meeting);
  }
  Response bond_response(std::size_t bond, const Vec2& opening) const;
  void add_bonds(const Poses& at, Softening softening, Curvatures& out) const;
  bool prepare_pattern();
  void add_clamped(const Poses& at, Curvatures& sum);

  const MovingScene& scene_;
  const MeetingSearch& search_;
  const std::vector<Bond>& bonds_;
  bool has_meetings_ = true;
  std::vector<int> rows_;
  Eigen::Index num_moving_ = 0;
  Poses start_;
  std::vector<Mat2> frames_;                     ///< of the bonds
  std::vector<std::size_t> with_friction_;       ///< bonds
  std::vector<std::optional<double>> closings_;  ///< of the bonds, where they are given [L]
  bool has_rubbing_ = false;
  Histories histories_ = Histories::grow;
  std::optional<Damping> damping_;
  Damping::Step damped_;
  std::vector<Slider> sliders_;
  std::vector<MeetingSearch::Pair> pairs_;
  std::vector<BlockSum::Pair> lasting_;  ///< of bonds and springs, as rows
  std::vector<ClampedSpring> clamped_;   ///< of the last curvature
  mutable Poses near_at_;                ///< where it was last looked for what is near
  mutable std::vector<Meeting> near_;    ///< there
  BlockSum sum_;
  bool has_pattern_ = false;  ///< of this step
};

}  // namespace dda
