#include "continuation/strategy/driver.hpp"

namespace dda {
namespace {

struct IncrementParameters {
  double increment = 0.05;
};

/// Load increments as Pearce et al. (2000) used them: the path releases everything that an increment brings
/// beyond its strength, and halves increments that find no equilibrium. For comparison with exact events.
class LoadIncrements final : public Driver {
 public:
  explicit LoadIncrements(const IncrementParameters& p) : increment_(p.increment) {}

  Move next(Walker& walker) override { return event_move(walker); }
  double load_increment() const override { return increment_; }
  double prescribed_rate(const Tangent& along) const override { return along.load_factor; }

 private:
  double increment_;
};

Schema<IncrementParameters> schema() {
  return Schema<IncrementParameters>(
             "Load increments, halved near failure; what is beyond its strength is released at once "
             "(mohr_coulomb).")
      .number("increment", &IncrementParameters::increment,
              {.fallback = 0.05,
               .bounds = above(0) & at_most(1),
               .text = "First size of an increment in units of the load at the first crack."});
}

std::unique_ptr<Driver> make(const IncrementParameters& p, const GaugeBook&) {
  return std::make_unique<LoadIncrements>(p);
}

}  // namespace

DDA_REGISTER(drivers(), "load_increments", schema(), make);

}  // namespace dda
