// The study at a toy budget, its rules on made-up numbers, and what the program does with its result.
#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "coupling/base/source_folder.hpp"
#include "coupling/base/text_file.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/faults/small_channel.hpp"
#include "trade/fidelity.hpp"
#include "trade/knobs.hpp"
#include "trade/results.hpp"
#include "trade/sample.hpp"
#include "trade/study_file.hpp"

namespace clogflow::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using namespace clogflow::trade;

const std::filesystem::path paper = clogflow::source_folder() / "scenes" / "paper.toml";

/// Twenty pieces with 10 bursts each, of sizes that waver by `spread` around `mean`.
Sample bursts_of(double mean, double spread) {
  Sample sample;
  for (int k = 0; k < 20; ++k) {
    Piece piece;
    piece.seed = 1 + k / 5, piece.number = k % 5;
    piece.totals.bursts = 10;
    piece.totals.escaped = 10 * (mean + (k % 2 ? spread : -spread));
    sample.pieces.push_back(piece);
  }
  return sample;
}

const Observable& named(const std::string& key) { return *std::ranges::find(observables(), key, &Observable::key); }

TEST(TradeCompare, SeesADifferenceOnlyBeyondItsInterval) {
  const Difference clear = compare(named("mean_burst"), bursts_of(8, 1), bursts_of(10, 1));
  EXPECT_DOUBLE_EQ(clear.reference, 8);
  EXPECT_DOUBLE_EQ(clear.value, 10);
  EXPECT_NEAR(clear.difference, 0.25, 1e-12);
  EXPECT_TRUE(clear.real());
  EXPECT_LT(clear.low, 0.25);
  EXPECT_GT(clear.high, 0.25);
  // Pieces out of step: the differences of the pairs are +-4 around a mean of 0.2.
  Sample noisy = bursts_of(8.2, -2);
  const Difference unclear = compare(named("mean_burst"), bursts_of(8, 2), noisy);
  EXPECT_NEAR(unclear.difference, 0.025, 1e-12);
  EXPECT_FALSE(unclear.real());
}

TEST(TradeCompare, ObservesWhatTheStatisticsGive) {
  Piece one, two;
  one.totals.arrests = 5, one.totals.censored = 1, one.totals.log_exposure = 6;
  two.totals.arrests = 3, two.totals.censored = 1, two.totals.log_exposure = 6;
  EXPECT_EQ(named("alpha").value({&one, &two}), 1.5);
  EXPECT_EQ(named("share_censored").value({&one, &two}), 0.25);
  EXPECT_TRUE(std::isnan(named("share_failed").value({&one, &two})));
  one.samples = 2, one.coordination = 9, two.samples = 1, two.coordination = 3;
  EXPECT_EQ(named("coordination").value({&one, &two}), 4);
  for (const Observable& observable : observables())
    EXPECT_TRUE(observable.quantity || observable.rows) << observable.key << " is in no table";
}

TEST(TradeCompare, UsesAllOfBothAndDrawsPairsTogether) {
  Sample half = bursts_of(10, 0);
  half.pieces.resize(5);
  half.pieces[0].totals.escaped = 60;
  const Difference d = compare(named("mean_burst"), bursts_of(8, 1), half);
  EXPECT_DOUBLE_EQ(d.reference, 8);
  EXPECT_DOUBLE_EQ(d.value, (4 * 100 + 60) / 50.0);
  EXPECT_TRUE(std::isnan(compare(named("mean_burst"), bursts_of(8, 0), Sample{}).difference));
  // The same waver in both cancels where pairs are drawn together: a tenth more stays exactly a tenth more.
  const Difference paired = compare(named("mean_burst"), bursts_of(10, 5), bursts_of(11, 5.5));
  EXPECT_NEAR(paired.low, 0.1, 1e-12);
  EXPECT_NEAR(paired.high, 0.1, 1e-12);
}

Seen seen(const char* name, double gain, double error, double step = 0.5) {
  return {.measured = {.name = name,
                       .overrides = {"time.mass_scale=2"},
                       .gain = gain,
                       .error = error,
                       .hidden = 2 * error,
                       .step_over_limit = step},
          .is_numerics = true,
          .is_judged = true};
}

