// The study at a toy budget, its rules on made-up numbers, and what the program does with its result.
#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "coupling/base/source_folder.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/files/run_file.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/faults/small_channel.hpp"
#include "trade/fidelity.hpp"
#include "trade/knobs.hpp"
#include "trade/observables.hpp"
#include "trade/response.hpp"
#include "trade/results.hpp"
#include "trade/sample.hpp"
#include "trade/study_file.hpp"

namespace clogflow::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using namespace clogflow::trade;

const std::filesystem::path paper = clogflow::source_folder() / "scenes" / "paper.toml",
                            campaign = clogflow::source_folder() / "scenes" / "campaign.toml";

/// Twenty pieces with 10 bursts each, of sizes that waver by `spread` around `mean`.
Sample bursts_of(double mean, double spread) {
  Sample sample;
  for (int k = 0; k < 20; ++k) {
    Piece piece;
    piece.seed = 1 + k / 5, piece.number = k % 5;
    piece.sizes.assign(10, mean + (k % 2 ? spread : -spread));
    sample.pieces.push_back(piece);
  }
  return sample;
}

const Observable& named(const std::string& key) { return *std::ranges::find(observables(), key, &Observable::key); }

double value(const char* key, const Pieces& pieces, double usual = 0) {
  return named(key).value(named(key), pieces, usual);
}

TEST(TradeCompare, ProvesEqualityByAnIntervalAlone) {
  const Difference clear = compare(named("mean_burst"), bursts_of(8, 1), bursts_of(10, 1));
  EXPECT_DOUBLE_EQ(clear.reference, 8);
  EXPECT_DOUBLE_EQ(clear.value, 10);
  EXPECT_NEAR(clear.difference, 0.25, 1e-12);
  EXPECT_TRUE(clear.real());
  EXPECT_LT(clear.low, 0.25);
  EXPECT_GT(clear.high, 0.25);
  EXPECT_EQ(clear.within(), clear.high);
  // Pieces out of step: the differences of the pairs are +-4 around a mean of 0.2.
  Sample noisy = bursts_of(8.2, -2);
  const Difference unclear = compare(named("mean_burst"), bursts_of(8, 2), noisy);
  EXPECT_NEAR(unclear.difference, 0.025, 1e-12);
  EXPECT_FALSE(unclear.real());
  EXPECT_GT(unclear.within(), 0.1);  // nothing is seen, and nothing near equality is proved
  EXPECT_EQ((Difference{.low = -0.04, .high = 0.01}).within(), 0.04);
  EXPECT_TRUE(std::isinf(compare(named("mean_burst"), Sample{}, Sample{}).within()));
}

TEST(TradeCompare, ObservesWhatUsersPublish) {
  Piece one, two;
  one.totals.arrests = 5, one.totals.censored = 1, one.totals.log_exposure = 6;
  two.totals.arrests = 3, two.totals.censored = 1, two.totals.log_exposure = 6;
  EXPECT_EQ(value("alpha", {&one, &two}), 1.5);
  EXPECT_EQ(value("share_censored", {&one, &two}), 0.25);
  EXPECT_TRUE(std::isnan(value("mean_burst", {&one, &two})));
  one.sizes = {0, 4, 9}, two.sizes = {7}, two.totals.cut_off_escaped = 4;
  EXPECT_EQ(value("mean_burst", {&one, &two}), 24 / 4.0);
  EXPECT_EQ(value("early_clogs", {&one, &two}, 4), 0.5);
  one.contacts_at_rest = {9, 2}, two.contacts_at_rest = {3, 1};
  EXPECT_EQ(value("coordination", {&one, &two}), 4);
  two.packing_while_flowing = {0.8, 2};
  EXPECT_EQ(value("packing_near_neck", {&one, &two}), 0.4);
  EXPECT_EQ(usual_burst({.pieces = {one, two}}), 7);
}

