#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>
#include <vector>

#include "framework/base/errors.hpp"
#include "framework/files/claims.hpp"
#include "framework/files/whole_file.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;
using test::put;
using test::Scratch;
using testing::HasSubstr;

constexpr double long_lease = 1e6;

/// A claim as a process of another machine writes it.
std::string foreign(std::uint64_t beats, double lease) {
  return fmt::format(
      R"({{"beats": {:>20}, "pid": 1, "start": 1, "host": "far", "machine": "far away", "lease": {}, "note": {{}}}})"
      "\n",
      beats, lease);
}

class ClaimsOnNames : public testing::Test {
 protected:
  Scratch scratch_;
  Claims claims_{scratch_.path(), long_lease};

  Holder holder() { return claims_.look().at("a").holder; }
};

TEST_F(ClaimsOnNames, AreHeldUntilTheyEnd) {
  auto claim = claims_.take("a", {{"since", "noon"}});
  ASSERT_TRUE(claim);
  Claims others(scratch_.path(), long_lease);
  EXPECT_EQ(others.look().at("a").holder, Holder::alive);
  EXPECT_EQ(others.seen().at("a").note["since"], "noon");
  EXPECT_EQ(others.seen().at("a").owner.number, getpid());
  EXPECT_FALSE(others.take("a", {}));
  EXPECT_TRUE(others.take("b", {}));
  claims_.end(*claim, {{"status", "done"}});
  EXPECT_EQ(others.look().at("a").holder, Holder::ended);
  EXPECT_EQ(others.seen().at("a").outcome["status"], "done");
  EXPECT_EQ(others.take("a", {})->generation, 2);
}

TEST_F(ClaimsOnNames, OneOfManyGetsEach) {
  constexpr int processes = 8, names = 50;
  std::atomic<int> taken{0};
  std::vector<std::thread> all;
  for (int p = 0; p < processes; ++p)
    all.emplace_back([&] {
      Claims claims(scratch_.path(), long_lease);
      for (int n = 0; n < names; ++n) taken += claims.take(std::to_string(n), {}).has_value();
    });
  for (std::thread& one : all) one.join();
  EXPECT_EQ(taken, names);
}

TEST_F(ClaimsOnNames, OfADeadProcessAreFreeAtOnce) {
  auto claim = claims_.take("a", {});
  const pid_t child = fork();
  if (child == 0) pause();
  claims_.hand_over(*claim, child);
  EXPECT_EQ(holder(), Holder::alive);
  EXPECT_EQ(claims_.seen().at("a").owner.number, child);
  kill(child, SIGKILL);
  siginfo_t info;
  waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT);
  EXPECT_EQ(holder(), Holder::dead) << "a zombie is dead";
  waitpid(child, nullptr, 0);
  EXPECT_EQ(holder(), Holder::dead);
  EXPECT_EQ(claims_.take("a", {})->generation, 2);
}

TEST_F(ClaimsOnNames, OfANumberThatCameAgainAreFree) {
  const auto claim = claims_.take("a", {});
  const ClaimFiles files = claims_.files_of(*claim);
  std::string text = read_whole(files.own);
  const std::string start = std::to_string(claim->owner.start),
                    later = std::to_string(claim->owner.start + 1);
  const auto place = text.find(start, text.find("\"start\""));
  ASSERT_NE(place, std::string::npos);
  put(files.own, text.replace(place, start.size(), later));
  EXPECT_EQ(holder(), Holder::dead);
}

TEST_F(ClaimsOnNames, OfAnotherMachineAreJudgedByTheirBeats) {
  put(scratch_ / "a.1", foreign(7, 0));
  EXPECT_EQ(holder(), Holder::silent);
  EXPECT_FALSE(claims_.take("a", {}));
  put(scratch_ / "a.1", foreign(8, long_lease));
  EXPECT_EQ(holder(), Holder::alive);
  put(scratch_ / "a.1", foreign(8, 0));
  EXPECT_EQ(holder(), Holder::dead);
  fs::last_write_time(scratch_ / "a.1", fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_EQ(holder(), Holder::dead) << "times of files say nothing";
  put(scratch_ / "a.1", foreign(9, 0));
  EXPECT_EQ(holder(), Holder::alive) << "it was only slow";
}

TEST_F(ClaimsOnNames, ThatAreNotWholeWaitForTheirLease) {
  put(scratch_ / "a.1", "");
  EXPECT_EQ(holder(), Holder::silent);
  EXPECT_FALSE(claims_.take("a", {}));
  put(scratch_ / "a.1", R"({"beats": )");
  EXPECT_EQ(holder(), Holder::silent);
  Claims impatient(scratch_.path(), 0);
  impatient.look();
  EXPECT_EQ(impatient.look().at("a").holder, Holder::dead);
}

TEST_F(ClaimsOnNames, BeatUntilAnotherOneTakesOver) {
  const auto claim = claims_.take("a", {});
  const ClaimFiles files = claims_.files_of(*claim);
  EXPECT_TRUE(beat(files, 12345678901234567890U));
  EXPECT_EQ(claims_.look().at("a").beats, 12345678901234567890U);
  EXPECT_EQ(claims_.seen().at("a").owner.number, getpid());
  put(files.next, "");
  EXPECT_FALSE(beat(files, 3));
}

TEST_F(ClaimsOnNames, KeepWhatIsNoClaimOut) {
  put(scratch_ / "a.1.part", "");
  put(scratch_ / "a.x", "");
  put(scratch_ / "notes", "");
  put(scratch_ / "a.0", "");
  EXPECT_TRUE(claims_.look().empty());
}

TEST_F(ClaimsOnNames, LeaveNothingOnAFullDisk) {
  const test::FileSizeLimit limit(0);
  const std::string message = test::message_of<OutputError>([&] { claims_.take("a", {}); });
  EXPECT_THAT(message, HasSubstr("a.1"));
  EXPECT_TRUE(fs::is_empty(scratch_.path()));
}

TEST_F(ClaimsOnNames, SayWhatHappenedToTheFolder) {
  Claims claims(scratch_ / "gone", long_lease);
  EXPECT_THAT(test::message_of<OutputError>([&] { claims.take("a", {}); }),
              HasSubstr("another process has begun anew there"));
}

}  // namespace
}  // namespace dda
