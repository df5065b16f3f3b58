// The law through the settings of a study, on numbers that follow one.
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "coupling/base/source_folder.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/scratch.hpp"
#include "trade/response.hpp"
#include "trade/results.hpp"
#include "trade/study_file.hpp"

namespace clogflow::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using namespace clogflow::trade;

const std::filesystem::path paper = clogflow::source_folder() / "scenes" / "paper.toml";

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

}  // namespace
}  // namespace clogflow::test