TEST(TradeCompare, UsesAllOfBothAndDrawsPairsTogether) {
  Sample half = bursts_of(10, 0);
  half.pieces.resize(5);
  half.pieces[0].sizes.assign(10, 6);
  const Difference d = compare(named("mean_burst"), bursts_of(8, 1), half);
  EXPECT_DOUBLE_EQ(d.reference, 8);
  EXPECT_DOUBLE_EQ(d.value, (4 * 100 + 60) / 50.0);
  EXPECT_TRUE(std::isnan(compare(named("mean_burst"), bursts_of(8, 0), Sample{}).difference));
  // The same waver in both cancels where pairs are drawn together: a tenth more stays exactly a tenth more.
  const Difference paired = compare(named("mean_burst"), bursts_of(10, 5), bursts_of(11, 5.5));
  EXPECT_NEAR(paired.low, 0.1, 1e-12);
  EXPECT_NEAR(paired.high, 0.1, 1e-12);
  // The error of a mean of 20 independent pieces that are 1 off: 1/sqrt(20), of its logarithm a mean-th of that.
  EXPECT_NEAR(spread_of(named("mean_burst"), bursts_of(8, 1), 0).error, 1 / std::sqrt(20) / 8, 0.002);
}

/// A run of ten Stokes times: three pass about 1 tau, then nothing until two pass about 6 tau, then nothing.
RunData ten_stokes_times() {
  const Scene scene = small_channel({"inlet.start=filled"});
  const double tau = scene.stokes_time();
  RunData run;
  run.seed = 3;
  run.scene_text = effective_scene(scene);
  run.end_time = 10 * tau;
  run.record.fill_time = 0;
  run.record.particle_steps = 1e6;
  run.record.processor_time = 4;
  run.record.time_step = 0.3, run.record.contact_limit = 0.5;
  for (const double t : {1.0, 1.2, 1.4, 6.0, 6.2}) {
    run.passages.time.push_back(t * tau);
    run.passages.id.push_back(static_cast<std::int64_t>(run.passages.id.size()));
    run.passages.y.push_back(0), run.passages.z.push_back(0), run.passages.friction_off.push_back(0);
  }
  // Before the first passage, flowing, too early in an arrest, late in it, flowing, late in the next.
  for (const double t : {0.5, 1.1, 3.0, 4.0, 6.1, 9.0}) {
    const auto k = static_cast<std::int64_t>(run.series.time.size());
    run.series.time.push_back(t * tau);
    run.series.count.push_back(10);
    run.series.contacts.push_back(10 + k);
    run.series.porosity.push_back({0.9, 0.9, 0.5 + 0.01 * static_cast<double>(k)});
    for (auto* column : {&run.series.packing_fraction, &run.series.kinetic_energy, &run.series.elastic_energy,
                         &run.series.largest_overlap, &run.series.drag_work, &run.series.dissipated,
                         &run.series.median_speed, &run.series.speed_q99})
      column->push_back(0);
    run.series.wall_contacts.push_back(0);
  }
  return run;
}

TEST(TradeSample, TakesPackingFromTheFlowAndContactsFromTheClog) {
  const ScratchFolder scratch;
  write_run_file(ten_stokes_times(), scratch.path() / "run_0003.h5");
  const Sample sample = read_sample(scratch.path());
  RowMean packing, contacts;
  double passages = 0;
  for (const Piece& piece : sample.pieces) {
    packing.sum += piece.packing_while_flowing.sum, packing.rows += piece.packing_while_flowing.rows;
    contacts.sum += piece.contacts_at_rest.sum, contacts.rows += piece.contacts_at_rest.rows;
    passages += piece.totals.passages;
  }
  EXPECT_EQ(passages, 5);
  EXPECT_EQ(packing.rows, 2);
  EXPECT_NEAR(packing.sum, (1 - 0.51) + (1 - 0.54), 1e-12);  // of the last strip
  EXPECT_EQ(contacts.rows, 2);
  EXPECT_NEAR(contacts.sum, 2 * 1.3 + 2 * 1.5, 1e-12);  // each contact is one of two particles
  EXPECT_EQ(sample.processor_seconds, 4);
  EXPECT_DOUBLE_EQ(sample.mean_step, 0.6);
  EXPECT_DOUBLE_EQ(sample.largest_step, 0.6);
}

