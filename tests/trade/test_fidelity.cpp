// From studies to presets, and from presets to keys of a scene.
#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "coupling/base/source_folder.hpp"
#include "coupling/base/text_file.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/scratch.hpp"
#include "trade/fidelity.hpp"
#include "trade/knobs.hpp"
#include "trade/response.hpp"
#include "trade/results.hpp"
#include "trade/study_file.hpp"

namespace clogflow::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using namespace clogflow::trade;

const std::filesystem::path paper = clogflow::source_folder() / "scenes" / "paper.toml",
                            campaign = clogflow::source_folder() / "scenes" / "campaign.toml";

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

}  // namespace
}  // namespace clogflow::test
