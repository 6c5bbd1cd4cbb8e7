#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/deck/expression/expression.hpp"
#include "framework/deck/writing/node_json.hpp"
#include "studies/dda/case/deck/deck.hpp"

namespace dda {

/// A column of sweep.csv that is computed of numbers of its row, an entry of `sweep.columns`:
///
///     nominal_strength: peak.load/(thickness*D)
///
/// Its names are, in this order: a varied key, or its end where no other shares it; a variable of the deck; a number of
/// the deck by its dotted path; a column that stands before it; a number of the case's summary (`numbers_of_summaries`).
struct DerivedColumn {
  std::string name;
  Position where;
  std::vector<std::string> names;  ///< of its numbers, arguments of the expression in this order
  std::shared_ptr<const Expression> expression;
};

/// Names that sweep.csv has itself in every sweep.
std::vector<std::string> reserved_columns();

/// Of the section `columns`; wrong expressions are findings.
std::vector<DerivedColumn> read_derived_columns(const Node& columns, Findings& findings);

/// Where the numbers of a case come from, beside its summary.
struct CaseNumbers {
  const Node& effective_deck;
  std::vector<std::pair<std::string, Node>> varied;
  std::map<std::string, double> variables;
};

/// What a case knows of the numbers of each column; nothing where a column before or the summary will. A name that
/// nothing knows is a finding.
std::vector<std::vector<std::optional<double>>> known_numbers(const std::vector<DerivedColumn>& columns,
                                                              const CaseNumbers& numbers, Findings& findings);

/// Their values in a row; nothing where a number is missing or the result is none.
std::vector<std::optional<double>> values_of(const std::vector<DerivedColumn>& columns,
                                             const std::vector<std::vector<std::optional<double>>>& known,
                                             const Json& summary);

}  // namespace dda
