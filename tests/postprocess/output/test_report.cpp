// The report of a small ensemble, and what is said when a tool is missing.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "coupling/base/child_process.hpp"
#include "coupling/base/source_folder.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "postprocess/output/report.hpp"
#include "postprocess/output/statistics_files.hpp"
#include "tests/postprocess/synthetic_ensemble.hpp"
#include "tests/scratch.hpp"

namespace clogflow::postprocess {
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
  Environment(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
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

  void make_statistics(const std::filesystem::path& runs) {
    StatisticsJob job{.folders = {runs}, .out = here_ / "stats", .threshold = {}, .request = {}};
    job.request.p_value_replicates = 20;
    write_statistics(job);
  }

  void make(const std::filesystem::path& runs) {
    make_statistics(runs);
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

  /// The page without its pictures.
  std::string page() {
    std::string text = text_of(here_ / "report" / "report.html");
    const std::string start = "base64,";
    for (std::size_t at = 0; (at = text.find(start, at)) != std::string::npos; at += start.size())
      text.erase(at + start.size(), text.find('"', at) - at - start.size());
    return text;
  }

  std::filesystem::path here_;
};

TEST_F(Report, figures_in_all_formats_and_a_page_that_needs_no_other_file) {
  make(write_ensemble(here_ / "runs", {.mean_burst = 5, .end = 0.3, .snapshot_interval = 0.01, .more = {}}, 2));
  for (const char* figure : {"snapshots", "spatiotemporal", "bursts", "lapses", "series"}) {
    const auto name = here_ / "report" / figure;
    EXPECT_THAT(text_of(name.string() + ".png"), StartsWith("\x89PNG")) << figure;
    EXPECT_THAT(text_of(name.string() + ".svg"), HasSubstr("</svg>")) << figure;
    EXPECT_THAT(text_of(name.string() + ".pdf"), AllOf(StartsWith("%PDF"), HasSubstr("/FontFile2"))) << figure;
  }
  const auto page = text_of(here_ / "report" / "report.html");
  EXPECT_THAT(page, AllOf(HasSubstr("data:image/png;base64,"), HasSubstr("D/d = 3.03"), HasSubstr("neck_width"),
                          Not(HasSubstr("src=\"http")), HasSubstr("</html>")));
}

TEST_F(Report, walls_from_a_file_are_drawn) {
  std::filesystem::create_directories(here_ / "runs");
  for (const char* scene : {"two_necks.toml", "pipe.toml"}) {
    RunData run = synthetic_run({.end = 0.1, .snapshot_interval = 0.02, .more = {}}, 1);
    run.scene_text = effective_scene(read_scene(source_folder() / "scenes" / scene));
    write_run_file(run, here_ / "runs" / run_file_name(1));
    make(here_ / "runs");
    const auto shape = nlohmann::json::parse(text_of(here_ / "stats" / "stats.json"))["groups"][0]["geometry"];
    EXPECT_TRUE(shape["present"]) << scene;
    ASSERT_EQ(shape["fluid"].size(), 1u) << scene;
    const Walls& walls = read_stl_channel(parse_scene(run.scene_text, scene).geometry)->walls;
    ASSERT_EQ(shape["walls"].size(), 9 * walls.size()) << scene;
    for (const std::size_t k : {std::size_t{0}, walls.size() / 2, walls.size() - 1})
      EXPECT_NEAR(shape["walls"][9 * k + 5].get<double>(), walls[k].corner[1].z, 0.51e-10) << scene;
    EXPECT_THAT(page(), AllOf(HasSubstr("id=\"film-data\""), HasSubstr("{\"triangles\": "))) << scene;
    EXPECT_THAT(text_of(here_ / "report" / "snapshots.png"), StartsWith("\x89PNG")) << scene;
    // What is filled is wall: between the two necks, beside the pipe's; not within them, nor in the chamber.
    std::ofstream(here_ / "walls.py") << R"(
import json, sys
sys.path.insert(0, sys.argv[1])
import matplotlib; matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgb
import channel, style
figure, axes = plt.subplots()
channel.draw(axes, json.load(open(sys.argv[2]))["groups"][0]["geometry"])
figure.canvas.draw()
pixels = np.asarray(figure.canvas.buffer_rgba())
def wall(x, y):
    column, row = axes.transData.transform((x, y))
    return bool(np.allclose(pixels[len(pixels) - 1 - int(row), int(column), :3] / 255, to_rgb(style.WALL), atol=0.01))
two = sys.argv[3] == "two_necks.toml"
assert wall(50, 0) == two and wall(50, 75) != two and wall(50, -75) != two and not wall(-300, 0)
assert wall(50, 130) and wall(50, -130) and len(axes.lines) > 4
assert np.allclose(axes.get_xlim(), (-560 if two else -650, 100))
)";
    EXPECT_EQ(std::system(fmt::format("/usr/bin/python3 {} {} {} {}", (here_ / "walls.py").string(),
                                      (source_folder() / "postprocess" / "figures").string(),
                                      (here_ / "stats" / "stats.json").string(), scene)
                              .c_str()),
              0)
        << scene;
  }
}

/// Neck 1 lets pass half of what neck 0 does, and what it did while friction was off.
RunData uneven_necks(std::uint64_t seed) {
  RunData run = synthetic_run({.end = 1, .snapshot_interval = 0, .more = {}}, seed);
  run.passages = {};
  run.record.necks = 2;
  for (int k = 0; k < 300; ++k) {
    add_passage(run, 3e-3 * k, k < 3);
    run.passages.neck.push_back(k % 3 == 2 ? 1 : 0);
  }
  return run;
}

TEST_F(Report, several_necks_have_a_table_and_a_figure) {
  std::filesystem::create_directories(here_ / "runs");
  for (const std::uint64_t seed : {1, 2}) write_run_file(uneven_necks(seed), here_ / "runs" / run_file_name(seed));
  make(here_ / "runs");
  EXPECT_THAT(text_of(here_ / "report" / "necks.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(text_of(here_ / "report" / "necks.svg"),
              AllOf(HasSubstr("neck 0"), HasSubstr("neck 1"), HasSubstr("together"), HasSubstr("passages so far")));
  EXPECT_THAT(page(),
              AllOf(HasSubstr("<h2>Each neck</h2>"), HasSubstr("<th>neck 0</th><th>neck 1</th><th>all together</th>"),
                    HasSubstr("<td>passages (of them while friction was off)</td><td>400 (4)</td><td>200 (2)</td>"
                              "<td>600 (6)</td>")));
  // The curves end where the counts do.
  std::ofstream(here_ / "curves.py") << R"(
import json, sys
sys.path.insert(0, sys.argv[1])
import matplotlib.pyplot as plt
import fig_necks
figure, axes = plt.subplots()
fig_necks.draw_passages(axes, json.load(open(sys.argv[2]))["groups"][0], ["red", "blue"])
assert [int(line.get_ydata()[-1]) for line in axes.lines if line.get_label().startswith("neck")] == [198, 99]
)";
  EXPECT_EQ(std::system(fmt::format("/usr/bin/python3 {} {} {}", (here_ / "curves.py").string(),
                                    (source_folder() / "postprocess" / "figures").string(),
                                    (here_ / "stats" / "stats.json").string())
                            .c_str()),
            0);
}

TEST_F(Report, necks_that_let_nothing_pass_say_so_and_one_neck_says_nothing) {
  std::filesystem::create_directories(here_ / "runs");
  RunData run = uneven_necks(1);
  run.passages = {};
  write_run_file(run, here_ / "runs" / run_file_name(1));
  make(here_ / "runs");
  EXPECT_THAT(text_of(here_ / "report" / "necks.svg"),
              AllOf(HasSubstr("nothing passes in the first seed"), HasSubstr("no burst that began and ended")));
  std::filesystem::remove_all(here_ / "report");
  make(write_ensemble(here_ / "single", {.mean_burst = 5, .end = 0.3, .snapshot_interval = 0, .more = {}}, 1));
  EXPECT_FALSE(std::filesystem::exists(here_ / "report" / "necks.png"));
  EXPECT_THAT(page(), Not(HasSubstr("Each neck")));
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

TEST_F(Report, first_bursts_of_one_group_of_many_and_without_a_clog) {
  SyntheticEnsemble ensemble{.protocol = "stop", .mean_burst = 5, .end = 0.3, .snapshot_interval = 0, .more = {}};
  make(write_ensemble(here_ / "runs" / "a", ensemble, 40));
  EXPECT_THAT(text_of(here_ / "report" / "first_burst.svg"), HasSubstr("40 of 40 seeds clogged"));
  EXPECT_THAT(page(), AllOf(HasSubstr("Passages until the first clog"), HasSubstr("solids near the neck at its end"),
                            HasSubstr("first clogs more than a neck width upstream of the neck")));
  ensemble.diameter = "22 um";
  ensemble.mean_burst = 1e9;
  ensemble.end = 0.05;
  write_ensemble(here_ / "runs" / "b", ensemble, 2);
  make(here_ / "runs");
  EXPECT_THAT(text_of(here_ / "report" / "first_burst.svg"),
              AllOf(HasSubstr("0 of 2 seeds clogged"), HasSubstr("40 of 40 seeds clogged")));
  // Neither a passage nor a clog.
  auto run = synthetic_run(ensemble, 1);
  run.passages = {};
  std::filesystem::create_directories(here_ / "silent");
  write_run_file(run, here_ / "silent" / "run_0001.h5");
  make(here_ / "silent");
  EXPECT_THAT(text_of(here_ / "report" / "first_burst.svg"), HasSubstr("no passage and no clog in these runs"));
}

// Half a page, then killed: what was there stays, and nothing half lies under a final name.
TEST_F(Report, a_script_that_is_killed_leaves_the_older_report) {
  std::filesystem::create_directories(here_ / "report");
  std::ofstream(here_ / "report" / "report.html") << "older";
  const Environment override("CLOG_PYTHON",
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
  const Environment override("CLOG_PYTHON",
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
  for (int k = 0; k < 400 && files_in(here_ / "report").size() > 1; ++k) make_report(here_, here_ / "report");
  EXPECT_THAT(files_in(here_ / "report"), testing::ElementsAre("report.html"));
}

/// A run whose passages come at these times [s]; T_min is 3.3 ms.
RunData run_with_passages(std::uint64_t seed, const std::vector<double>& times) {
  auto run = synthetic_run({.end = 0.1, .snapshot_interval = 0, .more = {}}, seed);
  run.passages = {};
  for (const double time : times) add_passage(run, time, 0);
  return run;
}

TEST_F(Report, what_cannot_be_known_is_said_in_its_place) {
  std::filesystem::create_directories(here_ / "runs");
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    write_run_file(run_with_passages(seed, {0.01}), here_ / "runs" / run_file_name(seed));
  make(here_ / "runs");
  EXPECT_THAT(page(), AllOf(HasSubstr("&lt; 1.227 <span class=quiet>no arrest that a passage ended"),
                            HasSubstr("1 <span class=quiet>[1, 2.515] resampled seeds all agree; "
                                      "interval of the counts"),
                            Not(HasSubstr("[1, 1]"))));
}

// Bursts of 2 and 30 only, arrests that last 10 ms or 12 ms, and a second half that flows half as much.
TEST_F(Report, laws_that_are_ruled_out_and_runs_that_drift_are_marked) {
  std::filesystem::create_directories(here_ / "runs");
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    RandomStream random(seed, 5);
    std::vector<double> times;
    auto run = synthetic_run({.end = 4, .snapshot_interval = 0, .more = {}}, seed);
    for (double t = 0; t < 3.9;) {
      for (int k = t < 2 && random.uniform() < 0.5 ? 30 : 2; k > 0; --k) times.push_back(t += 1e-4);
      t += random.uniform() < 0.5 ? 0.010 : 0.012;
    }
    run.passages = {};
    for (const double time : times) add_passage(run, time, 0);
    write_run_file(run, here_ / "runs" / run_file_name(seed));
  }
  make(here_ / "runs");
  EXPECT_THAT(page(), AllOf(HasSubstr("<span class=\"drifts\">power law ruled out (p &lt; 0.05): misses"),
                            HasSubstr("<span class=\"drifts\">drifts: the halves differ</span>"),
                            HasSubstr("<span class=\"drifts\">ruled out (p &lt; 0.001)</span>")));
  EXPECT_THAT(text_of(here_ / "report" / "bursts.svg"), HasSubstr("geometric law: ruled out"));
  EXPECT_THAT(text_of(here_ / "report" / "lapses.svg"), HasSubstr("ruled out: misses by"));
}

/// Puts markup behind every text of a document but the words that decide what is drawn.
void spoil(nlohmann::json& value, const std::string& key = "") {
  static const std::set<std::string> kept{"format", "file", "keys", "key", "protocol"};
  if (kept.contains(key)) return;
  if (value.is_string()) value = value.get<std::string>() + "<i>&$^$";
  if (value.is_array())
    for (auto& each : value) spoil(each, key);
  if (value.is_object())
    for (auto& [name, each] : value.items()) spoil(each, name);
}

TEST_F(Report, foreign_text_is_no_markup_in_the_page_and_no_mathematics_in_a_figure) {
  SyntheticEnsemble ensemble{.end = 0.3, .snapshot_interval = 0, .more = {}};
  write_ensemble(here_ / "runs" / "a", ensemble, 2);
  ensemble.diameter = "50 um";
  write_ensemble(here_ / "runs" / "b", ensemble, 2);
  make_statistics(here_ / "runs");
  auto statistics = nlohmann::json::parse(text_of(here_ / "stats" / "stats.json"));
  spoil(statistics);
  std::ofstream(here_ / "stats" / "stats.json") << statistics;
  make_report(here_ / "stats", here_ / "report");
  EXPECT_THAT(page(), AllOf(HasSubstr("&lt;i&gt;&amp;$^$"), Not(HasSubstr("<i>"))));
}

TEST_F(Report, a_missing_module_is_named) {
  const Environment override("CLOG_PYTHON",
                             interpreter("echo \"ModuleNotFoundError: No module named 'h5py'\" >&2\nexit 1"));
  EXPECT_THAT(refusal([&] { make_report(here_, here_); }),
              AllOf(HasSubstr("No module named 'h5py'"),
                    HasSubstr("apt-get install python3-matplotlib python3-h5py python3-jinja2")));
}

TEST_F(Report, an_interpreter_that_is_killed_is_no_missing_module) {
  const Environment override("CLOG_PYTHON", interpreter("kill -9 $$"));
  EXPECT_THAT(
      refusal([&] { make_report(here_, here_); }),
      AllOf(HasSubstr("python3: cannot load the modules of the figures (ended by signal 9, Killed; last line: no "
                      "output)"),
            Not(HasSubstr("apt-get"))));
}

TEST_F(Report, a_missing_interpreter_or_script_is_named) {
  const Environment python("CLOG_PYTHON", "/nonexistent/python3");
  EXPECT_THAT(refusal([&] { make_report(here_, here_); }), HasSubstr("/nonexistent/python3: cannot be started"));
  const Environment scripts("CLOG_FIGURES", "/nonexistent/figures");
  EXPECT_THAT(refusal([&] { make_report(here_, here_); }),
              HasSubstr("/nonexistent/figures/make_report.py: not found (set CLOG_FIGURES"));
}

TEST_F(Report, foreign_statistics_are_refused) {
  std::filesystem::create_directories(here_);
  std::ofstream(here_ / "stats.json") << R"({"format": "other"})";
  EXPECT_THAT(refusal([&] { make_report(here_, here_); }), HasSubstr("stats.json: not statistics of version 1"));
}

TEST(ChildProcess, status_and_output) {
  const auto result = run_program({"/bin/sh", "-c", "echo out; echo err >&2; exit 3"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.output, "out\nerr\n");
  EXPECT_EQ(run_program({"/bin/sh", "-c", "kill -9 $$"}).status, 137);
}

}  // namespace
}  // namespace clogflow::postprocess