TEST(TradeSample, SaysWhatARecordLacks) {
  const ScratchFolder scratch;
  RunData run = ten_stokes_times();
  run.record.processor_time.reset();
  write_run_file(run, scratch.path() / "run_0003.h5");
  EXPECT_THAT(refusal([&] { read_sample(scratch.path()); }),
              HasSubstr("run_0003.h5: its record has no processor_time_s (made by another program?)"));
}

/// Settings whose burst follows exp(2 + 0.1 softness - 0.2 mass) to an error of 1 %.
std::vector<Answer> lawful_answers() {
  std::vector<Answer> answers;
  for (const Doses& d : {Doses{0.02, 0.03, 0.2}, {1, 1, 0.7}, {4.6, 1, 0.7}, {1, 10, 0.7}, {1, 1, 0.2}, {2.2, 3, 0.8}})
    answers.push_back({d, {std::exp(2 + 0.1 * d.softness - 0.2 * d.mass), 0.01}});
  return answers;
}

TEST(TradeResponse, FindsTheLawAndWhatItSaysOfASetting) {
  std::vector<Answer> answers = lawful_answers();
  const Response r = fit_response(answers, false);
  EXPECT_NEAR(r.slope[0], 0.1, 1e-12);
  EXPECT_NEAR(r.slope[1], -0.2, 1e-12);
  EXPECT_NEAR(r.slope[2], 0, 1e-12);
  EXPECT_NEAR(r.chi_squared, 0, 1e-9);
  EXPECT_EQ(r.degrees_of_freedom, 2);
  EXPECT_NEAR(r.high[0] - r.slope[0], 1.96 * r.error[0], 1e-12);
  // 10 MPa and mass x 30 against 3 GPa and the true mass: softness 1 - 300^(-2/3) = 0.9777, mass 1 - 1/30.
  const Difference d = r.from_paper({1, 1, 0}, false);
  EXPECT_NEAR(d.difference, std::expm1(0.1 * 0.97769 - 0.2 * 29 / 30.0), 1e-5);
  EXPECT_LT(d.low, d.difference);
  EXPECT_LT(d.difference, d.high);
  // Settings off the law by 8 errors make wider intervals.
  answers[1].spread.value *= 1.08;
  const Response off = fit_response(answers, false);
  EXPECT_LT(off.p_value, 0.01);
  EXPECT_NEAR(off.error[2], r.error[2] * std::sqrt(off.chi_squared / 2), 1e-9);
  EXPECT_GT(off.from_paper({1, 1, 0}, false).within(), d.within());
}

// Contacts go with the root of the overlap: 1, then twice as many at a softness of 4 (an eighth of the modulus).
TEST(TradeResponse, TakesTheSoftnessToAPower) {
  std::vector<Answer> answers = lawful_answers();
  for (Answer& a : answers) a.spread.value = std::exp(0.1 * std::sqrt(a.doses.softness));
  const Response r = fit_response(answers, false, {}, 0.5);
  EXPECT_NEAR(r.slope[0], 0.1, 1e-9);
  EXPECT_NEAR(r.from_paper({4, 1.0 / 30, 0}, false).difference, std::expm1(0.1 * (2 - std::pow(300, -1.0 / 3))), 1e-9);
}

