#pragma once

#include <utility>
#include <vector>

#include "continuation/state/system.hpp"

namespace dda {

/// Lets a system stand on other histories, multipliers and frozen damage for a while: however the scope is
/// left, it stands afterwards as it did, its multipliers being those given.
class HistoryGuard {
 public:
  explicit HistoryGuard(System& system) : HistoryGuard(system, system.multipliers()) {}
  HistoryGuard(System& system, const std::vector<Vec2>& multipliers)
      : system_(system), history_(system.history()), multipliers_(multipliers), frozen_(system.frozen()) {}
  HistoryGuard(const HistoryGuard&) = delete;
  HistoryGuard& operator=(const HistoryGuard&) = delete;
  ~HistoryGuard() {
    system_.set_frozen(frozen_);
    system_.set_history(std::move(history_));
    system_.set_multipliers(multipliers_);
  }

 private:
  System& system_;
  std::vector<History> history_;
  std::vector<Vec2> multipliers_;
  bool frozen_;
};

}  // namespace dda
