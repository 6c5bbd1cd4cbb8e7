#pragma once

#include <vector>

#include "continuation/linear/strips/strip_part.hpp"
#include "continuation/ranks/ranks.hpp"

namespace dda {

/// While it lives runs have so many ranks, all of them in this process.
class WithRanks {
 public:
  explicit WithRanks(std::size_t count) : ranks_(Ranks::here(answers(count))) { set_ranks_of_run(&ranks_); }
  ~WithRanks() { set_ranks_of_run(nullptr); }
  WithRanks(const WithRanks&) = delete;
  WithRanks& operator=(const WithRanks&) = delete;

  Ranks& ranks() { return ranks_; }

 private:
  static std::vector<Answer> answers(std::size_t count) {
    std::vector<Answer> out;
    for (std::size_t rank = 0; rank < count; ++rank) out.push_back(answer_by_parts());
    return out;
  }
  Ranks ranks_;
};

}  // namespace dda
