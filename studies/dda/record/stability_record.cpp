#include "studies/dda/record/stability_record.hpp"

#include <algorithm>
#include <cmath>

#include "studies/dda/record/column_names.hpp"

namespace dda {
namespace {

Stability stability(double dead, double held) {
  if (std::isnan(dead)) return Stability::unknown;
  if (dead == 0) return Stability::stable;
  if (std::isnan(held)) return Stability::unknown;
  return held == 0 ? Stability::under_control : Stability::unstable;
}

}  // namespace

std::vector<Stability> stability_of(const CsvTable& curve) {
  const std::size_t rows = curve.numbers(column::step).size();
  if (!curve.has(column::negative_eigenvalues)) return std::vector<Stability>(rows, Stability::unknown);
  const auto dead = curve.numbers(column::negative_eigenvalues),
             held = curve.numbers(column::negative_under_control);
  std::vector<Stability> out;
  for (std::size_t i = 0; i < rows; ++i) out.push_back(stability(dead[i], held[i]));
  return out;
}

std::vector<Stability> between(const std::vector<Stability>& rows) {
  std::vector<Stability> out;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const auto [better, worse] = std::minmax(rows[i], rows[i + 1]);
    out.push_back(worse == Stability::unknown ? worse : better);
  }
  return out;
}

nlohmann::ordered_json stability_counts(const CsvTable& curve) {
  const std::vector<Stability> rows = stability_of(curve);
  const auto count = [&](Stability kind) { return std::ranges::count(rows, kind); };
  nlohmann::ordered_json out{{"stable", count(Stability::stable)},
                             {"under_control", count(Stability::under_control)},
                             {"unstable", count(Stability::unstable)},
                             {"unknown", count(Stability::unknown)}};
  if (curve.has(column::negative_second_order_work))
    out["positive_second_order_work"] =
        std::ranges::count(curve.numbers(column::negative_second_order_work), 0.0);
  return out;
}

}  // namespace dda