TEST(TradeResponse, TakesTheStepFromAnotherStudy) {
  std::vector<Answer> answers = lawful_answers();
  answers.resize(4);
  for (Answer& a : answers) a.doses.step = 0.5;
  const Response r = fit_response(answers, false, KnownSlope{0.3, 0.02});
  EXPECT_NEAR(r.slope[2], 0.3, 1e-9);
  EXPECT_NEAR(r.error[2], 0.02, 1e-9);
  EXPECT_EQ(r.degrees_of_freedom, 1);
  // A study that has a step of its own weighs both: errors of e and e make e / sqrt(2).
  const Response own = fit_response(lawful_answers(), false);
  const Response both = fit_response(lawful_answers(), false, KnownSlope{0, own.error[2]});
  EXPECT_NEAR(both.error[2], own.error[2] / std::sqrt(2), 1e-9);
}

TEST(TradeResponse, ReadsTheStepOfAStudyOrSaysWhyNot) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "trade.json";
  const Scene scene = read_scene(paper, {});
  StudyResults results{.scene = effective_scene(scene)};
  results.responses["mean_burst"] = fit_response(lawful_answers(), false);
  std::ofstream(file) << study_text(results);
  const auto slopes =
      read_step_slopes(file, read_scene(paper, {"particles.diameter=25 um", "particles.size_spread=0.03"}));
  ASSERT_EQ(slopes.size(), 1u);
  EXPECT_NEAR(slopes.at("mean_burst").value, 0, 1e-12);
  EXPECT_EQ(slopes.at("mean_burst").error, results.responses["mean_burst"].error[2]);
  EXPECT_THAT(refusal([&] { read_step_slopes(file, read_scene(paper, {"contact.friction.sliding=0.5"})); }),
              HasSubstr("is of another scene (contact.friction.sliding = 0.6, now 0.5)"));
  results.responses.clear();
  std::ofstream(file) << study_text(results);
  EXPECT_THAT(refusal([&] { read_step_slopes(file, scene); }), HasSubstr("this study found no response to the step"));
  json damaged = json::parse(study_text(results));
  damaged["responses"]["mean_burst"]["step"] = 3;
  std::ofstream(file) << damaged;
  EXPECT_THAT(refusal([&] { read_step_slopes(file, scene); }), HasSubstr("not a trade.json of clog trade, or damaged"));
}

TEST(TradeResponse, RefusesSettingsThatCannotTell) {
  std::vector<Answer> answers = lawful_answers();
  for (Answer& a : answers) a.doses.step = 0.7;
  EXPECT_THAT(refusal([&] { fit_response(answers, false); }), HasSubstr("do not tell softness, mass and step apart"));
  answers[2].spread.value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal([&] { fit_response(answers, false); }), HasSubstr("a setting has no value with an error"));
  answers.resize(4);
  EXPECT_THAT(refusal([&] { fit_response(answers, false); }), HasSubstr("4 settings cannot show"));
}

TEST(TradeResponse, DosesAreOneAtTheBase) {
  const Scene base = read_scene(paper, {"contact.youngs_modulus=10 MPa", "time.mass_scale=30"});
  EXPECT_NEAR(doses_of(base, 0.7).softness, 1, 1e-12);
  EXPECT_NEAR(doses_of(base, 0.7).step, 0.49, 1e-12);
  EXPECT_EQ(doses_of(base, 0.7).mass, 1);
  EXPECT_TRUE(is_small(doses_of(base, 0.7)));
  EXPECT_FALSE(is_small(doses_of(read_scene(paper, {"time.mass_scale=31"}), 0.7)));
  const Scene soft = read_scene(paper, {"contact.youngs_modulus=1.25 MPa"});
  EXPECT_NEAR(doses_of(soft, 0.7).softness, 4, 1e-12);  // 8^(2/3)
}

Measured seen(const char* name, double seconds, double within, double step = 0.5) {
  return {
      .name = name, .overrides = {"time.mass_scale=2"}, .seconds = seconds, .within = within, .step_over_limit = step};
}

