// Disks that are full or closed, files that vanish: one line, status 1, and what was done stays done.
#include <sys/mount.h>
#include <sys/stat.h>

#include <gmock/gmock.h>

#include "tests/coupling/refusal.hpp"
#include "tests/faults/program.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;
using testing::Not;

int lines(const std::string& text) { return static_cast<int>(std::ranges::count(text, '\n')); }

/// A call of the program by a shell that first limits it.
struct Limited {
  int status;
  std::string said;
};

Limited limited(const SmallJob& job, const std::string& before, const std::string& out, const std::string& more = "") {
  const std::string call = fmt::format("{} run {} --flow {} --out {} {}", CLOG_PROGRAM, job.path("scene.toml").string(),
                                       job.path("flow.h5").string(), job.path(out).string(), more);
  const int status =
      std::system(fmt::format("({}; exec {}) > {} 2>&1", before, call, job.path("log").string()).c_str());
  return {WEXITSTATUS(status), text_of(job.path("log"))};
}

/// A disk of its own, if we may mount one.
class SmallDisk {
public:
  SmallDisk(std::filesystem::path place, const std::string& size) : place_(std::move(place)) {
    std::filesystem::create_directories(place_);
    mounted_ = ::mount("none", place_.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount(place_.c_str());
  }
  bool mounted() const { return mounted_; }

private:
  std::filesystem::path place_;
  bool mounted_;
};

TEST(FullDisk, LosesNothingThatWasDone) {
  const SmallJob job({"output.checkpoint_interval=1 s"});
  const SmallDisk disk(job.path("full"), "400k");
  if (!disk.mounted()) GTEST_SKIP() << "needs the right to mount a small disk";
  const Program program = job.start("full", "1-12");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), testing::AnyOf(HasSubstr("disk full?"), HasSubstr("No space left")));
  EXPECT_THAT(program.said(), HasSubstr("of 12 seeds failed"));
  ASSERT_TRUE(std::filesystem::exists(job.path("full/run_0001.h5")));
  ASSERT_EQ(job.complete("undisturbed", "1"), "");
  EXPECT_TRUE(job.result("full", 1) == job.result("undisturbed", 1));
  EXPECT_THAT(files_in(job.path("full")), testing::Each(Not(HasSubstr(".part"))));
}

// The library makes an empty file before it finds no room for its first bytes.
TEST(FullDisk, WithoutRoomForAByteLeavesNoPart) {
  const SmallJob job;
  const SmallDisk disk(job.path("full"), "8k");
  if (!disk.mounted()) GTEST_SKIP() << "needs the right to mount a small disk";
  write_file(job.path("full/filler"), std::string(8192, 'x'));
  EXPECT_THAT(refusal([&] { write_flow_grid(job.flow, job.path("full/flow.h5")); }), HasSubstr("No space left"));
  EXPECT_EQ(files_in(job.path("full")), std::vector<std::string>{"filler"});
}

TEST(FullDisk, AStateThatCannotBeWrittenCostsOnlyTheState) {
  const SmallJob job;
  // 8 kB a file (in blocks of 512 bytes or 1 kB, as the shell has it): enough for no state.
  const Limited run = limited(job, "trap '' XFSZ; ulimit -f 8", "out", "--seeds 1");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.said, HasSubstr("the state could not be saved: "));
  EXPECT_THAT(run.said, HasSubstr("cannot be written: File too large"));
  EXPECT_FALSE(std::filesystem::exists(job.path("out/run_0001.h5")));
  EXPECT_THAT(files_in(job.path("out")), testing::Each(Not(HasSubstr(".part"))));
  EXPECT_EQ(job.complete("out", "1"), "");
}

TEST(FullDisk, ALimitOnFilesIsALineToo) {
  // Without the trap the system would end the program by a signal.
  const SmallJob job({"output.checkpoint_interval=1 s"});
  const Limited run = limited(job, "ulimit -f 8", "out", "--seeds 1");
  EXPECT_EQ(run.status, 1) << run.said;
  EXPECT_THAT(run.said, HasSubstr("cannot be written"));
}

TEST(ReadOnly, AFolderInThePlaceOfTheLedger) {
  const SmallJob job;
  std::filesystem::create_directories(job.path("out/ensemble.csv"));
  const Program program = job.start("out", "1");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("ensemble.csv (cannot be written: Is a directory)"));
  EXPECT_THAT(program.said(), HasSubstr("1 seeds are done but not listed in "));
  EXPECT_TRUE(std::filesystem::exists(job.path("out/run_0001.h5")));
}

TEST(ReadOnly, AFileInThePlaceOfTheDirectory) {
  const SmallJob job;
  write_file(job.path("out"), "not a directory");
  const Program program = job.start("out", "1");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("out: is a file: runs go into a folder"));
  EXPECT_EQ(lines(program.said()), 1) << program.said();
}

TEST(ReadOnly, Directory) {
  const SmallJob job;
  std::filesystem::create_directories(job.path("out"));
  const SmallDisk disk(job.path("out"), "1m");
  if (disk.mounted()) {
    // Root may write anywhere but on a disk that is mounted to be read.
    ASSERT_EQ(::mount("none", job.path("out").c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr), 0);
  } else if (geteuid() == 0) {
    GTEST_SKIP() << "root that may not mount";
  } else {
    ::chmod(job.path("out").c_str(), 0555);
  }
  const Program program = job.start("out", "1");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("run_0001.lock (cannot be written: "));
  EXPECT_THAT(program.said(), HasSubstr("give another --out"));
  ::chmod(job.path("out").c_str(), 0755);
}

