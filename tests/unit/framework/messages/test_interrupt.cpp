#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "framework/messages/interrupt.hpp"

namespace dda {
namespace {

TEST(Interrupt, FirstSignalOnlySetsTheFlag) {
  const InterruptGuard guard;
  EXPECT_FALSE(interrupted());
  std::raise(SIGINT);
  EXPECT_TRUE(interrupted());
}

TEST(Interrupt, TerminationCountsToo) {
  const InterruptGuard guard;
  std::raise(SIGTERM);
  EXPECT_TRUE(interrupted());
}

/// What mpirun passes on, and batch queues send ahead of the end.
TEST(Interrupt, SignalsOfUsersCountToo) {
  for (const int signal : {SIGUSR1, SIGUSR2}) {
    const InterruptGuard guard;
    EXPECT_FALSE(interrupted());
    std::raise(signal);
    EXPECT_TRUE(interrupted());
  }
}

TEST(Interrupt, SecondSignalEndsTheProcessWith130) {
  EXPECT_EXIT(
      {
        const InterruptGuard guard;
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::ExitedWithCode(130), "");
}

TEST(Interrupt, TerminationMayComeMoreThanOnce) {
  const InterruptGuard guard;
  std::raise(SIGTERM);
  std::raise(SIGTERM);
  EXPECT_TRUE(interrupted());
  EXPECT_EXIT(std::raise(SIGINT), testing::ExitedWithCode(130), "");
}

TEST(Interrupt, HandlersOfBeforeComeBack) {
  { const InterruptGuard guard; }
  EXPECT_EXIT(std::raise(SIGINT), testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace dda
