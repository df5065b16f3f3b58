// clog run --time-limit: ends in time with every state saved, and the same call goes on.
#include <gmock/gmock.h>

#include "tests/faults/mpi_job.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

constexpr int seeds = 4;

TEST(TimeLimit, StopsAllRanksAndLosesNothing) {
  const SmallJob job(longer);
  const std::string all = fmt::format("1-{}", seeds);
  const auto before = std::chrono::steady_clock::now();
  ASSERT_EQ(job.complete("undisturbed", all), "");
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - before;
  const std::vector<std::string> words{"run",   job.path("scene.toml"), "--flow",  job.path("flow.h5"),
                                       "--out", job.path("out"),        "--seeds", all};
  auto limited = words;
  limited.insert(limited.end(), {"--time-limit", fmt::format("{} s", 0.25 * whole.count())});
  MpiJob mpi({"-np", "2"}, limited, job.path("log_out"));
  EXPECT_EQ(mpi.wait(), 0) << mpi.said();
  EXPECT_THAT(mpi.said(), HasSubstr("stopped; its state is saved, the same call goes on from there"));
  EXPECT_FALSE(std::filesystem::exists(job.path("out") / run_file_name(seeds)));
  ASSERT_EQ(job.complete("out", all), "");
  for (int seed = 1; seed <= seeds; ++seed) EXPECT_TRUE(job.result("out", seed) == job.result("undisturbed", seed));
}

class BadLimit : public testing::TestWithParam<const char*> {};

TEST_P(BadLimit, IsRefusedInOneLine) {
  const SmallJob job;
  const Program program = job.start("out", "1", {"--time-limit", GetParam()});
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr(GetParam()));
  EXPECT_EQ(std::ranges::count(program.said(), '\n'), 1) << program.said();
  EXPECT_FALSE(std::filesystem::exists(job.path("out")));
}

INSTANTIATE_TEST_SUITE_P(Values, BadLimit, testing::Values("0 s", "1e300 s", "-5 min", "5 m", "5", "soon"));

}  // namespace
}  // namespace clogflow::test
