#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/deck/expression/expression.hpp"
#include "framework/deck/writing/node_json.hpp"
#include "studies/dda/case/deck.hpp"

namespace dda {

/// A column of sweep.csv that is computed of numbers of its row, an entry of `sweep.columns`:
///
///     nominal_strength: peak.load/(thickness*D)
///
/// Its names are, in this order: a varied key, or its end where no other shares it; a number of the deck by its dotted
/// path; a number of the case's summary (`numbers_of_summaries`).
struct DerivedColumn {
  std::string name;
  Position where;
  std::vector<std::string> names;  ///< of its numbers, arguments of the expression in this order
  std::shared_ptr<const Expression> expression;
};

/// Of the section `columns`; wrong expressions are findings.
std::vector<DerivedColumn> read_derived_columns(const Node& columns, Findings& findings);

/// What the deck of a case and its varied keys know of the column's numbers; nothing where its summary will. A name that
/// nothing knows is a finding.
std::vector<std::optional<double>> known_numbers(const DerivedColumn& column, const Node& effective_deck,
                                                 const std::vector<std::pair<std::string, Node>>& varied,
                                                 Findings& findings);

/// Its value in a row; nothing where a number is missing or the result is none.
std::optional<double> value_of(const DerivedColumn& column, std::vector<std::optional<double>> known,
                               const Json& summary);

}  // namespace dda
