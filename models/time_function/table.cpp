#include <algorithm>

#include "models/time_function/time_function.hpp"

namespace dda {
namespace {

struct TableParameters {
  std::vector<double> times, values;
  Position where;
};

/// Straight between the entries of a table, and constant behind the last.
class Table final : public TimeFunction {
 public:
  explicit Table(TableParameters p) : p_(std::move(p)) {}
  double at(double time) const override {
    const auto next = std::ranges::upper_bound(p_.times, time);
    if (next == p_.times.end()) return p_.values.back();
    const auto i = static_cast<std::size_t>(next - p_.times.begin());
    const double share = (time - p_.times[i - 1]) / (p_.times[i] - p_.times[i - 1]);
    return p_.values[i - 1] + share * (p_.values[i] - p_.values[i - 1]);
  }
  double next_kink(double after) const override {
    const auto next = std::ranges::upper_bound(p_.times, after);
    return next == p_.times.end() ? std::numeric_limits<double>::infinity() : *next;
  }

 private:
  TableParameters p_;
};

void check(const TableParameters& p, const Position& where, Findings& findings) {
  if (p.times.size() != p.values.size()) {
    findings.add(where, "`times` and `values` need as many entries as each other");
    return;
  }
  if (p.times.front() != 0 || p.values.front() != 0)
    findings.add(where, "a table begins with 0 at the time 0: the place where the motion begins");
  if (!std::ranges::is_sorted(p.times, std::ranges::less_equal())) findings.add(where, "`times` must grow");
}

Schema<TableParameters> schema() {
  using P = TableParameters;
  return Schema<P>("Displacements at some times, straight between them, constant behind the last.")
      .numbers("times", &P::times, {.at_least = 2, .text = "Times, the first 0, growing [s]."})
      .numbers("values", &P::values,
               {.dimension = dimension::length, .at_least = 2, .text = "Displacements, the first 0."})
      .check(check);
}

}  // namespace

DDA_REGISTER(time_functions(), "table", schema(), make_of<Table>);

}  // namespace dda
