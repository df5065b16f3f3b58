// Damaged and foreign states: recognised, said, the one before used; never a wrong result.
#include <gmock/gmock.h>

#include "tests/faults/program.hpp"

namespace clog::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// One job stopped in the middle, with two states, and the result it must come to.
class States : public testing::Test {
protected:
  static void SetUpTestSuite() {
    job_ = new SmallJob(longer);
    const Program program = job_->start("stopped", "1");
    ASSERT_TRUE(appears(job_->path("stopped/run_0001.state.old")));
    program.send(SIGTERM);
    ASSERT_EQ(program.wait(), 0);
    newest_ = text_of(job_->path("stopped/run_0001.state"));
    older_ = text_of(job_->path("stopped/run_0001.state.old"));
    ASSERT_NE(newest_, older_);
    ASSERT_EQ(job_->complete("undisturbed", "1"), "");
  }
  static void TearDownTestSuite() { delete job_; }

  /// Resumes from these two files, and expects the undisturbed result. \return what was said
  static std::string resume(const std::string& newest, const std::string& older) {
    const auto folder = job_->path("again");
    std::filesystem::remove_all(folder);
    write_file(folder / "run_0001.state", newest);
    write_file(folder / "run_0001.state.old", older);
    const Program program = job_->start("again", "1");
    EXPECT_EQ(program.wait(), 0);
    EXPECT_TRUE(job_->result("again", 1) == job_->result("undisturbed", 1)) << program.said();
    return program.said();
  }

  static std::string flipped(std::string bytes, std::size_t at) {
    bytes[at] = static_cast<char>(bytes[at] ^ 16);
    return bytes;
  }

  inline static SmallJob* job_;
  inline static std::string newest_, older_;
};

TEST_F(States, WholeOnesAreUsedInSilence) { EXPECT_THAT(resume(newest_, older_), Not(testing::AnyOf(HasSubstr("not used"), HasSubstr("anew")))); }

TEST_F(States, CutShortAnywhereTheOneBeforeIsUsed) {
  for (const std::size_t length : {std::size_t{0}, std::size_t{40}, newest_.size() - 1}) {
    const std::string said = resume(newest_.substr(0, length), older_);
    EXPECT_THAT(said, HasSubstr("run_0001.state is not used: "));
    EXPECT_THAT(said, testing::AnyOf(HasSubstr("cut short"), HasSubstr("checksum")));
    EXPECT_THAT(said, HasSubstr("goes on from ")) << length;
    EXPECT_THAT(said, HasSubstr("run_0001.state.old\n"));
  }
}

TEST_F(States, AFlippedByteAnywhereIsNoticed) {
  for (const std::size_t at : {std::size_t{0}, std::size_t{20}, newest_.size() / 2})
    EXPECT_THAT(resume(flipped(newest_, at), older_),
                testing::AllOf(HasSubstr("run_0001.state is not used: "), HasSubstr("goes on from "))) << at;
}

TEST_F(States, BothBadTheRunStartsAnew) {
  const std::string said = resume(flipped(newest_, newest_.size() / 3), older_.substr(0, 100));
  EXPECT_THAT(said, HasSubstr("run_0001.state is not used: its checksum does not fit"));
  EXPECT_THAT(said, HasSubstr("run_0001.state.old is not used: its checksum does not fit"));
  EXPECT_THAT(said, HasSubstr("seed 1: starts anew"));
}

TEST_F(States, AFolderInThePlaceOfAState) {
  const auto folder = job_->path("odd");
  write_file(folder / "run_0001.state.old", older_);
  std::filesystem::create_directories(folder / "run_0001.state");
  const Program program = job_->start("odd", "1");
  EXPECT_EQ(program.wait(), 0);
  EXPECT_THAT(program.said(), HasSubstr("run_0001.state is not used"));
  EXPECT_TRUE(job_->result("odd", 1) == job_->result("undisturbed", 1));
}

