// Sweeps of made-up ensembles: the laws along the sweep must come out, and bounds must stay bounds.
#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "postprocess/output/statistics_files.hpp"
#include "tests/postprocess/synthetic_ensemble.hpp"
#include "tests/scratch.hpp"

namespace clogflow::postprocess {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Sweeps : public testing::Test {
protected:
  const std::filesystem::path& root() const { return here_.path(); }

  /// A point of the sweep: 4 seeds of 8 s unless the ensemble says otherwise.
  void add(const std::string& folder, SyntheticEnsemble ensemble) {
    ensemble.snapshot_interval = 0;
    write_ensemble(root() / folder, ensemble, 4);
  }

  /// The law <s> = 3 exp(0.05 (D/d)^3), alpha = 1.3 exp(0.25 D/d).
  void add_lawful(int diameter_um) {
    const double ratio = 100.0 / diameter_um;
    const std::string diameter = std::to_string(diameter_um) + " um";
    add("particles.diameter=" + std::to_string(diameter_um) + "um",
        {.diameter = diameter,
         .mean_burst = 3 * std::exp(0.05 * std::pow(ratio, 3)),
         .alpha = 1.3 * std::exp(0.25 * ratio),
         .end = 8,
         .more = {}});
  }

  json statistics() {
    StatisticsJob job{.folders = {root()}, .out = out_.path(), .threshold = {}, .request = {}};
    job.request.p_value_replicates = 0;
    job.request.resampling.replicates = 300;
    write_statistics(job);
    return json::parse(text("stats.json"));
  }

