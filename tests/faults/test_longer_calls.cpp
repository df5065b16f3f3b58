// clog run with a later time.end: what is there is lengthened, on any number of ranks, killed or
// not; what belongs to another scene is refused and stays as it is.
#include <gmock/gmock.h>

#include "dem/run/checkpoint.hpp"
#include "tests/faults/mpi_job.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class LongerCalls : public testing::Test {
protected:
  std::vector<std::string> words(const std::string& out, const std::string& seeds, const std::string& end) const {
    return {"run",   job_.path("scene.toml"), "--flow", job_.path("flow.h5"), "--out", job_.path(out), "--seeds", seeds,
            "--set", "time.end=" + end};
  }

  /// \return what was said
  std::string call(int status, const std::vector<std::string>& all) const {
    const Program program(all, job_.path("log"));
    EXPECT_EQ(program.wait(), status) << program.said();
    return program.said();
  }

  static std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  void expect_same(const std::string& a, const std::string& b, int seeds) const {
    for (int seed = 1; seed <= seeds; ++seed)
      EXPECT_TRUE(job_.result(a, seed) == job_.result(b, seed)) << "seed " << seed;
    for (const auto& entry : std::filesystem::directory_iterator(job_.path(a)))
      EXPECT_THAT(entry.path().extension().string(), testing::AnyOf(".h5", ".xmf", ".csv")) << entry.path();
    EXPECT_FALSE(std::filesystem::exists(job_.path(a) / "shorter_0001.h5"));
  }

  SmallJob job_;
};

TEST_F(LongerCalls, FinishedRunsBecomeThoseInOneGoOnAnyNumberOfRanks) {
  call(0, words("one_go", "1-4", "40 ms"));
  call(0, words("alone", "1-3", "12 ms"));
  const std::string said = call(0, words("alone", "1-4", "40 ms"));
  EXPECT_THAT(said, HasSubstr("seed 3: goes on from "));
  EXPECT_THAT(said, HasSubstr("shorter_0003.h5 at t = 0.0120"));
  expect_same("alone", "one_go", 4);
  call(0, words("ranks", "1-3", "12 ms"));
  MpiJob mpi({"-np", "3"}, words("ranks", "1-4", "40 ms"), job_.path("log_ranks"));
  EXPECT_EQ(mpi.wait(), 0) << mpi.said();
  expect_same("ranks", "one_go", 4);
  // Once there, the same call has nothing to do.
  EXPECT_THAT(call(0, words("alone", "1-4", "40 ms")),
              testing::AllOf(HasSubstr("seed 1: already done"), Not(HasSubstr("goes on"))));
}

TEST_F(LongerCalls, KilledOnTheWayTheyLoseNothing) {
  call(0, words("one_go", "1-2", "60 ms"));
  call(0, words("killed", "1-2", "10 ms"));
  int killed = 0;
  for (int k = 0; k < 40 && killed < 8; ++k) {
    const Program program(words("killed", "1-2", "60 ms"), job_.path("log"));
    sleep_ms(20 + 37 * (k % 8));
    program.send(SIGKILL);
    killed += program.wait() != 0;
    for (const std::uint64_t seed : {1, 2}) {
      const std::string name = run_file_name(seed);
      EXPECT_TRUE(std::filesystem::exists(job_.path("killed") / name) ||
                  std::filesystem::exists(job_.path("killed") / ("shorter" + name.substr(3))));
    }
  }
  EXPECT_GE(killed, 3);
  call(0, words("killed", "1-2", "60 ms"));
  expect_same("killed", "one_go", 2);
}

TEST_F(LongerCalls, AStoppedOneGoesOnWithAnotherEndOrAnotherIntervalOfStates) {
  const auto unfilled = [&](const std::string& out, const std::string& end) {
    return with(words(out, "1", end), {"--set", "inlet.start=empty"});
  };
  const Program stopped(unfilled("out", "2 s"), job_.path("log"));
  ASSERT_TRUE(appears(job_.path("out/run_0001.state.old")));
  stopped.send(SIGTERM);
  stopped.wait();
  const std::string state = text_of(job_.path("out/run_0001.state"));
  EXPECT_THAT(call(1, unfilled("out", "10 us")), HasSubstr("beyond time.end = 1e-05 s: raise time.end"));
  EXPECT_TRUE(text_of(job_.path("out/run_0001.state")) == state);
  Simulation at(small_channel({"time.end=2 s", "inlet.start=empty"}), &job_.flow, 1);
  at.resume(unpack_state(state).state);
  const std::string end = fmt::format("{} s", at.time() + 0.004);
  EXPECT_THAT(call(0, with(unfilled("out", end), {"--set", "output.checkpoint_interval=9 s"})),
              testing::ContainsRegex("seed 1: goes on from .*run_0001.state at t = "));
  call(0, with(unfilled("one_go", end), {"--set", "output.checkpoint_interval=9 s"}));
  expect_same("out", "one_go", 1);
}

