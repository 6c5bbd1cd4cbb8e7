#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "continuation/state/least_memory.hpp"
#include "framework/base/memory.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

/// A limit of the memory, none after it.
struct Limited {
  explicit Limited(double bytes) { set_memory_limit(bytes); }
  Limited(const Limited&) = delete;
  Limited& operator=(const Limited&) = delete;
  ~Limited() { set_memory_limit(std::numeric_limits<double>::infinity()); }
};

TEST(LeastMemory, CountsFactorAndVectors) {
  const Structure structure(square_deck());
  const Equilibrium equilibrium = structure.equilibrium();
  const auto solver = direct_solvers().choose("cholmod").make();
  const LeastMemory least = least_memory(equilibrium, *solver);
  EXPECT_EQ(least.factor, solver->factor_bytes(equilibrium.intact()));
  EXPECT_GT(least.vectors, 8.0 * static_cast<double>(equilibrium.num_unknowns()));
}

TEST(LeastMemory, MoreThanThereIsIsRefused) {
  const Structure structure(square_deck());
  const Equilibrium equilibrium = structure.equilibrium();
  const auto choice = direct_solvers().choose("cholmod");
  EXPECT_NE(affordable_solver(equilibrium, choice), nullptr);
  const Limited limited(1000);
  EXPECT_THROW(affordable_solver(equilibrium, choice), InputError);
}

TEST(HeldMemory, GrowsWithWhatIsAllocated) {
  const double before = held_memory();
  const std::vector<char> large(200u << 20, 'x');
#ifndef __SANITIZE_ADDRESS__  // whose allocator is another one
  EXPECT_GE(held_memory(), before + 200.0 * (1u << 20));
#endif
  EXPECT_EQ(large.back(), 'x');
}

}  // namespace
}  // namespace dda
