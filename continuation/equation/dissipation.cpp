#include "continuation/equation/control_equation.hpp"

namespace dda {
namespace {

class DissipationEquation final : public ControlEquation {
 public:
  explicit DissipationEquation(const System& system) : system_(system) {}

  void start_at(const ControlPoint&, double scale) override { scale_ = scale; }

  double residual(const ControlPoint& at, double s) const override {
    double sum = 0;
    for (std::size_t p = 0; p < at.laws.opening.size(); ++p)
      sum += system_.equilibrium().point(p).weight * spending(at, p).value;
    return (sum - s) / scale_;
  }

  double gradient(const ControlPoint& at, std::span<double> per_d) const override {
    const Equilibrium& equilibrium = system_.equilibrium();
    std::vector<Vec2> per_q(at.laws.opening.size());
    for (std::size_t p = 0; p < per_q.size(); ++p) per_q[p] = spending(at, p).gradient / scale_;
    equilibrium.scatter_add(components(per_q), per_d);
    double per_load_factor = 0;
    for (std::size_t p = 0; p < per_q.size(); ++p)
      per_load_factor += equilibrium.point(p).weight * per_q[p].dot(system_.loading().reference_opening(p));
    return per_load_factor;
  }

  std::optional<ControlSum> as_sum(double s) const override {
    return ControlSum{.gauge = nullptr, .spends = true, .target = s, .scale = scale_};
  }
  double per_path() const override { return -1 / scale_; }
  bool only_sizes_step() const override { return true; }

 private:
  /// What a point spends; one that the path leaves by loading counts at once, with the slope of its surface.
  Spending spending(const ControlPoint& at, std::size_t p) const {
    const InterfacePoint& point = system_.equilibrium().point(p);
    return point.law->spending(at.laws.opening[p], system_.history()[p], point.stiffness);
  }

  const System& system_;
  double scale_ = 1;
};

}  // namespace

std::unique_ptr<ControlEquation> make_dissipation_equation(const System& system) {
  return std::make_unique<DissipationEquation>(system);
}

}  // namespace dda
