// Damaged and foreign states: recognised, said, the one before used; never a wrong result.
#include <gmock/gmock.h>

#include "dem/run/checkpoint.hpp"
#include "tests/faults/program.hpp"

namespace clogflow::test {
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
    ASSERT_EQ(program.wait(), 128 + SIGTERM);
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

TEST_F(States, WholeOnesAreUsedInSilence) {
  EXPECT_THAT(resume(newest_, older_), Not(testing::AnyOf(HasSubstr("not used"), HasSubstr("anew"))));
}

TEST_F(States, CutShortAnywhereTheOneBeforeIsUsed) {
  for (const std::size_t length : {std::size_t{0}, std::size_t{40}, newest_.size() - 1}) {
    const std::string said = resume(newest_.substr(0, length), older_);
    EXPECT_THAT(said, HasSubstr("run_0001.state is not used: "));
    EXPECT_THAT(said, testing::AnyOf(HasSubstr("cut short"), HasSubstr("checksum")));
    EXPECT_THAT(said, HasSubstr("goes on from ")) << length;
    EXPECT_THAT(said, HasSubstr("run_0001.state.old "));
  }
}

TEST_F(States, AFlippedByteAnywhereIsNoticed) {
  for (const std::size_t at : {std::size_t{0}, std::size_t{20}, newest_.size() / 2})
    EXPECT_THAT(resume(flipped(newest_, at), older_),
                testing::AllOf(HasSubstr("run_0001.state is not used: "), HasSubstr("goes on from ")))
        << at;
}

TEST_F(States, BothBadTheRunStartsAnew) {
  const std::string said = resume(flipped(newest_, newest_.size() / 3), older_.substr(0, 100));
  EXPECT_THAT(said, HasSubstr("run_0001.state is not used: its checksum does not fit"));
  EXPECT_THAT(said, HasSubstr("run_0001.state.old is not used: its checksum does not fit"));
  EXPECT_THAT(said, HasSubstr("seed 1: no saved state is left to go on from, starts anew"));
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
      "(trap '' XFSZ; ulimit -f 4; exec {} run {} --flow {} --out {} --seeds 1) 2>&1 | cat > {}", CLOG_PROGRAM,
      job_->path("scene.toml").string(), job_->path("flow.h5").string(), folder.string(), job_->path("log").string());
  std::system(call.c_str());
  const std::string said = text_of(job_->path("log"));
  EXPECT_THAT(said, HasSubstr("the state could not be saved: "));
  EXPECT_THAT(said, HasSubstr("goes on from "));
  EXPECT_EQ(text_of(folder / "run_0001.state.old"), older_);
  // A disk that stays full is said once, not at every interval.
  EXPECT_EQ(said.find("could not be saved"), said.rfind("could not be saved"));
}

/// Started in a folder that holds this state: refused, and the state is as it was. \return what was said
std::string refused(const SmallJob& job, const std::string& folder, const std::string& name, const std::string& state,
                    const std::vector<std::string>& words) {
  const auto file = job.path(folder) / name;
  write_file(file, state);
  std::vector<std::string> all{"run", job.path("scene.toml"), "--out", job.path(folder)};
  all.insert(all.end(), words.begin(), words.end());
  const Program program(all, job.path("log"));
  EXPECT_EQ(program.wait(), 1);
  EXPECT_TRUE(text_of(file) == state) << folder;
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(file).replace_extension(".h5")));
  return program.said();
}

TEST_F(States, OfAnotherSceneSeedFlowOrBuildAreRefusedAndKept) {
  const std::string flow = job_->path("flow.h5");
  EXPECT_THAT(
      refused(*job_, "scene", "run_0001.state", newest_,
              {"--seeds", "1", "--flow", flow, "--set", "contact.friction.sliding=0.5"}),
      HasSubstr(
          "run_0001.state: was made for another scene (contact.friction.sliding = 0.6, now 0.5): give another --out"));
  EXPECT_THAT(refused(*job_, "seed", "run_0002.state", newest_, {"--flow", flow, "--seeds", "2"}),
              HasSubstr("run_0002.state belongs to seed 1: give another --out, or remove it"));
  // Solved again on another mesh: the same scene, other numbers.
  FlowGrid other = job_->flow;
  other.velocity[other.velocity.size() / 2] += 1e-6f;
  write_flow_grid(other, job_->path("other.h5"));
  EXPECT_THAT(refused(*job_, "flow", "run_0001.state", newest_, {"--seeds", "1", "--flow", job_->path("other.h5")}),
              HasSubstr("run_0001.state: was made with another flow, or other files of particles or walls"));
  OwnedState owned = unpack_state(newest_);
  owned.owner.build = "another build";
  EXPECT_THAT(refused(*job_, "build", "run_0001.state", pack_state(owned), {"--seeds", "1", "--flow", flow}),
              HasSubstr("run_0001.state was made by another build of the program (another build; this is "));
  owned = unpack_state(newest_);
  owned.owner.instruction_set = "mmx";
  EXPECT_THAT(refused(*job_, "set", "run_0001.state", pack_state(owned), {"--seeds", "1", "--flow", flow}),
              testing::AllOf(HasSubstr("was made with the instruction set mmx (here "), HasSubstr("set CLOG_ISA=mmx")));
  EXPECT_THAT(refused(*job_, "old", "run_0001.state", "clogflow state 2\n and so on", {"--seeds", "1", "--flow", flow}),
              HasSubstr("run_0001.state was made by another version of the program"));
}

TEST_F(States, AFinishedFileOfAnotherFlowIsNotTakenForThisOne) {
  FlowGrid other = job_->flow;
  other.velocity[other.velocity.size() / 2] += 1e-6f;
  write_flow_grid(other, job_->path("other.h5"));
  std::filesystem::create_directories(job_->path("done"));
  std::filesystem::copy_file(job_->path("undisturbed/run_0001.h5"), job_->path("done/run_0001.h5"));
  const Program done(
      {"run", job_->path("scene.toml"), "--flow", job_->path("other.h5"), "--out", job_->path("done"), "--seeds", "1"},
      job_->path("log"));
  EXPECT_EQ(done.wait(), 1);
  EXPECT_THAT(done.said(), HasSubstr("was made with another flow, or other files of particles or walls"));
}

/// The last word on the blow-up; what else is said, of the call before too, may differ from call to call.
std::string blow_up_in(const std::string& said) {
  const std::size_t from = said.rfind("blow-up at step ");
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
}  // namespace clogflow::test
