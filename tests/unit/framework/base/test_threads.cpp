#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "framework/base/threads.hpp"

namespace dda {
namespace {

/// With a number of threads of its own.
class Threads : public testing::TestWithParam<int> {
 protected:
  Threads() : before_(num_threads()) { set_num_threads(GetParam()); }
  ~Threads() override { set_num_threads(before_); }

 private:
  int before_;
};

INSTANTIATE_TEST_SUITE_P(Numbers, Threads, testing::Values(1, 2, 3, 4));

TEST_P(Threads, EveryIndexIsTakenOnce) {
  for (const std::size_t count : {0u, 1u, 6u, 7u, 8u, 1000u})
    for (const std::size_t grain : {1u, 7u, 1000u}) {
      std::vector<std::atomic<int>> taken(count);
      parallel_for(count, grain, [&](std::size_t i) { ++taken[i]; });
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(taken[i], 1) << i << " of " << count;
    }
}

TEST_P(Threads, PiecesAreThoseOfTheGrain) {
  std::mutex mutex;
  std::set<std::pair<std::size_t, std::size_t>> pieces;
  parallel_pieces(10, 4, [&](std::size_t begin, std::size_t end) {
    const std::lock_guard lock(mutex);
    pieces.emplace(begin, end);
  });
  EXPECT_EQ(pieces, (std::set<std::pair<std::size_t, std::size_t>>{{0, 4}, {4, 8}, {8, 10}}));
}

TEST_P(Threads, SumsRepeatBitForBit) {
  const auto term = [](std::size_t i) { return std::sin(static_cast<double>(i)); };
  double expected = 0;
  for (std::size_t begin = 0; begin < 10000; begin += 64) {
    double piece = 0;
    for (std::size_t i = begin; i < std::min<std::size_t>(begin + 64, 10000); ++i) piece += term(i);
    expected += piece;
  }
  for (int repeat = 0; repeat < 20; ++repeat) EXPECT_EQ(parallel_sum(10000, 64, term), expected);
  EXPECT_EQ(parallel_sum(0, 64, term), 0);
}

TEST_P(Threads, TheFirstExceptionReachesTheCaller) {
  for (int repeat = 0; repeat < 20; ++repeat) try {
      parallel_for(100, 1, [](std::size_t i) {
        if (i >= 7) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "7");
    }
  std::atomic<int> done = 0;
  parallel_for(100, 1, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 100) << "after an exception";
}

TEST_P(Threads, ALoopInsideAnotherStaysOnItsThread) {
  std::atomic<int> strangers = 0;
  parallel_for(8, 1, [&](std::size_t) {
    const auto outer = std::this_thread::get_id();
    parallel_for(8, 1, [&](std::size_t) { strangers += std::this_thread::get_id() != outer; });
  });
  EXPECT_EQ(strangers, 0);
}

TEST_P(Threads, OnePieceStaysOnTheCallingThread) {
  std::thread::id seen;
  parallel_for(5, 5, [&](std::size_t) { seen = std::this_thread::get_id(); });
  EXPECT_EQ(seen, std::this_thread::get_id());
}

TEST_P(Threads, AsManyAsWereAskedForWorkAtOnce) {
  const auto wanted = static_cast<std::size_t>(GetParam());
  std::mutex mutex;
  std::condition_variable all_here;
  std::size_t here = 0;
  parallel_for(wanted, 1, [&](std::size_t) {  // no piece ends before each has begun
    std::unique_lock lock(mutex);
    ++here;
    all_here.notify_all();
    all_here.wait(lock, [&] { return here == wanted; });
  });
  EXPECT_EQ(here, wanted);
}

TEST(NumThreads, IsAtLeastOne) {
  EXPECT_GE(num_threads(), 1);
  EXPECT_THROW(set_num_threads(0), std::invalid_argument);
}

}  // namespace
}  // namespace dda