// The damaged newest must not push the good older one out before a new one is whole.
TEST_F(States, ABadNewestNeverReplacesTheGoodOlder) {
  const auto folder = job_->path("pushed");
  write_file(folder / "run_0001.state", newest_.substr(0, 300));
  write_file(folder / "run_0001.state.old", older_);
  // Room for 4 kB a file: no new state can be written, nor the result.
  const std::string call = fmt::format(
      "(trap '' XFSZ; ulimit -f 4; exec {} run {} --flow {} --out {} --seeds 1) 2>&1 | cat > {}",
      CLOG_PROGRAM, job_->path("scene.toml").string(), job_->path("flow.h5").string(),
      folder.string(), job_->path("log").string());
  std::system(call.c_str());
  const std::string said = text_of(job_->path("log"));
  EXPECT_THAT(said, HasSubstr("the state could not be saved: "));
  EXPECT_THAT(said, HasSubstr("goes on from "));
  EXPECT_EQ(text_of(folder / "run_0001.state.old"), older_);
  // A disk that stays full is said once, not at every interval.
  EXPECT_EQ(said.find("could not be saved"), said.rfind("could not be saved"));
}

TEST_F(States, OfAnotherSceneSeedOrFlowIsNotUsed) {
  const auto put = [&](const std::string& folder, const std::string& name) {
    write_file(job_->path(folder) / name, newest_);
  };
  put("scene", "run_0001.state");
  const Program scene = job_->start("scene", "1", {"--set", "contact.friction.sliding=0.5"});
  EXPECT_EQ(scene.wait(), 0);
  EXPECT_THAT(scene.said(), HasSubstr("it belongs to another scene, flow, program or kind of processor"));
  put("seed", "run_0002.state");
  const Program seed = job_->start("seed", "2");
  EXPECT_EQ(seed.wait(), 0);
  EXPECT_THAT(seed.said(), HasSubstr("it belongs to another scene"));
  // Solved again on another mesh: the same scene, other numbers.
  put("flow", "run_0001.state");
  FlowGrid other = job_->flow;
  other.velocity[other.velocity.size() / 2] += 1e-6f;
  write_flow_grid(other, job_->path("other.h5"));
  const std::vector<std::string> words{"run", job_->path("scene.toml"), "--flow", job_->path("other.h5"),
                                       "--out", job_->path("flow"), "--seeds", "1"};
  const Program flow(words, job_->path("log"));
  EXPECT_EQ(flow.wait(), 0);
  EXPECT_THAT(flow.said(), HasSubstr("it belongs to another scene"));
  // Nor is a finished file of it taken for this one.
  const Program done = job_->start("flow", "1");
  EXPECT_EQ(done.wait(), 1);
  EXPECT_THAT(done.said(), HasSubstr("was made with another flow, or other files of particles or walls"));
}

/// The line of the blow-up; what else is said may differ from call to call.
std::string blow_up_in(const std::string& said) {
  const std::size_t from = said.find("blow-up at step ");
  return from == std::string::npos ? "" : said.substr(from, said.find('\n', from) - from);
}

TEST(BlowUp, KeepsTheStateBeforeAndHappensAgainInTheSameStep) {
  // 82.5 m/s are half a radius in a step; 400 m/s2 get there in two million steps.
  const ScratchFolder folder;
  Scene scene = laboratory_scene({3e6, 0.35, 1062, 33e-6}, 1e-7);
  scene.particles.initial = folder.path() / "sphere.csv";
  scene.body_force = {400 * 1062 * M_PI / 6 * std::pow(33e-6, 3), 0, 0};
  scene.output.checkpoint_interval = 0.02;
  write_file(scene.particles.initial, "x,y,z,radius,vx,vy,vz,wx,wy,wz\n0,0,0,16.5e-6,0,0,0,0,0,0\n");
  write_file(folder.path() / "scene.toml", effective_scene(scene));
  const auto run = [&] {
    const Program program({"run", folder.path() / "scene.toml", "--out", folder.path() / "out"}, folder.path() / "log");
    EXPECT_EQ(program.wait(), 1);
    return blow_up_in(program.said());
  };
  const std::string first = run();
  EXPECT_THAT(first, testing::AllOf(HasSubstr("blow-up at step 20625"), HasSubstr("thrown: particle 0 at (8.5"),
                                    HasSubstr("lower time.step or ")));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/run_0001.state"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/run_0001.h5"));
  EXPECT_EQ(run(), first);
}

}  // namespace
}  // namespace clog::test
