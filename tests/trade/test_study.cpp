// A study at a toy budget: what it runs, refuses and reports.
#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/coupling/refusal.hpp"
#include "tests/faults/small_channel.hpp"
#include "trade/results.hpp"
#include "trade/study_file.hpp"

namespace clogflow::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using namespace clogflow::trade;

/// A study of the small channel.
class ToyStudy : public testing::Test {
protected:
  ToyStudy() : scene_(small_channel({"time.end=6 ms", "ensemble.seeds=[1]"})), flow_(synthetic_flow(scene_)) {
    std::ofstream(folder_ / "toy.toml") << effective_scene(scene_);
    study_ = {folder_ / "toy.toml", {}, &flow_, folder_ / "toy", 0, nullptr, {"base_tau50", "10MPa_m30_limit70"}};
  }
  ~ToyStudy() override { std::filesystem::remove_all(folder_ / "toy"); }

  StudyResults evaluate(double budget) {
    study_.budget = budget;
    Ranks ranks;
    check_runs(study_);
    run_study(study_, ranks, [this](const std::string& line) { said_.push_back(line); });
    return study_results(study_);
  }

  std::filesystem::path folder_ = scratch_folder();
  Scene scene_;
  FlowGrid flow_;
  Study study_;
  std::vector<std::string> said_;
};

TEST_F(ToyStudy, ReportsWhatItRanAndWhatItDidNotAndGoesOn) {
  const StudyResults nothing = evaluate(0);
  EXPECT_EQ(nothing.reference, "");
  EXPECT_TRUE(nothing.presets.empty());
  for (const SettingResult& outcome : nothing.settings) EXPECT_FALSE(outcome.cost) << outcome.setting.name;
  const json said_of_nothing = json::parse(study_text(nothing));
  for (const json& setting : said_of_nothing["settings"]) EXPECT_TRUE(setting["not_run"]) << setting;

  // A run that the budget cuts goes on in the next call: on a busy machine it takes several.
  StudyResults some = nothing;
  for (int calls = 0; calls < 20 && some.reference.empty(); ++calls) some = evaluate(1 + calls);
  EXPECT_EQ(some.reference, "base_tau50");
  const auto setting = [&](const char* name) {
    return *std::ranges::find_if(some.settings, [&](const SettingResult& o) { return o.setting.name == name; });
  };
  EXPECT_FALSE(setting("gpa3").cost);
  const SettingResult reference = setting("base_tau50");
  for (const auto& [key, d] : reference.differences) {
    EXPECT_TRUE(std::isnan(d.difference) || d.difference == 0.0) << key << " " << d.difference;
    EXPECT_FALSE(d.real()) << key;
  }
  EXPECT_THAT(some.no_response, HasSubstr("settings cannot show"));
  EXPECT_TRUE(json::parse(study_text(some)).contains("no_response"));
  // The grid made coarser is seen in the forces, the same grid is not; half a step errs less than a full one.
  std::map<std::string, ShortRun> brief;
  for (const ShortRun& run : some.short_runs) brief[run.name] = run;
  EXPECT_EQ(brief["tau100"].force, 0.0);
  EXPECT_GT(brief["grid x 4"].force, 0.005);
  EXPECT_LT(brief["tau200"].path, 0.5 * brief["base_tau50"].path);
  EXPECT_THAT(table(some), HasSubstr("not run\n"));

  // Stiffer and lighter particles cost more steps: tau, which the step is a share of, goes as (m^2 / E^2)^(1/5) at
  // equal speed of impact. \source Hertz
  EXPECT_NEAR(brief["gpa3"].particle_steps / brief["base_tau50"].particle_steps, std::pow(300 * 30, 0.4), 1.5);

  // Nothing is run twice.
  const std::size_t lines = said_.size();
  evaluate(0);
  for (std::size_t k = lines; k < said_.size(); ++k) EXPECT_THAT(said_[k], HasSubstr("already done"));
}

TEST_F(ToyStudy, RefusesRunsOfAnotherSceneAndOfALongerOne) {
  study_.only = {"10MPa_m30_limit70"};
  const auto runs = folder_of(study_, {.name = "10MPa_m30_limit70"});
  for (int calls = 0; calls < 20 && !std::filesystem::exists(runs / "run_0001.h5"); ++calls) evaluate(1 + calls);
  const auto asked_with = [&](const char* key) {
    study_.overrides = {key};
    return refusal([this] { evaluate(0); });
  };
  EXPECT_THAT(asked_with("contact.friction.sliding=0.3"),
              testing::AllOf(HasSubstr("run_0001.h5: was made for another scene (contact.friction.sliding"),
                             HasSubstr("give another --out")));
  EXPECT_THAT(asked_with("time.end=3 ms"), HasSubstr("run_0001.h5: is longer than what is asked for"));
  study_.overrides = {};
  study_.flow = nullptr;
  EXPECT_THAT(refusal([this] { evaluate(0); }),
              HasSubstr("toy.toml: flow.source = \"openfoam\" needs the flow: give --flow flow.h5"));
}

TEST_F(ToyStudy, TriesAgainWhatFailedForAReasonThatHasGone) {
  study_.only = {"10MPa_m30_limit70"};
  const Setting setting{.name = "10MPa_m30_limit70"};
  const auto state = folder_of(study_, setting) / "run_0001.state";
  std::filesystem::create_directories(state.parent_path());
  std::ofstream(state) << "clogflow state 7\nof an earlier program";
  const auto refused = [&] { return refusal_of(study_, setting); };
  for (int calls = 0; calls < 20 && refused().empty(); ++calls) evaluate(1);
  EXPECT_THAT(refused(), HasSubstr("run_0001.state"));
  evaluate(1);
  EXPECT_THAT(refused(), HasSubstr("run_0001.state"));  // it is still there
  EXPECT_THAT(table(evaluate(0)), HasSubstr("refused: "));

  std::filesystem::remove(state);
  for (int calls = 0; calls < 20 && !refused().empty(); ++calls) evaluate(1 + calls);
  EXPECT_EQ(refused(), "");
  EXPECT_TRUE(std::filesystem::exists(state.parent_path() / "run_0001.h5"));
}

TEST_F(ToyStudy, RefusesASettingThatItDoesNotKnow) {
  study_.only = {"gpa3", "cheapest"};
  EXPECT_THAT(refusal([this] { evaluate(0); }), HasSubstr("--settings cheapest (no such setting)"));
}

}  // namespace
}  // namespace clogflow::test
