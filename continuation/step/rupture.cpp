#include "continuation/follow/landings.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/steps.hpp"

namespace dda {
namespace {

/// Whether what was to crack unloads instead: of what is spent along the tangent, more than half by points
/// that at the candidate neither load nor have broken.
bool unloads(const Walker& walker, const Candidate& candidate) {
  const System& system = walker.system();
  const LawValues laws = system.laws(walker.state());
  double all = 0, unloaded = 0;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const History &before = system.history()[p], &after = candidate.history[p];
    if (!before.loading) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const Spending spending = point.law->spending(laws.opening[p], before, point.stiffness);
    const double rate = point.weight * spending.gradient.dot(walker.leaving().opening[p]);
    all += rate;
    if (!after.loading && !point.law->is_broken(after, point.stiffness)) unloaded += rate;
  }
  return unloaded > 0.5 * all;
}

}  // namespace

std::optional<Point> rupture(PathState& path) {
  const double load = path.walker.state().value(path.load);
  const double rate = path.walker.leaving().rate(path.load);
  if (load * rate >= 0 || path.memory.peak_load <= path.smallest_load()) return {};
  if (std::abs(load) <= path.smallest_load()) return {};  // it stands there
  const std::string attempted = "load, landing on rupture";
  const auto equation = make_gauge_equation(path.load);
  const double ahead = -load / rate;
  auto candidate = judged(path, path.walker.attempt(*equation, -load, path.walker.ahead(ahead)), attempted);
  if (!candidate) return {};
  if (path.walker.leaving().dissipates && unloads(path.walker, *candidate)) {
    path.reject(attempted, "the load falls to nothing by unloading");
    return {};
  }
  if (const auto crossing = first_crossing(path, *candidate))
    return land(path, *candidate, *crossing, StepKind::load);
  Point point = keep(path, *std::move(candidate), StepKind::load);
  if (!bears_load(path)) point.landed.emplace_back("complete rupture");
  return point;
}

}  // namespace dda
