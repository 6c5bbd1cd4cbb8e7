#include "studies/dda/record/path/trace.hpp"

namespace dda {
namespace {

std::vector<double> rates(const Tangent& tangent, const Measures& measures) {
  const bool known = tangent.dissipates && !tangent.d.empty();
  const auto rate = [&](const Functional& gauge) {
    return known ? tangent.rate(gauge) : std::numeric_limits<double>::quiet_NaN();
  };
  std::vector<double> out{rate(measures.load())};
  for (const std::size_t i : measures.displacements()) out.push_back(rate(measures.functionals()[i]));
  return out;
}

}  // namespace

TracePoint trace_point(const Walker& walker, const Measures& measures) {
  TracePoint out{.dissipated = walker.here().dissipated,
                 .load = walker.value(measures.load()),
                 .displacements = {},
                 .arriving = rates(walker.here().arriving, measures),
                 .leaving = rates(walker.leaving(), measures)};
  for (const std::size_t i : measures.displacements())
    out.displacements.push_back(walker.value(measures.functionals()[i]));
  return out;
}

}  // namespace dda