// b is cheap and good at one diameter and bad at the other, c is dear and good, d good and physics, e was
// run once, f too near the limit of its contacts at one diameter.
TEST(TradePresets, FollowTheirRuleOverAllStudies) {
  Seen d = seen("d", 90, 0), not_run = seen("e", 50, 0);
  d.is_numerics = not_run.is_judged = false;
  const StudySummary one{
      1, "a", {seen("a", 1, 0), seen("b", 8, 0.01), seen("c", 3, 0.04), d, seen("e", 50, 0), seen("f", 70, 0, 0.89)}};
  const StudySummary two{
      2, "a", {seen("a", 1, 0), seen("b", 6, 0.09), seen("c", 4, 0.05), d, not_run, seen("f", 70, 0, 0.91)}};
  const MeasuredSettings both = combine({one, two});
  EXPECT_EQ(both.presets, (Presets{{"reference", "a"}, {"standard", "c"}, {"fast", "b"}}));
  ASSERT_EQ(both.settings.size(), 4u);
  EXPECT_EQ(both.settings[1].gain, 6.0);
  EXPECT_EQ(both.settings[1].error, 0.09);
  EXPECT_EQ(both.settings[2].hidden, 0.1);
  EXPECT_EQ(cheapest_within(both.settings, 0.089).name, "c");
  EXPECT_THAT(refusal([] { cheapest_within({}, 0.01); }), HasSubstr("no setting was measured to be within 0.01"));
}

StudyResults one_setting() {
  StudyResults results{.scene = "", .diameter = 1, .reference = "a"};
  results.settings.push_back({.setting = {.name = "a"}, .cost = Cost{}, .gain = 1, .is_judged = true});
  return results;
}

