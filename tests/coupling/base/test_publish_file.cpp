// Files that several processes publish at once, that a killed one leaves behind, or that an enemy
// lays out.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include <gmock/gmock.h>

#include "coupling/base/file_part.hpp"
#include "coupling/base/publish_file.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/files/hdf5_file.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/scratch.hpp"

namespace clogflow {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const FileFormat format{.name = "test", .version = 1};

/// A process of its own that ends without any clean-up, as if killed.
pid_t child_that(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  return child;
}

int status_of(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST(PublishFile, ReplacesAnOlderFileAndLeavesNothingElse) {
  const ScratchFolder here;
  publish_file("old", here.path() / "a");
  publish_file("new", here.path() / "a");
  EXPECT_EQ(read_text_file(here.path() / "a"), "new");
  EXPECT_THAT(files_in(here.path()), ElementsAre("a"));
}

TEST(PublishFile, TwoWritersOfOneFileLeaveEachOtherAlone) {
  const ScratchFolder here;
  const auto file = here.path() / "flow.h5";
  {
    Hdf5Writer winner(file, format);
    winner.write("/of_winner", std::vector<double>{1}, {.unit = "m", .shape = {}});
    Hdf5Writer loser(file, format);
    winner.finish();
    // The loser fails and goes.
  }
  EXPECT_TRUE(Hdf5Reader(file, format).has("/of_winner"));
  EXPECT_THAT(files_in(here.path()), ElementsAre("flow.h5"));
}

TEST(PublishFile, WhatAKilledProcessLeftIsClearedWhatALivingOneWritesIsNot) {
  const ScratchFolder here;
  const auto file = here.path() / "a";
  status_of(child_that([&] { new FilePart(file); }));
  EXPECT_THAT(files_in(here.path()), ElementsAre("a.clog.part"));
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t living = child_that([&] {
    new FilePart(file);
    EXPECT_EQ(write(ready[1], "x", 1), 1);
    pause();
  });
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  publish_file("whole", file);
  EXPECT_THAT(files_in(here.path()), ElementsAre("a", "a.clog.part"));
  kill(living, SIGKILL);
  status_of(living);
  clear_remainders(file);
  EXPECT_THAT(files_in(here.path()), ElementsAre("a"));
}

TEST(PublishFile, ManyProcessesAtOnceSomeOfThemKilled) {
  const ScratchFolder here;
  const auto file = here.path() / "a";
  const std::string content(200'000, 'x');
  std::vector<pid_t> children;
  for (int k = 0; k < 6; ++k)
    children.push_back(child_that([&] {
      for (int i = 0; i < 30; ++i) publish_file(content, file);
    }));
  usleep(20'000);
  for (int k = 0; k < 3; ++k) kill(children[k], SIGKILL);
  for (int k = 0; k < 6; ++k) {
    const int status = status_of(children[k]);
    EXPECT_TRUE(k < 3 || status == 0) << k;
  }
  EXPECT_EQ(read_text_file(file), content);
  clear_remainders(file);
  EXPECT_THAT(files_in(here.path()), ElementsAre("a"));
}

TEST(PublishFile, FollowsNoLinkAndTakesNoForeignFile) {
  const ScratchFolder here;
  publish_file("precious", here.path() / "victim");
  publish_file("of the user", here.path() / "a.part");
  std::filesystem::create_symlink("victim", here.path() / "a.clog.part");
  std::filesystem::create_symlink("new_victim", here.path() / "a.clog2.part");
  publish_file("text", here.path() / "a");
  { Hdf5Writer unfinished(here.path() / "a", format); }
  EXPECT_EQ(read_text_file(here.path() / "victim"), "precious");
  EXPECT_EQ(read_text_file(here.path() / "a.part"), "of the user");
  EXPECT_THAT(files_in(here.path()), ElementsAre("a", "a.clog.part", "a.clog2.part", "a.part", "victim"));
}

TEST(PublishFile, ToldIsTheFileAndTheReason) {
  const ScratchFolder here;
  EXPECT_THAT(refusal([&] { publish_file("x", here.path() / "absent" / "a"); }),
              HasSubstr("absent/a (cannot be written: No such file or directory)"));
  EXPECT_THAT(refusal([&] { publish_file("x", here.path()); }), HasSubstr("(cannot be written: Is a directory)"));
  EXPECT_THAT(refusal([&] { publish_file("x", "/dev/full"); }), HasSubstr("/dev/full (cannot be written: "));
}

}  // namespace
}  // namespace clogflow