  std::string text(const char* file) {
    std::ifstream in(out_.path() / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

private:
  ScratchFolder here_, out_;
};

double value(const json& estimate) { return estimate.at("value"); }

void expect_inside(const json& estimate, double truth, double tolerance) {
  EXPECT_NEAR(value(estimate), truth, tolerance);
  EXPECT_LT(estimate.at("low"), value(estimate));
  EXPECT_GT(estimate.at("high"), value(estimate));
}

TEST_F(Sweeps, recovers_the_laws_along_the_neck_ratio) {
  for (const int diameter : {50, 40, 33, 28}) add_lawful(diameter);
  const json all = statistics();
  const json& trend = all.at("trend");
  EXPECT_EQ(trend.at("variable").at("name"), "D/d");
  EXPECT_EQ(trend.at("keys"), json({"particles.diameter"}));
  EXPECT_THAT(all.at("sweep").get<std::vector<std::string>>(), Contains("particles.roughness"));
  ASSERT_EQ(trend.at("series").size(), 1U);
  const json& size = trend.at("series")[0].at("mean_burst");
  const json& alpha = trend.at("series")[0].at("alpha");
  EXPECT_EQ(size.at("x"), "(D/d)^3");
  EXPECT_EQ(size.at("points"), 4);
  // Each <s> is known to 4 to 9 %, each alpha to 3 to 6 %: four standard errors of the slopes.
  expect_inside(size.at("b"), 0.05, 0.008);
  expect_inside(size.at("ln_A"), std::log(3.0), 0.2);
  expect_inside(alpha.at("b"), 0.25, 0.12);
  EXPECT_GT(size.at("p_value").get<double>(), 1e-3);
  EXPECT_TRUE(size.at("left_out").empty());
  EXPECT_EQ(size.at("rivals").size(), 4U);
  EXPECT_EQ(size.at("rivals")[3].at("x"), "ln(D/d)");
  EXPECT_GT(size.at("rivals")[3].at("chi_squared"), size.at("chi_squared"));
}

TEST_F(Sweeps, a_point_that_never_clogs_has_a_lower_bound_only) {
  for (const int diameter : {50, 40, 33}) add_lawful(diameter);
  add("particles.diameter=10um", {.diameter = "10 um", .mean_burst = 1e9, .end = 0.4, .more = {}});
  add("particles.diameter=70um", {.diameter = "70 um", .mean_burst = 1e9, .end = 2, .more = {}});
  std::filesystem::create_directories(root() / "particles.diameter=22um");
  const json trend = statistics().at("trend");
  const json& fit = trend.at("series")[0].at("mean_burst");
  EXPECT_EQ(fit.at("points"), 3);
  expect_inside(fit.at("b"), 0.05, 0.015);
  for (const json& point : trend.at("points")) {
    const json& mean = point.at("mean_burst");
    const double ratio = point.at("x");
    if (ratio > 1.5 && ratio < 5) continue;
    EXPECT_EQ(mean.at("status"), "lower bound");
    EXPECT_EQ(mean.at("stops"), 0);
    EXPECT_TRUE(mean.at("value").is_null() && mean.at("high").is_null());
    const double passages = mean.at("passages");
    EXPECT_GT(passages, 300);
    EXPECT_NEAR(mean.at("low").get<double>(), passages / 3, 0.01 * passages);
    EXPECT_EQ(point.at("alpha").at("status"), "no arrest");
  }
  // The law at D/d = 10 is far above what was seen there; at 1.43 it is far below.
  ASSERT_EQ(fit.at("left_out").size(), 2U);
  EXPECT_FALSE(fit.at("left_out")[0].at("agrees").get<bool>());
  EXPECT_TRUE(fit.at("left_out")[1].at("agrees").get<bool>());
  EXPECT_THAT(trend.at("without_runs"), ElementsAre("particles.diameter=22um"));
}

TEST_F(Sweeps, a_neck_that_blocks_is_shown_but_belongs_to_no_law) {
  const auto add_released = [&](int diameter_um, double mean_burst, double empty) {
    add(fmt::format("particles.diameter={}um", diameter_um), {.diameter = fmt::format("{} um", diameter_um),
                                                              .protocol = "release",
                                                              .mean_burst = mean_burst,
                                                              .end = 8,
                                                              .empty = empty,
                                                              .more = {},
                                                              .overrides = {"unclog.after=50 ms"}});
  };
  for (const int diameter : {50, 40, 33}) add_released(diameter, 3 * std::exp(0.05 * std::pow(100.0 / diameter, 3)), 0);
  // Three quarters of the releases let nothing pass; the bursts that are not empty have more particles than the law.
  add_released(70, 8, 0.75);
  const json trend = statistics().at("trend");
  const json& fit = trend.at("series")[0].at("mean_burst");
  EXPECT_EQ(fit.at("points"), 3);
  expect_inside(fit.at("b"), 0.05, 0.015);
  const json& blocked = trend.at("points")[0];  // by D/d
  EXPECT_EQ(blocked.at("mean_burst").at("status"), "mostly empty");
  expect_inside(blocked.at("mean_burst"), 8, 2);
  ASSERT_EQ(fit.at("left_out").size(), 1U);
  EXPECT_EQ(fit.at("left_out")[0].at("group"), 0);
  EXPECT_FALSE(fit.at("left_out")[0].contains("agrees"));
}

TEST_F(Sweeps, any_other_key_and_what_follows_from_it) {
  for (const char* rolling : {"0.2", "0.4", "0.8"})
    add(std::string("contact.friction.rolling=") + rolling,
        {.mean_burst = 20 * std::exp(-2 * std::stod(rolling)),
         .end = 4,
         .more = {},
         .overrides = {std::string("contact.friction.rolling=") + rolling}});
  const json all = statistics();
  const json& trend = all.at("trend");
  EXPECT_EQ(trend.at("keys"), json({"contact.friction.rolling"}));
  EXPECT_THAT(all.at("sweep").get<std::vector<std::string>>(), Contains("contact.wall_friction.rolling"));
  EXPECT_EQ(all.at("groups")[0].at("label"), "D/d = 3.03, friction.rolling = 0.2");
  EXPECT_EQ(trend.at("points")[2].at("x"), 0.8);
  const json& fit = trend.at("series")[0].at("mean_burst");
  EXPECT_EQ(fit.at("x"), "contact.friction.rolling");
  expect_inside(fit.at("b"), -2, 0.6);
  EXPECT_FALSE(fit.contains("rivals"));
}

TEST_F(Sweeps, angles_in_degrees_and_radians) {
  for (const char* angle : {"30", "60"})
    add(std::string("geometry.half_angle=") + angle + "deg",
        {.end = 1, .more = {}, .overrides = {std::string("geometry.half_angle=") + angle + " deg"}});
  const json trend = statistics().at("trend");
  EXPECT_EQ(trend.at("variable").at("unit"), "rad");
  EXPECT_NEAR(trend.at("points")[0].at("x").get<double>(), 0.5235988, 1e-7);
  EXPECT_EQ(trend.at("points")[0].at("values").at("geometry.half_angle"), "30 deg");
  EXPECT_EQ(trend.at("series")[0].at("mean_burst").at("refused"), "2 points (a line needs 3)");
}

TEST_F(Sweeps, words_have_no_law) {
  for (const char* lookup : {"nearest", "trilinear"})
    add(std::string("flow.lookup=") + lookup,
        {.end = 1, .more = {}, .overrides = {std::string("flow.lookup=") + lookup}});
  const json trend = statistics().at("trend");
  EXPECT_FALSE(trend.at("variable").at("numeric").get<bool>());
  EXPECT_EQ(trend.at("points")[1].at("x"), 1);
  EXPECT_EQ(trend.at("series")[0].at("mean_burst").at("refused"), "flow.lookup is no number");
}

TEST_F(Sweeps, a_second_key_makes_series) {
  for (const char* rolling : {"0.3", "0.6"})
    for (const char* diameter : {"50", "33"})
      add(std::string("contact.friction.rolling=") + rolling + ",particles.diameter=" + diameter + "um",
          {.diameter = std::string(diameter) + " um",
           .end = 0.5,
           .more = {},
           .overrides = {std::string("contact.friction.rolling=") + rolling}});
  const json trend = statistics().at("trend");
  ASSERT_EQ(trend.at("series").size(), 2U);
  EXPECT_EQ(trend.at("series")[0].at("label"), "friction.rolling = 0.3");
  EXPECT_EQ(trend.at("series")[1].at("label"), "friction.rolling = 0.6");
  EXPECT_EQ(trend.at("points").size(), 4U);
  EXPECT_THAT(text("points.csv"), HasSubstr("\"D/d = 2, friction.rolling = 0.3\",0,2,"));
}

TEST_F(Sweeps, releases_cut_the_arrests_but_not_the_bursts) {
  add("particles.diameter=33um", {.protocol = "release", .mean_burst = 6, .end = 8, .more = {}});
  const json all = statistics();
  const json& point = all.at("trend").at("points")[0];
  EXPECT_EQ(point.at("alpha").at("status"), "upper bound");
  EXPECT_LT(point.at("alpha").at("high").get<double>(), 1.01);
  const json& mean = point.at("mean_burst");
  EXPECT_NEAR(value(mean), 6, 0.7);
  EXPECT_EQ(mean.at("stops"), all.at("groups")[0].at("bursts").at("counted").get<int>() + 4);
  EXPECT_EQ(value(mean), value(all.at("groups")[0].at("quantities").at("mean_burst_memoryless")));
}

TEST_F(Sweeps, the_table_has_a_row_a_point_and_units) {
  add_lawful(50);
  add_lawful(33);
  statistics();
  const std::string table = text("points.csv");
  EXPECT_THAT(table, StartsWith("group,label,series,D/d [1],particles.diameter,runs,"));
  EXPECT_THAT(table, AllOf(HasSubstr("\n0,\"D/d = 2\",0,2,\"50 um\",4,32,"), HasSubstr("\n1,\"D/d = 3.03\",0,3.03"),
                           HasSubstr(",\"measured\",")));
  const auto lines = std::count(table.begin(), table.end(), '\n');
  EXPECT_EQ(lines, 3);
}

}  // namespace
}  // namespace clogflow::postprocess
