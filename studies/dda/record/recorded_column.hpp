#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "continuation/course/point.hpp"
#include "framework/files/curve_table.hpp"
#include "models/interface/law.hpp"
#include "studies/dda/case/deck/deck.hpp"
#include "studies/dda/record/column_names.hpp"

namespace dda {

struct Measurement;

/// An accepted step as the columns of curve.csv see it.
struct RecordedStep {
  const Point& point;
  const Measurement& now;
  const std::vector<History>& history;
  const std::set<EventKind>& events;
};

/// A column of curve.csv: its name, its unit ("" = none) and its cell of a step.
///
/// Its owner lists it and outlives it; what takes more than a look at the step, the owner finds out before cells are
/// asked for. One without `cell` is not written: it keeps gauges from names that begin with its own.
struct RecordedColumn : Column {
  std::function<TableCell(const RecordedStep&)> cell;

  bool takes(const std::string& other) const { return cell ? other == name : other.starts_with(name); }
};
using RecordedColumns = std::vector<RecordedColumn>;

}  // namespace dda
