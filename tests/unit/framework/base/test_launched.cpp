#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "framework/base/launched.hpp"

namespace dda {
namespace {

/// Launchers' variables as a test wants them, and as they were at its end.
class Environment {
 public:
  explicit Environment(const std::vector<std::pair<std::string, std::string>>& wanted) {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_LOCAL_SIZE",
                             "SLURM_STEP_NUM_TASKS", "SLURM_PROCID", "SLURM_STEP_TASKS_PER_NODE", "PMI_SIZE",
                             "PMI_RANK", "MPI_LOCALNRANKS"}) {
      if (const char* value = std::getenv(name)) before_.emplace_back(name, value);
      unsetenv(name);
    }
    for (const auto& [name, value] : wanted) set(name, value);
  }
  ~Environment() {
    for (const std::string& name : set_) unsetenv(name.c_str());
    for (const auto& [name, value] : before_) setenv(name.c_str(), value.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  void set(const std::string& name, const std::string& value) {
    setenv(name.c_str(), value.c_str(), 1);
    set_.push_back(name);
  }
  std::vector<std::pair<std::string, std::string>> before_;
  std::vector<std::string> set_;
};

TEST(Launched, OneProcessWithoutALauncher) {
  const Environment none({});
  EXPECT_EQ(launched().size, 1);
  EXPECT_EQ(launched().rank, 0);
  EXPECT_EQ(launched().size_here, 1);
}

TEST(Launched, ByMpirun) {
  const Environment by(
      {{"OMPI_COMM_WORLD_SIZE", "8"}, {"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_LOCAL_SIZE", "4"}});
  EXPECT_EQ(launched().size, 8);
  EXPECT_EQ(launched().rank, 3);
  EXPECT_EQ(launched().size_here, 4);
}

TEST(Launched, BySrun) {
  const Environment by(
      {{"SLURM_STEP_NUM_TASKS", "6"}, {"SLURM_PROCID", "5"}, {"SLURM_STEP_TASKS_PER_NODE", "2(x3)"}});
  EXPECT_EQ(launched().size, 6);
  EXPECT_EQ(launched().rank, 5);
  EXPECT_EQ(launched().size_here, 2);
}

TEST(Launched, WhatIsNoNumberIsNoLauncher) {
  const Environment by({{"OMPI_COMM_WORLD_SIZE", "many"}, {"OMPI_COMM_WORLD_RANK", "0"}});
  EXPECT_EQ(launched().size, 1);
  const Environment beyond({{"OMPI_COMM_WORLD_SIZE", "2"}, {"OMPI_COMM_WORLD_RANK", "2"}});
  EXPECT_EQ(launched().size, 1);
}

}  // namespace
}  // namespace dda