TEST(TradePresets, AreTheCheapestWithinTheirTolerance) {
  const std::vector<Measured> settings{seen("a", 9, 0.01), seen("b", 1, 0.09), seen("c", 3, 0.05), seen("d", 0.5, 0.2),
                                       seen("near the limit", 0.1, 0.01, 0.91)};
  EXPECT_EQ(presets_of(settings), (Presets{{"standard", "c"}, {"fast", "b"}}));
  EXPECT_EQ(cheapest_within(settings, 0.049)->name, "a");
  EXPECT_EQ(cheapest_within(settings, 0.001), nullptr);
  EXPECT_TRUE(presets_of({seen("far", 1, 0.3)}).empty());
}

TEST(TradePresets, AreThoseOfTheNextLargerRatio) {
  const std::vector<MeasuredStudy> studies{{.neck_ratio = 2.128}, {.neck_ratio = 3.03}, {.neck_ratio = 4}};
  const auto ratio_for = [&](const Overrides& overrides) {
    return study_for(studies, read_scene(paper, overrides)).neck_ratio;
  };
  EXPECT_EQ(ratio_for({"particles.diameter=80 um"}), 2.128);
  EXPECT_EQ(ratio_for({"particles.diameter=47 um"}), 2.128);
  EXPECT_EQ(ratio_for({"particles.diameter=40 um"}), 3.03);
  EXPECT_EQ(ratio_for({"particles.diameter=33 um"}), 3.03);
  EXPECT_EQ(ratio_for({"particles.diameter=22 um"}), 4);
}

StudyResults one_setting() {
  StudyResults results{.scene = "", .diameter = 1, .neck_ratio = 2, .reference = "a"};
  results.settings.push_back(
      {.setting = {.name = "a"}, .cost = Cost{.seconds = 1, .particle_steps = 1}, .gain = 1, .within = 0.02});
  return results;
}

