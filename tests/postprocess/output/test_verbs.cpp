// The verbs fit, stats and report as a user types them: exit status and one line of error.
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "coupling/base/child_process.hpp"
#include "coupling/base/source_folder.hpp"
#include "tests/postprocess/synthetic_ensemble.hpp"
#include "tests/scratch.hpp"
#include "tests/test_data.hpp"

namespace clogflow::postprocess {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

ChildResult clog(std::vector<std::string> words) {
  words.insert(words.begin(), CLOG_PROGRAM);
  return run_program(words);
}

std::filesystem::path temporary(const char* name) { return scratch_folder() / name; }

/// By a shell that first lets no file grow over a kilobyte, as on a full disk.
ChildResult clog_without_room(const std::string& words) {
  return run_program({"/bin/sh", "-c", std::string("trap '' XFSZ; ulimit -f 1; exec ") + CLOG_PROGRAM + " " + words});
}

TEST(Fit, prints_json) {
  const auto plain = clog({"fit", clogflow::test_data("csn_surnames.txt")});
  ASSERT_EQ(plain.status, 0) << plain.output;
  const auto json = nlohmann::json::parse(plain.output);
  EXPECT_NEAR(json["alpha"].get<double>(), 2.5, 0.05);
  EXPECT_EQ(json["n"], 2753);
  EXPECT_FALSE(json.contains("p_value"));
  for (const char* key : {"xmin", "sigma", "n_tail", "ks", "ties", "exponential"})
    EXPECT_TRUE(json.contains(key)) << key;
}

// The continuous law has 4.88 for these counts of a law with 2.5, and cannot be told from a good fit.
TEST(Fit, whole_numbers_have_the_discrete_law) {
  const std::string file = clogflow::test_data("cases/counts61.txt");
  const auto json = nlohmann::json::parse(clog({"fit", file, "--xmin", "1"}).output);
  EXPECT_NEAR(json["alpha"].get<double>(), 2.5, 2 * json["sigma"].get<double>());
  EXPECT_EQ(json["discrete"], true);
  EXPECT_EQ(json["discrete_from"], "values");
  const auto continuous = nlohmann::json::parse(clog({"fit", file, "--xmin", "1", "--continuous"}).output);
  EXPECT_EQ(continuous["discrete"], false);
  EXPECT_EQ(continuous["discrete_from"], "given");
  EXPECT_THAT(continuous["notes"][0].get<std::string>(), HasSubstr("whole numbers"));
  EXPECT_EQ(clog({"fit", file, "--continuous", "--discrete"}).status, 2);
  const auto refused = clog({"fit", clogflow::test_data("csn_surnames.txt"), "--discrete"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.output, HasSubstr("needs whole numbers"));
}

TEST(Fit, p_value_with_and_without_a_number_and_seeded) {
  const std::string file = clogflow::test_data("csn_surnames.txt");
  EXPECT_EQ(nlohmann::json::parse(clog({"fit", file, "--p-value"}).output)["p_value_replicates"], 1000);
  const auto once = clog({"fit", file, "--p-value", "50", "--seed", "4"}).output;
  EXPECT_EQ(nlohmann::json::parse(once)["p_value_replicates"], 50);
  EXPECT_EQ(clog({"fit", file, "--p-value", "50", "--seed", "4"}).output, once);
}

TEST(Fit, xmin_given_and_refused) {
  const auto fixed =
      nlohmann::json::parse(clog({"fit", clogflow::test_data("csn_flares.txt"), "--xmin", "323"}).output);
  EXPECT_NEAR(fixed["alpha"].get<double>(), 1.79, 0.005);
  EXPECT_EQ(fixed["xmin_from"], "given");
  const auto refused = clog({"fit", clogflow::test_data("csn_flares.txt"), "--xmin", "1e9"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.output, StartsWith("clog: xmin = 1000000000 leaves 0 of 12773 values"));
}

TEST(Fit, wrong_usage_and_bad_files) {
  EXPECT_EQ(clog({"fit"}).status, 2);
  EXPECT_EQ(clog({"fit", "file", "--p-value", "many"}).status, 2);
  EXPECT_EQ(clog({"fit", "/nonexistent"}).status, 1);
}

TEST(Stats, from_runs_to_report) {
  const auto runs =
      write_ensemble(temporary("clog_verbs_runs"), {.end = 0.3, .snapshot_interval = 0.02, .more = {}}, 2);
  const auto out = temporary("clog_verbs_stats");
  std::filesystem::remove_all(out);
  const auto stats = clog({"stats", runs.string(), "--out", out.string(), "--p-value", "10"});
  ASSERT_EQ(stats.status, 0) << stats.output;
  EXPECT_THAT(stats.output, StartsWith("D/d = 3.03: 2 seeds, "));
  EXPECT_TRUE(std::filesystem::exists(out / "stats.json"));
  const auto report = clog({"report", out.string()});
  ASSERT_EQ(report.status, 0) << report.output;
  EXPECT_TRUE(std::filesystem::exists(out / "report" / "report.html"));
  EXPECT_EQ(clog({"report", runs.string(), "--out", (out / "direct").string()}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(out / "direct" / "stats.json"));
}

TEST(Stats, one_line_for_runs_that_stop_at_their_first_clog) {
  const auto runs =
      write_ensemble(temporary("clog_verbs_stop"),
                     {.protocol = "stop", .mean_burst = 6, .end = 0.3, .snapshot_interval = 0, .more = {}}, 40);
  const auto stats = clog({"stats", runs, "--out", temporary("clog_verbs_stop_stats"), "--p-value", "0"});
  ASSERT_EQ(stats.status, 0) << stats.output;
  EXPECT_THAT(
      stats.output,
      testing::MatchesRegex("D/d = 3.03: <s> = [0-9.]+ .[0-9., ]+. passages until the first clog, 40 seeds, 0 cut by "
                            "the end; geometric law [a-z ]+.p . [0-9.]+.; packing near the neck 0.4.*"));
  EXPECT_THAT(stats.output, HasSubstr("of 40 clogs stood more than a neck width upstream of the neck: not the neck's"));
}

TEST(Stats, says_when_the_end_of_short_runs_cut_long_bursts_off) {
  const auto said = [](double end) {
    const auto runs = write_ensemble(temporary("clog_verbs_cut"),
                                     {.protocol = "release",
                                      .mean_burst = 60,
                                      .end = end,
                                      .snapshot_interval = 0,
                                      .more = {},
                                      .overrides = {"unclog.after=5 ms"}},
                                     20);
    return clog({"stats", runs, "--out", temporary("clog_verbs_cut_stats"), "--p-value", "0"}).output;
  };
  EXPECT_THAT(said(0.1), HasSubstr("bursts off, long ones more often: <s> leaves them out and is too small; over all "
                                   "passages and clogs it is "));
  EXPECT_THAT(said(4), testing::Not(HasSubstr("too small")));
}

TEST(Stats, names_seeds_that_have_not_ended) {
  const auto runs = write_ensemble(temporary("clog_verbs_unfinished"), {.end = 0.3, .more = {}}, 2);
  const auto call = [&] {
    return clog({"stats", runs, "--out", temporary("clog_verbs_unfinished_stats"), "--p-value", "0"});
  };
  for (const char* state : {"run_0001.state", "ahead_0004.state"}) std::ofstream(runs / state) << "bytes";
  EXPECT_THAT(call().output, testing::Not(HasSubstr("have not ended")));
  std::ofstream(runs / "run_0003.state") << "bytes";
  const auto stats = call();
  EXPECT_EQ(stats.status, 0);
  EXPECT_THAT(stats.output, HasSubstr("seeds that have not ended are left out: 1, such as " +
                                      (runs / "run_0003.state").string() + "; the same `clog run` goes on with them"));
}

TEST(Stats, a_link_that_leads_nowhere_is_named) {
  const std::filesystem::path folder = temporary("dangling");
  std::filesystem::create_directories(folder);
  std::filesystem::create_symlink("nowhere.h5", folder / "run_0001.h5");
  const auto refused = clog({"stats", folder, "--out", temporary("stats")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.output, "clog: " + (folder / "run_0001.h5").string() + " (no such file)\n");
}

TEST(Run, names_the_option_whose_seeds_are_none) {
  const auto scene = (source_folder() / "scenes" / "paper.toml").string();
  const auto refused = clog({"run", scene, "--out", temporary("no_seeds"), "--seeds", "3-1"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.output, "clog: --seeds \"3-1\" (the range 3-1 runs backwards)\n");
}

TEST(Stats, threshold_needs_a_time) {
  const auto refused = clog({"stats", ".", "--out", "x", "--threshold", "3 m"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.output, HasSubstr("--threshold 3 m (must be a positive time such as '3.3 ms')"));
  EXPECT_EQ(clog({"stats", "."}).status, 2);
}

TEST(Info, the_effective_scene_into_a_file) {
  const auto scene = (source_folder() / "scenes" / "paper.toml").string();
  const auto file = temporary("effective.toml");
  const auto printed = clog({"info", scene, "--effective"});
  EXPECT_EQ(clog({"info", scene, "--effective", "--out", file.string()}).status, 0);
  std::ifstream in(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), printed.output);
  EXPECT_EQ(clog({"info", scene, "--out", file.string()}).status, 1);
}

TEST(FullDisk, stats_says_why_and_leaves_nothing_unfinished) {
  const auto here = temporary("full");
  write_ensemble(here / "runs", {.mean_burst = 5, .end = 0.3, .more = {}}, 2);
  const auto failed = clog_without_room("stats " + (here / "runs").string() + " --out " + (here / "stats").string());
  EXPECT_EQ(failed.status, 1);
  EXPECT_THAT(failed.output, AllOf(StartsWith("clog: "), HasSubstr("(cannot be written: File too large)")));
  EXPECT_THAT(files_in(here / "stats"), testing::Each(testing::Not(HasSubstr(".part"))));
  const auto walls = clog_without_room("walls " + (source_folder() / "scenes" / "paper.toml").string() + " --out " +
                                       (here / "walls.stl").string());
  EXPECT_EQ(walls.status, 1);
  EXPECT_THAT(walls.output, HasSubstr("walls.stl (cannot be written: File too large)"));
  EXPECT_THAT(files_in(here), testing::ElementsAre("runs", "stats"));
}

}  // namespace
}  // namespace clogflow::postprocess