TEST(Flow, VanishedOrCutShort) {
  const SmallJob job;
  const std::string whole = text_of(job.path("flow.h5"));
  for (const std::size_t length : {std::size_t{0}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
    write_file(job.path("flow.h5"), whole.substr(0, length));
    const Program program = job.start("out", "1");
    EXPECT_EQ(program.wait(), 1);
    EXPECT_THAT(program.said(), HasSubstr("flow.h5"));
    EXPECT_EQ(lines(program.said()), 1) << program.said();
  }
  std::filesystem::remove(job.path("flow.h5"));
  const Program program = job.start("out", "1");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("flow.h5 (no such file)"));
  EXPECT_EQ(lines(program.said()), 1) << program.said();
}

TEST(Flow, VanishingDuringTheRunDoesNoHarm) {
  const SmallJob job(longer);
  const Program program = job.start("out", "1");
  ASSERT_TRUE(appears(job.path("out/run_0001.state")));
  std::filesystem::rename(job.path("flow.h5"), job.path("elsewhere.h5"));
  EXPECT_EQ(program.wait(), 0) << program.said();
  std::filesystem::rename(job.path("elsewhere.h5"), job.path("flow.h5"));
}

TEST(Flow, OfAnotherGeometry) {
  const SmallJob job;
  const Program other = job.start("out", "1", {"--set", "geometry.neck_width=110 um"});
  EXPECT_EQ(other.wait(), 1);
  EXPECT_EQ(lines(other.said()), 1) << other.said();
  EXPECT_THAT(other.said(), HasSubstr("neck_width"));
}

/// A call of the program as a shell makes it; its exit status.
int shell(const std::string& words) { return WEXITSTATUS(std::system((CLOG_PROGRAM " " + words).c_str())); }

TEST(Output, AFullDiskUnderTheLogCostsTheLogAlone) {
  const SmallJob job;
  const std::string call =
      fmt::format("run {} --flow {} --seeds 1 --out ", job.path("scene.toml").string(), job.path("flow.h5").string());
  EXPECT_EQ(shell(call + job.path("a").string() + " > /dev/null 2> /dev/full"), 0);
  EXPECT_EQ(shell(call + job.path("b").string() + " > /dev/full 2> " + job.path("log").string()), 1);
  EXPECT_THAT(text_of(job.path("log")), HasSubstr("clog: standard output cannot be written (disk full?)"));
  EXPECT_TRUE(job.result("a", 1) == job.result("b", 1));
  EXPECT_EQ(shell("info " + job.path("scene.toml").string() + " --effective > /dev/full 2> /dev/null"), 1);
}

TEST(Scene, APipeIsNotWaitedFor) {
  const ScratchFolder folder;
  ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  const Program program({"run", folder.path() / "pipe", "--out", folder.path() / "out"}, folder.path() / "log");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("pipe (the scene file cannot be read: it is no regular file)"));
}

TEST(Flow, WithANaNInTheField) {
  const SmallJob job;
  const std::string put_nan =
      "import h5py, sys; h5py.File(sys.argv[1], 'r+')['VTKHDF/PointData/U'][3, 5, 7, 0] = float('nan')";
  ASSERT_EQ(std::system(fmt::format("/usr/bin/python3 -c \"{}\" {}", put_nan, job.path("flow.h5").string()).c_str()),
            0);
  const Program program = job.start("out", "1");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("holds NaN or infinity at point"));
  EXPECT_EQ(lines(program.said()), 1) << program.said();
}

TEST(Flow, OfZeros) {
  SmallJob job;
  job.flow.velocity.assign(job.flow.velocity.size(), 0.0f);
  write_flow_grid(job.flow, job.path("flow.h5"));
  const Program program = job.start("out", "1");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("the flow file carries 0 m3/s through x = "));
  EXPECT_EQ(lines(program.said()), 1) << program.said();
  EXPECT_FALSE(std::filesystem::exists(job.path("out")));
}

TEST(Flow, WhereNoneIsUsed) {
  const SmallJob job;
  write_file(job.path("scene.toml"), effective_scene(laboratory_scene({1e6, 0.3, 1000, 0.1}, 0.01)));
  const Program program = job.start("out", "1");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("flow.h5 would not be used: leave out --flow"));
  EXPECT_EQ(lines(program.said()), 1) << program.said();
}

TEST(Seeds, NoneNamed) {
  const SmallJob job;
  const Program program = job.start("out", "");
  EXPECT_EQ(program.wait(), 1);
  EXPECT_EQ(lines(program.said()), 1) << program.said();
  EXPECT_FALSE(std::filesystem::exists(job.path("out")));
}

TEST(Directory, VanishingDuringTheRunIsSaid) {
  const SmallJob job(longer);
  const Program program = job.start("out", "1");
  ASSERT_TRUE(appears(job.path("out/run_0001.state")));
  std::filesystem::rename(job.path("out"), job.path("moved"));
  EXPECT_EQ(program.wait(), 1);
  EXPECT_THAT(program.said(), HasSubstr("the state could not be saved: "));
  EXPECT_THAT(program.said(), HasSubstr("run_0001.h5"));
  // What had been saved is where the directory went, and goes on from there.
  EXPECT_EQ(job.complete("moved", "1"), "");
}

}  // namespace
}  // namespace clogflow::test