TEST(TradePresets, RefuseWhatIsNoStudy) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "trade.json";
  const std::string whole = study_text(one_setting());
  json nameless = json::parse(whole), worded = nameless;
  nameless["settings"][0].erase("name");
  worded["settings"][0]["seconds_per_clog"] = "much";
  for (const std::string& text : {nameless.dump(), worded.dump(), std::string("[1]"), std::string("{\"format\": 7}"),
                                  std::string(100'000, '['), std::string("no JSON")}) {
    std::ofstream(file) << text;
    EXPECT_THAT(refusal([&] { read_study(file); }),
                HasSubstr("trade.json: not a trade.json of clog trade, or damaged"));
  }
  std::ofstream(file) << R"({"format": "clogflow trade 1", "settings": []})";
  EXPECT_THAT(refusal([&] { read_study(file); }), HasSubstr("\"clogflow trade 1\" was made by another version"));
  std::ofstream(file) << whole;
  const MeasuredStudy study = read_study(file);
  EXPECT_EQ(study.neck_ratio, 2);
  ASSERT_EQ(study.settings.size(), 1u);
  EXPECT_EQ(study.settings[0].seconds, 1);
  EXPECT_EQ(study.settings[0].within, 0.02);
  EXPECT_EQ(study.presets, (Presets{{"standard", "a"}, {"fast", "a"}}));
}

TEST(TradePresets, AreThoseOfTheCommittedStudies) {
  const auto root = clogflow::source_folder();
  std::vector<MeasuredStudy> studies;
  for (const char* name : {"d25.json", "d33.json", "d47.json"})
    studies.push_back(read_study(root / "docs" / "reports" / "trade" / name));
  const std::string committed = read_text_file(root / "trade" / "measured.json");
  EXPECT_EQ(measured_text(studies), committed);
  EXPECT_EQ(measured_text(measured_studies()), committed);
  EXPECT_TRUE(std::ranges::is_sorted(measured_studies(), {}, &MeasuredStudy::neck_ratio));
  // Masses at which the law does not hold were run, and are no choice.
  for (const MeasuredStudy& study : measured_studies())
    for (const Measured& setting : study.settings)
      EXPECT_TRUE(is_small(doses_of(read_scene(paper, setting.overrides), 0))) << setting.name;
}

TEST(Fidelity, APresetBecomesKeysAndTheCommandLineWins) {
  const MeasuredStudy& study = study_for(measured_studies(), read_scene(paper, {}));
  for (const auto& [preset, name] : study.presets) {
    const ResolvedScene resolved = read_resolved_scene(paper, {"fidelity.preset=" + preset, "time.mass_scale=7"});
    EXPECT_EQ(resolved.scene.time.mass_scale, 7);
    EXPECT_TRUE(resolved.scene.fidelity.preset.empty());
    EXPECT_THAT(resolved.note, HasSubstr("setting " + name + ", within"));
    const auto setting = std::ranges::find(study.settings, name, &Measured::name);
    ASSERT_NE(setting, study.settings.end());
    Overrides keys = setting->overrides;
    keys.emplace_back("time.mass_scale=7");
    EXPECT_EQ(effective_scene(resolved.scene), effective_scene(read_scene(paper, keys)));
  }
  const ResolvedScene reference = read_resolved_scene(paper, {"fidelity.preset=reference"});
  EXPECT_EQ(reference.scene.contact.youngs_modulus, 3e9);
  EXPECT_EQ(reference.scene.time.mass_scale, 1);
  EXPECT_THAT(reference.note, HasSubstr("setting gpa3"));
}

TEST(Fidelity, AToleranceChoosesTheCheapestWithinIt) {
  const MeasuredStudy& study = study_for(measured_studies(), read_scene(paper, {}));
  const ResolvedScene resolved = read_resolved_scene(paper, {"fidelity.tolerance=0.1"});
  EXPECT_THAT(resolved.note, HasSubstr("setting " + study.presets.at("fast") + ","));
  EXPECT_EQ(resolved.scene.fidelity.tolerance, 0);
  EXPECT_EQ(read_resolved_scene(paper, {}).note, "");
  EXPECT_THAT(read_resolved_scene(paper, {"fidelity.tolerance=0.1", "particles.diameter=15 um"}).note,
              HasSubstr("(nothing was measured at a larger one)"));
  EXPECT_THAT(refusal([] { read_resolved_scene(paper, {"fidelity.tolerance=1e-4"}); }),
              HasSubstr("(no setting was measured to be so near at D/d = "));
}

TEST(Fidelity, SaysForWhichSceneNothingWasMeasured) {
  const auto note = [](Overrides keys) {
    keys.emplace_back("fidelity.preset=fast");
    return read_resolved_scene(campaign, keys).note;
  };
  EXPECT_THAT(note({"particles.diameter=47 um", "geometry.neck_width=90 um", "contact.youngs_modulus=1 GPa"}),
              Not(HasSubstr("not measured for this scene")));
  EXPECT_THAT(note({"unclog.protocol=stop"}), Not(HasSubstr("not measured for this scene")));
  EXPECT_THAT(note({"unclog.protocol=release", "unclog.after=9 ms"}),
              HasSubstr("(not measured for this scene: the study had unclog.protocol"));
  EXPECT_THAT(
      note({"contact.friction.sliding=0.4", "drag.law=stokes"}),
      HasSubstr("(not measured for this scene: the study had contact.friction.sliding = 0.6, now 0.4, drag.law = "
                "\"hoef\", now \"stokes\")"));
  EXPECT_THAT(note({"geometry.half_angle=45 deg", "contact.friction.rolling=0", "contact.friction.torsion=0",
                    "contact.restitution=0.5"}),
              testing::AllOf(HasSubstr("geometry.half_angle = "), HasSubstr(" and 1 more)")));
}

TEST(Fidelity, RefusesWhatItDoesNotKnow) {
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

TEST_F(ToyStudy, RefusesASettingThatItDoesNotKnow) {
  study_.only = {"gpa3", "cheapest"};
  EXPECT_THAT(refusal([this] { evaluate(0); }), HasSubstr("--settings cheapest (no such setting)"));
}

}  // namespace
}  // namespace clogflow::test
