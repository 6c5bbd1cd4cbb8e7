#include "framework/deck/changes/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "framework/deck/changes/range.hpp"

namespace dda {
namespace {

/// Reads the section entry by entry; what is wrong with one does not hide what is wrong with the next.
class AxesReader {
 public:
  std::vector<Axis> read(const Node& sweep) {
    if (!sweep.is_map()) throw InputError(sweep.where, "sweep: expected a map from keys to their values");
    for (const NodeEntry& entry : sweep.entries) {
      if (entry.key == "zip")
        read_zips(entry.value);
      else
        add({{read_key(entry)}});
    }
    check_names();
    findings_.throw_if_any();
    check_count(sweep.where);
    return std::move(axes_);
  }

 private:
  SweptKey read_key(const NodeEntry& entry) {
    SweptKey key{entry.key, entry.where, {}};
    const Node& node = entry.value;
    try {
      if (node.is_sequence())
        key.values = node.items;
      else if (is_range(node))
        key.values = read_range(node, max_cases);
      else
        throw InputError(node.where, fmt::format("{}: expected a list of values, such as [1, 2], or a range, "
                                                 "such as 1..20",
                                                 entry.key));
      if (key.values.empty()) throw InputError(node.where, entry.key + ": the list is empty");
    } catch (const InputError& error) {
      findings_.add(error);
    }
    return key;
  }

  void read_zips(const Node& node) {
    if (!node.is_sequence()) return read_zip(node);
    for (const Node& item : node.items) read_zip(item);
  }

  void read_zip(const Node& node) {
    if (!node.is_map() || node.entries.empty()) {
      findings_.add(node.where,
                    "zip: expected a map from keys to lists of equal length, or a list of such maps");
      return;
    }
    Axis axis;
    for (const NodeEntry& entry : node.entries) axis.keys.push_back(read_key(entry));
    const SweptKey& first = axis.keys.front();
    for (const SweptKey& key : axis.keys)
      if (!key.values.empty() && !first.values.empty() && key.values.size() != first.values.size())
        findings_.add(key.where, fmt::format("zip: '{}' has {} values, '{}' has {}; they must be as many",
                                             key.name, key.values.size(), first.name, first.values.size()));
    add(std::move(axis));
  }

  void add(Axis axis) { axes_.push_back(std::move(axis)); }

  void check_names() {
    std::map<std::string, Position> seen;
    for (const Axis& axis : axes_)
      for (const SweptKey& key : axis.keys)
        if (const auto [first, is_new] = seen.emplace(key.name, key.where); !is_new)
          findings_.add(key.where,
                        fmt::format("'{}' is varied twice, first at {}", key.name, to_string(first->second)));
  }

  void check_count(const Position& where) const {
    if (axes_.empty()) throw InputError(where, "sweep: nothing is varied; give a key and its values");
    double count = 1;
    for (const Axis& axis : axes_) count *= static_cast<double>(axis.size());
    if (count > static_cast<double>(max_cases))
      throw InputError(where, fmt::format("sweep: {:.6g} cases; at most {} are run", count, max_cases));
  }

  std::vector<Axis> axes_;
  Findings findings_;
};

}  // namespace

std::vector<Axis> read_axes(const Node& sweep) { return AxesReader().read(sweep); }

std::vector<std::vector<std::size_t>> cases_of(const std::vector<Axis>& axes) {
  std::vector<std::vector<std::size_t>> cases(1);
  for (const Axis& axis : axes) {
    std::vector<std::vector<std::size_t>> longer;
    for (const auto& before : cases)
      for (std::size_t i = 0; i < axis.size(); ++i) {
        longer.push_back(before);
        longer.back().push_back(i);
      }
    cases = std::move(longer);
  }
  return cases;
}

}  // namespace dda
