#pragma once

#include <map>
#include <set>

#include "framework/base/errors.hpp"
#include "framework/deck/document/node.hpp"
#include "framework/deck/expression/expression.hpp"

namespace dda {

/// The `variables` of a deck: names with numbers, or with expressions of others, in any order.
///
/// What is wrong with a variable is told once, where it stands, whoever asks for it first.
class Variables {
 public:
  /// None: expressions of numbers and functions alone.
  Variables() = default;
  /// Of a map; anything else, and names that cannot stand in an expression, are findings. The findings must live on.
  Variables(const Node& section, Findings& findings);

  /// What is wrong with an expression, and where; nothing more is to be said where `is_told`.
  struct Failure {
    Position where;
    std::string what;
    bool is_told = false;
  };
  using Compiled = std::variant<std::shared_ptr<const Expression>, Failure>;

  /// Compiles a scalar; other arguments than these are variables, whose names may not be theirs.
  Compiled compile(const Node& node, const std::vector<std::string>& arguments = {});
  /// The text of a scalar with numbers in the place of variables: it says the same by itself.
  std::string resolved(const Node& node, const std::vector<std::string>& arguments);

  /// A variable's number; nothing where there is none or it is wrong. It counts as used.
  std::optional<double> value(const std::string& name);
  bool has(const std::string& name) const { return entries_.contains(name); }
  bool has_any() const { return !entries_.empty(); }
  /// Every variable that is right.
  std::map<std::string, double> values();
  /// A finding for each variable that nothing asked for, but for those named.
  void refuse_unused(const std::set<std::string>& excused, Findings& findings) const;

 private:
  enum class State { unread, being_read, right, wrong };
  struct Entry {
    Position where;
    Node node;
    State state = State::unread;
    double value = 0;
    bool is_used = false;
  };

  void read(const std::string& name, Entry& entry);
  void fail(Entry& entry, const Position& where, const std::string& what);
  Failure failure_of(const ExpressionFault& fault, const Node& node) const;
  std::string unknown(const ExpressionFault& fault) const;

  std::map<std::string, Entry> entries_;
  Findings* findings_ = nullptr;
  std::vector<std::string> reading_;  ///< which lead from one to the next
};

/// The place of a character of a scalar's text.
Position position_in(const Node& scalar, std::size_t at);

/// Every word of the scalars below a node that may be a name.
void collect_names(const Node& node, std::set<std::string>& out);

}  // namespace dda