TEST_F(LongerCalls, AnotherDiameterIsRefusedForAnySeedOfTheFolder) {
  call(0, words("out", "1", "4 ms"));
  const std::string before = text_of(job_.path("out/run_0001.h5"));
  for (const char* seeds : {"1", "2"})
    EXPECT_THAT(call(1, with(words("out", seeds, "4 ms"), {"--set", "particles.diameter=40 um"})),
                HasSubstr("run_0001.h5: was made for another scene (particles.diameter = \"50 um\", now "
                          "\"40 um\"): give another --out"));
  EXPECT_FALSE(std::filesystem::exists(job_.path("out/run_0002.h5")));
  EXPECT_TRUE(text_of(job_.path("out/run_0001.h5")) == before);
  EXPECT_THAT(call(0, words("out", "2", "5 ms")), HasSubstr("has another length (time.end = \"4 ms\", now \"5 ms\")"));
  EXPECT_THAT(call(0, with(words("out", "1", "4 ms"), {"--set", "output.snapshot_interval=1 ms"})),
              HasSubstr("seed 1: already done, with output.snapshot_interval = \"5 ms\", now \"1 ms\""));
}

TEST_F(LongerCalls, WhatWasSetAsideComesBackAndIsNeverLost) {
  call(0, words("out", "1", "6 ms"));
  const std::string result = job_.result("out", 1);
  const auto begin_longer = [&] {
    const Program program(words("out", "1", "2 s"), job_.path("log"));
    EXPECT_TRUE(appears(job_.path("out/run_0001.state.old")));
    program.send(SIGTERM);
    program.wait();
  };
  begin_longer();
  EXPECT_THAT(call(1, words("out", "1", "6 ms")),
              HasSubstr("shorter_0001.h5 is what is asked for, but run 1 is saved on its way to a "
                        "later time.end"));
  for (const char* name : {"out/run_0001.state", "out/run_0001.state.old"})
    EXPECT_TRUE(std::filesystem::remove(job_.path(name)));
  EXPECT_THAT(call(0, words("out", "1", "6 ms")), HasSubstr("seed 1: already done"));
  EXPECT_TRUE(job_.result("out", 1) == result);
  EXPECT_FALSE(std::filesystem::exists(job_.path("out/shorter_0001.h5")));
  // Given its place it can still be lengthened.
  call(0, words("out", "1", "9 ms"));
  call(0, words("one_go", "1", "9 ms"));
  expect_same("out", "one_go", 1);
}

TEST_F(LongerCalls, AFileThatHoldsNoStateOrAnotherBuildsStaysUnderItsName) {
  call(0, words("out", "1", "4 ms"));
  RunData run = read_run_file(job_.path("out/run_0001.h5"));
  write_run_file(run, job_.path("out/run_0001.h5"));
  EXPECT_THAT(call(1, words("out", "1", "6 ms")),
              HasSubstr("run_0001.h5: ends before time.end = 0.006 s and holds no state to go on from"));
  OwnedState other{{effective_scene(job_.scene), *run.record.inputs_hash, "another build", "avx2", 1}, "state"};
  other.owner.scene_text = run.scene_text;
  run.end_state = pack_state(other);
  write_run_file(run, job_.path("out/run_0001.h5"));
  EXPECT_THAT(call(1, words("out", "1", "6 ms")),
              HasSubstr("run_0001.h5: ends before time.end = 0.006 s and cannot go on: its state "
                        "was made by another build"));
  EXPECT_THAT(call(0, words("out", "1", "4 ms")), HasSubstr("already done"));
}

}  // namespace
}  // namespace clogflow::test
