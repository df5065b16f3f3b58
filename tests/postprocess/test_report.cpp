// The report of a small ensemble, and what is said when a tool is missing.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>

#include "postprocess/child_process.hpp"
#include "postprocess/report.hpp"
#include "postprocess/statistics_files.hpp"
#include "tests/postprocess/synthetic_ensemble.hpp"
#include "tests/scratch.hpp"

namespace clog::postprocess {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Sets a variable of the environment for the duration of a test.
class Environment {
public:
  Environment(const char* name, const std::string& value) : name_(name) {
    setenv(name, value.c_str(), 1);
  }
  ~Environment() { unsetenv(name_); }

private:
  const char* name_;
};

class Report : public testing::Test {
protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    here_ = scratch_folder() / (std::string("clog_report_") + test->name());
    std::filesystem::remove_all(here_);
  }
  void TearDown() override { std::filesystem::remove_all(here_); }

  void make(const std::filesystem::path& runs) {
    StatisticsJob job{.folders = {runs}, .out = here_ / "stats", .threshold = {}, .request = {}};
    job.request.p_value_replicates = 20;
    write_statistics(job);
    make_report(here_ / "stats", here_ / "report");
  }

  /// A shell script in the place of python.
  std::string interpreter(const std::string& lines) const {
    std::filesystem::create_directories(here_);
    const auto file = here_ / "python3";
    std::ofstream(file) << "#!/bin/sh\n" << lines << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file;
  }

  std::filesystem::path here_;
};

TEST_F(Report, figures_in_both_formats_and_a_page_that_needs_no_other_file) {
  make(write_ensemble(here_ / "runs",
                      {.mean_burst = 5, .end = 0.3, .snapshot_interval = 0.01, .more = {}}, 2));
  for (const char* figure : {"snapshots", "spatiotemporal", "bursts", "lapses", "series"}) {
    const auto name = here_ / "report" / figure;
    EXPECT_THAT(text_of(name.string() + ".png"), StartsWith("\x89PNG")) << figure;
    EXPECT_THAT(text_of(name.string() + ".svg"), HasSubstr("</svg>")) << figure;
  }
  const auto page = text_of(here_ / "report" / "report.html");
  EXPECT_THAT(page,
              AllOf(HasSubstr("data:image/png;base64,"), HasSubstr("D/d = 3.03"),
                    HasSubstr("neck_width"), Not(HasSubstr("src=\"http")), HasSubstr("</html>")));
}

TEST_F(Report, without_any_passage_the_figures_say_so) {
  auto run = synthetic_run({.end = 0.1, .snapshot_interval = 0, .more = {}}, 1);
  run.passages = {};
  run.series = {};
  std::filesystem::create_directories(here_ / "runs");
  write_run_file(run, here_ / "runs" / "run_0001.h5");
  make(here_ / "runs");
  EXPECT_THAT(text_of(here_ / "report" / "lapses.svg"), HasSubstr("no two passages in any run"));
  EXPECT_THAT(text_of(here_ / "report" / "bursts.svg"), HasSubstr("no burst that began and ended"));
  EXPECT_THAT(text_of(here_ / "report" / "snapshots.svg"), HasSubstr("no snapshots in these runs"));
  EXPECT_THAT(text_of(here_ / "report" / "series.svg"), HasSubstr("no time series in these runs"));
}

// Half a page, then killed: what was there stays, and nothing half lies under a final name.
TEST_F(Report, a_script_that_is_killed_leaves_the_older_report) {
  std::filesystem::create_directories(here_ / "report");
  std::ofstream(here_ / "report" / "report.html") << "older";
  const Environment override(
      "CLOG_PYTHON",
      interpreter("[ \"$1\" = -c ] && exit 0\necho half > \"$4/report.html\"\nkill -9 $$"));
  EXPECT_THAT(refusal([&] { make_report(here_, here_ / "report"); }),
              AllOf(HasSubstr("report: no figures ("), HasSubstr("ended by signal 9, Killed")));
  EXPECT_EQ(text_of(here_ / "report" / "report.html"), "older");
  EXPECT_EQ(files_in(here_ / "report"), std::vector<std::string>{"report.html"});
}

// The caller is killed while its script draws on: the next call leaves the script's folder alone,
// and one after the script's end clears it.
TEST_F(Report, what_a_killed_call_left_is_cleared_when_its_script_has_ended) {
  std::filesystem::create_directories(here_ / "report");
  const Environment override(
      "CLOG_PYTHON",
      interpreter("[ \"$1\" = -c ] && exit 0\n"
                  "[ ! -e \"$3/wait\" ] || { mkfifo \"$3/end\"; read x < \"$3/end\"; }\n"
                  "echo page > \"$4/report.html\"\necho \"wrote $4/report.html\""));
  std::ofstream(here_ / "wait") << "";
  const pid_t killed = fork();
  if (killed == 0) {
    make_report(here_, here_ / "report");
    _exit(0);
  }
  for (int k = 0; k < 2000 && !std::filesystem::exists(here_ / "end"); ++k) usleep(5000);
  kill(killed, SIGKILL);
  waitpid(killed, nullptr, 0);
  std::filesystem::remove(here_ / "wait");
  make_report(here_, here_ / "report");
  EXPECT_THAT(files_in(here_ / "report"),
              testing::ElementsAre(".drawing.clog.part", ".drawing.clog.part.d", "report.html"));
  std::ofstream(here_ / "end") << "now\n";
  const auto left = here_ / "report" / ".drawing.clog.part.d" / "report.html";
  for (int k = 0; k < 2000 && !std::filesystem::exists(left); ++k) usleep(5000);
  for (int k = 0; k < 400 && files_in(here_ / "report").size() > 1; ++k)
    make_report(here_, here_ / "report");
  EXPECT_THAT(files_in(here_ / "report"), testing::ElementsAre("report.html"));
}

TEST_F(Report, a_missing_module_is_named) {
  const Environment override(
      "CLOG_PYTHON",
      interpreter("echo \"ModuleNotFoundError: No module named 'h5py'\" >&2\nexit 1"));
  EXPECT_THAT(refusal([&] { make_report(here_, here_); }),
              AllOf(HasSubstr("No module named 'h5py'"),
                    HasSubstr("apt-get install python3-matplotlib python3-h5py")));
}

TEST_F(Report, a_missing_interpreter_or_script_is_named) {
  const Environment python("CLOG_PYTHON", "/nonexistent/python3");
  EXPECT_THAT(refusal([&] { make_report(here_, here_); }),
              HasSubstr("/nonexistent/python3: cannot be started"));
  const Environment scripts("CLOG_FIGURES", "/nonexistent/figures");
  EXPECT_THAT(refusal([&] { make_report(here_, here_); }),
              HasSubstr("/nonexistent/figures/make_report.py: not found (set CLOG_FIGURES"));
}

TEST_F(Report, foreign_statistics_are_refused) {
  std::filesystem::create_directories(here_);
  std::ofstream(here_ / "stats.json") << R"({"format": "other"})";
  EXPECT_THAT(refusal([&] { make_report(here_, here_); }),
              HasSubstr("stats.json: not statistics of version 1"));
}

TEST(ChildProcess, status_and_output) {
  const auto result = run_program({"/bin/sh", "-c", "echo out; echo err >&2; exit 3"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.output, "out\nerr\n");
  EXPECT_EQ(run_program({"/bin/sh", "-c", "kill -9 $$"}).status, 137);
}

}  // namespace
}  // namespace clog::postprocess