TEST(TradePresets, RefuseWhatIsNoStudy) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "trade.json";
  const std::string whole = study_text(one_setting());
  json nameless = json::parse(whole), worded = nameless;
  nameless["settings"][0].erase("name");
  worded["settings"][0]["gain"] = "much";
  for (const std::string& text : {nameless.dump(), worded.dump(), std::string("[1]"), std::string("{\"format\": 7}"),
                                  std::string(100'000, '['), std::string("no JSON")}) {
    std::ofstream(file) << text;
    EXPECT_THAT(refusal([&] { read_study(file); }),
                HasSubstr("trade.json: not a trade.json of clog trade, or damaged"));
  }
  std::ofstream(file) << whole;
  const StudySummary summary = read_study(file);
  EXPECT_EQ(summary.reference, "a");
  ASSERT_EQ(summary.settings.size(), 1u);
  EXPECT_TRUE(summary.settings[0].is_judged && summary.settings[0].is_numerics);
  EXPECT_EQ(summary.settings[0].measured.gain, 1);
}

TEST(TradePresets, AreThoseOfTheCommittedStudy) {
  const auto root = clogflow::source_folder();
  std::vector<StudySummary> studies;
  for (const char* name : {"d50.json", "d33.json", "d25.json"})
    studies.push_back(read_study(root / "docs" / "reports" / "trade" / name));
  const std::string committed = read_text_file(root / "trade" / "measured.json");
  EXPECT_EQ(measured_text(combine(studies)), committed);
  EXPECT_EQ(measured_text(measured_settings()), committed);
}

TEST(Fidelity, APresetBecomesKeysAndTheCommandLineWins) {
  const Presets& presets = measured_settings().presets;
  for (const char* name : {"reference", "standard", "fast"}) {
    const ResolvedScene resolved =
        read_resolved_scene(paper, {std::string("fidelity.preset=") + name, "time.mass_scale=7"});
    EXPECT_EQ(resolved.scene.time.mass_scale, 7);
    EXPECT_TRUE(resolved.scene.fidelity.preset.empty());
    EXPECT_THAT(resolved.note, HasSubstr("setting " + presets.at(name) + ","));
    for (const Measured& setting : measured_settings().settings) {
      if (setting.name != presets.at(name)) continue;
      Overrides keys = setting.overrides;
      keys.emplace_back("time.mass_scale=7");
      EXPECT_EQ(effective_scene(resolved.scene), effective_scene(read_scene(paper, keys)));
    }
  }
}

TEST(Fidelity, AToleranceChoosesTheCheapestWithinIt) {
  const ResolvedScene resolved = read_resolved_scene(paper, {"fidelity.tolerance=0.05"});
  EXPECT_THAT(resolved.note, HasSubstr("setting " + measured_settings().presets.at("standard") + ","));
  EXPECT_EQ(resolved.scene.fidelity.tolerance, 0);
  EXPECT_EQ(read_resolved_scene(paper, {}).note, "");
}

TEST(Fidelity, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(read_resolved_scene(paper, {"fidelity.preset=fast", "drag.law=stokes"}).note,
              HasSubstr("(measured with drag.law = \"hoef\")"));
  for (const char* wish : {"fidelity.preset=fast", "fidelity.tolerance=0.05"})
    EXPECT_THAT(refusal([&] {
                  read_resolved_scene(paper, {wish, "contact.turning=mercury"});
                }),
                HasSubstr("nothing was measured with others"));
  EXPECT_THAT(refusal([] {
                settings_for(read_scene(paper, {"contact.law=hooke", "contact.stiffness=1 N/m"}));
              }),
              HasSubstr("clog trade: contact.law = \"hooke\""));
  EXPECT_THAT(refusal([] { read_resolved_scene(paper, {"fidelity.preset=best"}); }),
              HasSubstr("fidelity.preset = \"best\" (must be \"reference\", \"standard\" or \"fast\")"));
  EXPECT_THAT(refusal([] {
                read_resolved_scene(paper, {"fidelity.preset=fast", "fidelity.tolerance=0.1"});
              }),
              HasSubstr("(one of them decides): leave one out"));
}

/// A study of the small channel.
class ToyStudy : public testing::Test {
protected:
  ToyStudy() : scene_(small_channel({"time.end=6 ms", "ensemble.seeds=[1]"})), flow_(synthetic_flow(scene_)) {
    std::ofstream(folder_ / "toy.toml") << effective_scene(scene_);
    study_ = {folder_ / "toy.toml", {}, &flow_, folder_ / "toy", 0, nullptr, {"tau50", "cheap"}};
  }
  ~ToyStudy() override { std::filesystem::remove_all(folder_ / "toy"); }

  StudyResults evaluate(double budget) {
    study_.budget = budget;
    Ranks ranks;
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
  EXPECT_EQ(some.reference, "tau50");
  const auto setting = [&](const char* name) {
    return *std::ranges::find_if(some.settings, [&](const SettingResult& o) { return o.setting.name == name; });
  };
  EXPECT_FALSE(setting("gpa3").cost);
  const SettingResult reference = setting("tau50");
  for (const Observable& o : observables()) {
    const Difference& d = reference.differences.at(o.key);
    EXPECT_TRUE(std::isnan(d.difference) || d.difference == 0.0) << o.key << " " << d.difference;
    EXPECT_FALSE(d.real()) << o.key;
  }
  EXPECT_EQ(reference.gain, 1.0);

  // The grid made coarser is seen in the forces, the same grid is not; half a step errs less than a full one.
  std::map<std::string, ShortRun> brief;
  for (const ShortRun& run : some.short_runs) brief[run.name] = run;
  EXPECT_EQ(brief["tau100"].force, 0.0);
  EXPECT_GT(brief["grid x 4"].force, 0.005);
  EXPECT_LT(brief["tau200"].path, 0.5 * brief["tau50"].path);
  EXPECT_THAT(table(some), HasSubstr("not run\n"));

  // Stiffer particles cost more steps: tau, which the step is a share of, goes as E^(-2/5).
  EXPECT_NEAR(brief["gpa3"].particle_steps / brief["tau50"].particle_steps, std::pow(1000, 0.4), 0.5);

  // Nothing is run twice.
  const std::size_t lines = said_.size();
  evaluate(0);
  for (std::size_t k = lines; k < said_.size(); ++k) EXPECT_THAT(said_[k], HasSubstr("already done"));
}

TEST_F(ToyStudy, RefusesASettingThatItDoesNotKnow) {
  study_.only = {"cheap", "cheapest"};
  EXPECT_THAT(refusal([this] { evaluate(0); }), HasSubstr("--settings cheapest (no such setting)"));
}

}  // namespace
}  // namespace clogflow::test
