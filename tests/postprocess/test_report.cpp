// The report of a small ensemble, and what is said when a tool is missing.
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

TEST_F(Report, a_missing_module_is_named) {
  std::filesystem::create_directories(here_);
  const auto python = here_ / "python3";
  std::ofstream(python)
      << "#!/bin/sh\necho \"ModuleNotFoundError: No module named 'h5py'\" >&2\nexit 1\n";
  std::filesystem::permissions(python, std::filesystem::perms::owner_all);
  const Environment override("CLOG_PYTHON", python.string());
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
