// From run files to stats.json and tables: what went in must come out.
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "postprocess/events/run_groups.hpp"
#include "postprocess/events/scene_lines.hpp"
#include "postprocess/output/statistics_files.hpp"
#include "tests/postprocess/synthetic_ensemble.hpp"
#include "tests/scratch.hpp"

namespace clogflow::postprocess {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class StatisticsFiles : public testing::Test {
protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    here_ = scratch_folder() / (std::string("clog_statistics_") + test->name());
    std::filesystem::remove_all(here_);
    std::filesystem::create_directories(here_);
  }
  void TearDown() override { std::filesystem::remove_all(here_); }

  json statistics_of(const std::vector<std::filesystem::path>& folders) {
    StatisticsJob job{.folders = folders, .out = here_ / "stats", .threshold = {}, .request = {}};
    job.request.p_value_replicates = 50;
    write_statistics(job);
    return json::parse(text("stats.json"));
  }

  std::string text(const char* file) {
    std::ifstream in(here_ / "stats" / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::filesystem::path here_;
  SyntheticEnsemble short_runs_{.mean_burst = 6, .end = 0.5, .snapshot_interval = 0, .more = {}};
};

double number(const json& group, const char* quantity) { return group["quantities"][quantity]["value"]; }

TEST_F(StatisticsFiles, recovers_the_laws_that_made_the_runs) {
  const SyntheticEnsemble ensemble{.end = 6, .snapshot_interval = 0, .more = {}};
  const auto all = statistics_of({write_ensemble(here_ / "runs", ensemble, 8)});
  ASSERT_EQ(all["groups"].size(), 1U);
  const auto& group = all["groups"][0];
  EXPECT_NEAR(group["tau"].get<double>(), 6.6e-3, 1e-15);
  EXPECT_NEAR(group["t_min"].get<double>(), 3.3e-3, 1e-15);
  EXPECT_NEAR(number(group, "mean_burst"), 12, 1.5);  // about 1000 bursts: three standard errors
  EXPECT_NEAR(number(group, "alpha_fixed"), 2.5, 0.2);
  EXPECT_NEAR(group["power_law"]["fixed_censored"]["alpha"].get<double>(), number(group, "alpha_fixed"), 1e-12);
  EXPECT_GT(group["power_law"]["fixed"]["p_value"].get<double>(), 0.02);
  EXPECT_EQ(group["power_law"]["fixed"]["exponential"]["favoured"], "power law");
  EXPECT_FALSE(group["power_law"]["fixed"]["discrete"].get<bool>());
  const auto& headline = group["quantities"]["alpha_fixed"];
  EXPECT_FALSE(headline["ruled_out"].get<bool>());
  EXPECT_THAT(headline["verdict"].get<std::string>(), HasSubstr("power law not ruled out (p = "));
  EXPECT_FALSE(group["bursts"]["geometric"]["ruled_out"].get<bool>());
  const auto& mean = group["quantities"]["mean_burst"];
  EXPECT_LT(mean["low"], mean["value"]);
  EXPECT_GT(mean["high"], mean["value"]);
  // One in twenty ensembles that do not drift has such an interval; the change itself is within four standard errors.
  const auto& change = mean["change"];
  EXPECT_EQ(mean["drifts"].get<bool>(), change["low"].get<double>() > 0 || change["high"].get<double>() < 0);
  EXPECT_NEAR(change["value"].get<double>(), 0, 3);
  EXPECT_NEAR(group["steady"]["packing_fraction"]["value"].get<double>(), 0.45, 0.01);
  EXPECT_NEAR(group["steady"]["porosity"][2]["value"].get<double>(), 0.53, 0.01);
  EXPECT_NEAR(group["steady"]["particles"]["value"].get<double>(), 954, 10);
  EXPECT_TRUE(group["quantities"]["share_failed"]["value"].is_null());
  EXPECT_EQ(group["runs"][0]["filling_time"], 0.08);
  EXPECT_EQ(group["label"], "D/d = 3.03");
  // A single ensemble has no axis; what was looked for is said all the same.
  EXPECT_EQ(all["trend"]["series"][0]["alpha"],
            (json{{"law", "alpha = A exp(b x)"}, {"x", ""}, {"points", 1}, {"refused", "1 points (a line needs 3)"}}));
}

TEST_F(StatisticsFiles, releases) {
  auto ensemble = short_runs_;
  ensemble.protocol = "release";
  ensemble.end = 10;
  const auto all = statistics_of({write_ensemble(here_ / "runs", ensemble, 6)});
  const auto& group = all["groups"][0];
  EXPECT_EQ(group["protocol"], "release");
  EXPECT_NEAR(number(group, "mean_burst"), 6, 0.7);
  EXPECT_NEAR(number(group, "passages_while_off"), 0.7, 0.06);
  EXPECT_EQ(number(group, "share_failed"), 0);
  EXPECT_EQ(group["bursts"]["first"], 6);
  EXPECT_GT(group["arrests"]["ended_by_release"].get<int>(), 500);
  EXPECT_EQ(group["power_law"]["fixed_censored"]["refused"], "no arrest that ended with a passage");
  const auto& alpha = group["quantities"]["alpha_fixed"];
  EXPECT_TRUE(alpha["value"].is_null() && alpha["low"].is_null());
  EXPECT_LT(alpha["high"].get<double>(), 1.1);
  EXPECT_EQ(alpha["note"], "no arrest that a passage ended");
}

TEST_F(StatisticsFiles, restarts_and_pokes_are_releases) {
  for (const char* protocol : {"restart", "poke"}) {
    auto ensemble = short_runs_;
    ensemble.protocol = protocol;
    ensemble.end = 4;
    const auto group = statistics_of({write_ensemble(here_ / protocol, ensemble, 6)})["groups"][0];
    EXPECT_EQ(group["protocol"], protocol);
    EXPECT_NEAR(number(group, "mean_burst"), 6, 1.2);
    EXPECT_EQ(group["bursts"]["first"], 6);
    EXPECT_GT(group["arrests"]["ended_by_release"].get<int>(), 200);
    EXPECT_EQ(group["first_burst"]["clogged"], 6);
    EXPECT_THAT(group["notes"].dump(), HasSubstr("clogs are ended by releases"));
    const auto& order = group["burst_order"];
    EXPECT_GT(order["bursts"].get<int>(), 200);
    EXPECT_EQ(order["fifths"].size(), 5U);
    EXPECT_NEAR(order["fifths"][4]["value"].get<double>(), 6, 3);
    EXPECT_LT(order["memory"]["low"].get<double>(), order["memory"]["high"].get<double>());
    EXPECT_EQ(order["depends"].get<bool>(),
              std::min(order["memory"]["p_value"], order["trend"]["p_value"]).get<double>() < 0.05);
  }
}

TEST_F(StatisticsFiles, first_bursts_of_runs_that_stop) {
  auto ensemble = short_runs_;
  ensemble.protocol = "stop";
  ensemble.end = 0.02;  // a tenth of the seeds is cut
  ensemble.overrides = {"unclog.after = 3.5 ms"};
  const auto all = statistics_of({write_ensemble(here_ / "runs", ensemble, 100)});
  const auto& group = all["groups"][0];
  EXPECT_EQ(group["protocol"], "stop");
  const auto& first = group["first_burst"];
  EXPECT_EQ(first["seeds"], 100);
  EXPECT_EQ(first["clogged"].get<int>() + first["cut_off"].get<int>(), 100);
  EXPECT_GT(first["cut_off"].get<int>(), 0);
  // Sizes from 1 on with a mean of 6: from 0 on the hazard is 1/7.
  EXPECT_NEAR(first["hazard"]["value"].get<double>(), 1.0 / 7, 0.045);  // three standard errors
  EXPECT_LT(first["hazard"]["low"].get<double>(), first["hazard"]["value"].get<double>());
  EXPECT_NEAR(first["mean"]["value"].get<double>(), 6, 2);
  EXPECT_LT(first["mean"]["low"].get<double>(), first["mean"]["value"].get<double>());
  EXPECT_EQ(first["mean"]["restricted_to"].is_null() || first["mean"]["restricted_to"] == first["largest"], true);
  EXPECT_THAT(first["geometric"]["verdict"].get<std::string>(), HasSubstr("(p"));
  EXPECT_NEAR(first["packing_near_neck"]["flowing"]["value"].get<double>(), 0.47, 0.01);
  EXPECT_NEAR(first["packing_near_neck"]["at_end"]["value"].get<double>(), 0.47, 0.02);
  EXPECT_EQ(first["clog_places"]["known"], first["clogged"]);
  EXPECT_GE(first["hazard_bins"].size(), 2U);
  EXPECT_EQ(first["hazard_bins"][0]["from"], 0);
  EXPECT_TRUE(group["burst_order"].is_null());
  EXPECT_EQ(group["bursts"]["cut_off"], first["cut_off"]);
  const auto& point = all["trend"]["points"][0];
  EXPECT_EQ(point["mean_burst"]["stops"], first["clogged"]);
  EXPECT_EQ(point["mean_burst"]["passages"], first["passages"]);
  EXPECT_NEAR(point["mean_burst"]["value"].get<double>(), number(group, "first_burst_mean"), 1e-12);
}

TEST_F(StatisticsFiles, tables_carry_units) {
  statistics_of({write_ensemble(here_ / "runs", short_runs_, 2)});
  EXPECT_THAT(text("lapses.csv"), StartsWith("group,seed,start [s],T [s],T/tau [1],ended_by\n0,1,"));
  EXPECT_THAT(text("bursts.csv"), StartsWith("group,seed,start [s],duration [s],s [1],while_off [1],kind\n"));
  EXPECT_THAT(text("arrests.csv"), StartsWith("group,seed,start [s],T [s],T/tau [1],ended_by,censored\n"));
  EXPECT_THAT(text("burst_distribution.csv"),
              StartsWith("group,s_from [1],s_to [1],s/<s> [1],count,P [1],error [1]\n0,0.5,"));
  EXPECT_THAT(text("arrest_survival.csv"), StartsWith("group,T [s],T/tau [1],S [1],error [1],at_risk,ended\n0,"));
  EXPECT_THAT(text("first_bursts.csv"),
              StartsWith("group,seed,s [1],clogged,clog_position [m],packing_near_neck_flowing "
                         "[1],packing_near_neck_at_end [1]\n0,1,"));
  EXPECT_THAT(text("first_burst_survival.csv"), StartsWith("group,n [1],S [1],error [1],at_risk,ended\n"));
  EXPECT_THAT(text("first_burst_hazard.csv"),
              StartsWith("group,n_from [1],n_to [1],clogs,trials,hazard [1],low [1],high [1]\n0,0,"));
  EXPECT_EQ(json::parse(text("stats.json"))["units"]["tau"], "s");
}

TEST_F(StatisticsFiles, same_input_same_bytes) {
  const auto runs = write_ensemble(here_ / "runs", short_runs_, 3);
  statistics_of({runs});
  const auto once = text("stats.json");
  statistics_of({runs});
  EXPECT_EQ(text("stats.json"), once);
}

TEST_F(StatisticsFiles, runs_without_a_passage_are_no_failure) {
  auto run = synthetic_run(short_runs_, 1);
  run.passages = {};
  std::filesystem::create_directories(here_ / "runs");
  write_run_file(run, here_ / "runs" / "run_0001.h5");
  const auto all = statistics_of({here_ / "runs"});
  const auto& group = all["groups"][0];
  EXPECT_EQ(group["power_law"]["free"]["refused"], "no lapse longer than 0");
  EXPECT_EQ(number(group, "share_permanent"), 1);
  EXPECT_TRUE(group["quantities"]["mean_burst"]["value"].is_null());
}

TEST_F(StatisticsFiles, a_sweep_is_grouped_by_scene) {
  auto large = short_runs_;
  large.diameter = "50 um";
  write_ensemble(here_ / "sweep" / "d33", short_runs_, 2);
  write_ensemble(here_ / "sweep" / "d50", large, 3);
  const auto all = statistics_of({here_ / "sweep"});
  ASSERT_EQ(all["groups"].size(), 2U);
  EXPECT_EQ(all["groups"][0]["label"], "D/d = 2");
  EXPECT_EQ(all["groups"][0]["runs"].size(), 3U);
  EXPECT_THAT(all["sweep"].get<std::vector<std::string>>(), testing::Contains("particles.diameter"));
}

TEST_F(StatisticsFiles, refusals_name_the_file) {
  auto large = short_runs_;
  large.diameter = "50 um";
  const auto runs = write_ensemble(here_ / "runs", short_runs_, 2);
  write_run_file(synthetic_run(large, 3), runs / "run_0003.h5");
  EXPECT_THAT(refusal([&] { statistics_of({runs}); }),
              AllOf(HasSubstr("run_0003.h5: another scene than run_0001.h5 in the same folder"),
                    HasSubstr("a sweep has a folder for each scene")));
  std::filesystem::remove(runs / "run_0003.h5");

  const auto copies = write_ensemble(here_ / "copies", short_runs_, 1);
  EXPECT_THAT(refusal([&] {
                statistics_of({runs, copies});
              }),
              HasSubstr("copies/run_0001.h5: seed 1 of this scene was already read from"));

  std::filesystem::resize_file(runs / "run_0002.h5", 3000);
  EXPECT_THAT(refusal([&] { statistics_of({runs}); }), HasSubstr("run_0002.h5"));
  std::filesystem::create_directories(here_ / "empty");
  EXPECT_THAT(refusal([&] { statistics_of({here_ / "empty"}); }),
              HasSubstr("empty: no run_*.h5 here or one folder below"));
  EXPECT_THAT(refusal([&] { statistics_of({here_ / "nowhere"}); }), HasSubstr("nowhere: no such folder"));
}

TEST_F(StatisticsFiles, no_flow_needs_a_threshold) {
  auto run = synthetic_run(short_runs_, 1);
  run.scene_text = effective_scene(parse_scene(R"(
[box]
min = ["0 m", "0 m", "0 m"]
max = ["1 mm", "1 mm", "1 mm"]
[fluid]
viscosity = "1e-3 Pa s"
density = "1000 kg/m3"
[particles]
diameter = "33 um"
[contact]
youngs_modulus = "3e6 Pa"
poisson_ratio = 0.35
[time]
end = "1 s"
)",
                                               "box.toml"));
  std::filesystem::create_directories(here_ / "runs");
  write_run_file(run, here_ / "runs" / "run_0001.h5");
  EXPECT_THAT(refusal([&] { statistics_of({here_ / "runs"}); }),
              HasSubstr("run_0001.h5: its scene has no flow, hence no Stokes time"));
  EXPECT_EQ(gather({here_ / "runs"}, 0.004).front().scale.tau, 0.008);
}

TEST_F(StatisticsFiles, an_output_that_cannot_be_written_is_named) {
  const auto runs = write_ensemble(here_ / "runs", short_runs_, 1);
  std::ofstream(here_ / "stats") << "a file, not a folder";
  EXPECT_THAT(refusal([&] { statistics_of({runs}); }), HasSubstr("stats: cannot be created"));
  std::filesystem::remove(here_ / "stats");
  std::filesystem::create_directories(here_ / "stats" / "stats.json");
  EXPECT_THAT(refusal([&] { statistics_of({runs}); }), HasSubstr("stats.json (cannot be written: Is a directory)"));
}

/// Two necks by turns: neck 0 stands from 0.2 to 0.6 s and neck 1 from 0.5 to 0.9 s, both from 0.5 to 0.6 s alone.
RunData two_necks(std::uint64_t seed) {
  RunData run = synthetic_run({.end = 1, .snapshot_interval = 0, .more = {}}, seed);
  run.passages = {};
  run.record.necks = 2;
  for (int k = 0; k < 1000; ++k) {
    const double t = 1e-3 * k + 1e-6 * static_cast<double>(seed);
    const int neck = k % 2;
    if (neck == 0 ? t > 0.2 && t < 0.6 : t > 0.5 && t < 0.9) continue;
    add_passage(run, t, 0);
    run.passages.neck.push_back(neck);
  }
  return run;
}

TEST_F(StatisticsFiles, of_each_neck_and_of_both) {
  std::filesystem::create_directories(here_ / "necks");
  for (const std::uint64_t seed : {1, 2, 3}) write_run_file(two_necks(seed), here_ / "necks" / run_file_name(seed));
  const json both = statistics_of({here_ / "necks"})["groups"][0];
  ASSERT_EQ(both["necks"].size(), 2u);
  // A clog of one neck is not a clog of both: each has one for 0.4 s, together they have one for 0.1 s.
  std::size_t sum = 0;
  for (const json& neck : both["necks"]) {
    EXPECT_EQ(neck["arrests"]["ended_by_passage"], 3);
    EXPECT_NEAR(neck["longest"].get<double>(), 0.4, 3e-3);
    EXPECT_NEAR(neck["runs"][0]["passages"].get<double>(), 300, 2);
    sum += neck["runs"][0]["passages"].get<std::size_t>();
  }
  EXPECT_EQ(both["arrests"]["ended_by_passage"], 3);
  EXPECT_NEAR(both["longest"].get<double>(), 0.1, 3e-3);
  EXPECT_EQ(both["runs"][0]["passages"], sum);
  EXPECT_THAT(both["notes"].dump(), HasSubstr("2 necks side by side"));
}

TEST_F(StatisticsFiles, runs_with_and_without_necks_do_not_mix) {
  std::filesystem::create_directories(here_ / "mixed");
  RunData plain = two_necks(2);
  plain.record.necks.reset();
  plain.passages.neck.clear();
  write_run_file(two_necks(1), here_ / "mixed" / run_file_name(1));
  write_run_file(plain, here_ / "mixed" / run_file_name(2));
  EXPECT_THAT(refusal([&] { statistics_of({here_ / "mixed"}); }),
              HasSubstr("counted at 1 necks, the runs before it at 2"));
}

TEST(Filling, an_empty_start_counts_from_the_full_channel) {
  SyntheticEnsemble ensemble{.end = 1, .snapshot_interval = 0, .more = {}};
  auto run = synthetic_run(ensemble, 1);
  Scene scene = parse_scene(run.scene_text, "synthetic.toml");
  EXPECT_EQ(end_of_filling(run, scene), 0);
  scene.inlet.start = InletStart::empty;
  for (std::size_t i = 0; i < run.series.time.size(); ++i) {
    run.series.count[i] = static_cast<std::int64_t>(std::min(1000.0, 5000 * run.series.time[i]));
  }
  EXPECT_NEAR(end_of_filling(run, scene), 0.19, 1e-3);  // 950 of 1000
}

TEST(SceneLines, differences_and_what_does_not_matter) {
  const auto a = scene_lines("body_force = 1\n# note\n[time]\nend = \"1 s\"\n[output]\nseries_interval = \"2 s\"\n");
  const auto b =
      scene_lines("body_force = 1\n[time]\nend = \"2 s\"\n[ensemble]\nseeds = [1]\n[drag]\nenabled = true\n");
  EXPECT_THAT(differing_keys(a, b), ElementsAre("time.end", "drag.enabled"));
  EXPECT_TRUE(differing_keys(a, a).empty());
  // A run of an earlier program has the laws of then.
  EXPECT_TRUE(differing_keys(scene_lines("[contact]\nrestitution = 0.7\n"),
                             scene_lines("[contact]\nlaw = \"hertz\"\nrestitution = 0.7\n"))
                  .empty());
}

}  // namespace
}  // namespace clogflow::postprocess
