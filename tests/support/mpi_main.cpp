#include <gtest/gtest.h>

#include "continuation/mpi_session.hpp"

/// For test programs that use Trilinos or MUMPS: as gtest_main, inside an MPI session.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const dda::MpiSession session;
  return RUN_ALL_TESTS();
}
