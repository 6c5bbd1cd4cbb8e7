#include <gmock/gmock.h>

#include "studies/dda/sweep/launch/launcher.hpp"
#include "unit/studies/dda/sweep/sweep_example.hpp"

namespace dda {
namespace {

using test::SweepExample;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class LaunchedSweep : public testing::Test {
 protected:
  SweepExample example_{"sweep: {deck: a.yaml, thickness: [1, 2, 3, 4, 5]}\n"};
  Sweep sweep_ = example_.read();
  std::vector<CaseState> states_{sweep_.cases.size()};

  void finish(std::size_t index, double seconds, double mib) {
    states_[index].status = CaseStatus::goal_reached;
    states_[index].summary = {{"peak_memory_mib", mib}, {"timings", {{"total", seconds}}}};
  }
};

TEST_F(LaunchedSweep, MemoryIsPredictedAndTimeIsNotKnown) {
  const Forecast forecast = forecast_of(sweep_, states_);
  EXPECT_EQ(forecast.num_open, 5u);
  EXPECT_GT(forecast.least_memory, 0);
  EXPECT_GT(forecast.memory_to_ask(), forecast.least_memory);
  EXPECT_EQ(forecast.time_to_ask(2), 0);
  const std::string script = slurm_script(sweep_, "out/it's", forecast, {.tasks = 5});
  EXPECT_THAT(script, AllOf(HasSubstr("# out/it's: 5 of 5 cases are to be run, by 5 processes"),
                            HasSubstr("# time: unknown, no case has finished\n"),
                            HasSubstr("#SBATCH --array=1-5\n"), HasSubstr("#SBATCH --mem="),
                            Not(HasSubstr("#SBATCH --time")), HasSubstr("--folder 'out/it'\\''s'"),
                            EndsWith(" --jobs 1 --no-wait --attempt \"$SLURM_ARRAY_JOB_ID\"\n")));
}

TEST_F(LaunchedSweep, FinishedCasesTellMemoryAndTime) {
  finish(0, 4000, 10000);
  finish(3, 500, 200);
  const Forecast forecast = forecast_of(sweep_, states_);
  EXPECT_EQ(forecast.num_open, 3u);
  EXPECT_EQ(forecast.peak_memory, 10000);
  EXPECT_EQ(forecast.memory_to_ask(), 12564) << "a quarter more, and the sweep itself";
  EXPECT_EQ(forecast.time_to_ask(1), 8000);
  const std::string script = slurm_script(sweep_, "out", forecast, {.tasks = 2});
  EXPECT_THAT(script, AllOf(HasSubstr("the longest of 2 finished cases took 1:06:40"),
                            HasSubstr("#SBATCH --time=267\n"), HasSubstr("#SBATCH --mem=12564M\n")));
}

TEST_F(LaunchedSweep, ProcessesAreSharedOutAmongHosts) {
  const Forecast forecast{.num_cases = 5, .num_open = 5};
  EXPECT_THAT(parallel_line(sweep_, "out", forecast, {.tasks = 5, .hosts = {"a", "b"}}),
              AllOf(HasSubstr(" | head -n 6 | parallel --jobs 3 --sshlogin a,b --workdir "),
                    HasSubstr("--no-wait --attempt '\"$(date +%s)\"")));
  EXPECT_THAT(parallel_line(sweep_, "out", forecast, {.tasks = 5}),
              EndsWith(" | head -n 5 | parallel --jobs 5\n"));
  EXPECT_THAT(mpirun_line(sweep_, "out", forecast, {.tasks = 5}),
              AllOf(HasSubstr(" mpirun -n 5 "), Not(HasSubstr("--no-wait"))));
}

TEST_F(LaunchedSweep, ACaseThatCannotBeMeshedIsToldOf) {
  SweepExample example("sweep: {deck: a.yaml, supports.left.at: [[0, 0], [-9, 0]]}\n");
  const Sweep sweep = example.read();
  testing::internal::CaptureStderr();
  const Forecast forecast = forecast_of(sweep, std::vector<CaseState>(2));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("case 002 will fail: "));
  EXPECT_THAT(forecast.memory_text, HasSubstr("case 001 takes at least"));
}

}  // namespace
}  // namespace dda
