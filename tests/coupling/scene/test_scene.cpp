// What a scene means: values, defaults, overrides, and the way back to text.
#include <fstream>
#include <numbers>
#include <regex>

#include <gmock/gmock.h>

#include "coupling/base/content_hash.hpp"
#include "coupling/base/source_folder.hpp"
#include "coupling/scene/scene.hpp"
#include "coupling/scene/scene_draft.hpp"
#include "coupling/scene/scene_keys.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/coupling/scene/scene_texts.hpp"
#include "tests/scratch.hpp"

namespace clogflow {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::filesystem::path paper = clogflow::source_folder() / "scenes/paper.toml";

TEST(Scene, PaperHasThePapersValues) {
  const Scene scene = read_scene(paper);
  EXPECT_EQ(scene.geometry.neck_width, 100e-6);
  EXPECT_EQ(scene.geometry.channel_width, 400e-6);
  EXPECT_EQ(scene.geometry.channel_length, 1e-3);
  EXPECT_DOUBLE_EQ(scene.geometry.half_angle, std::numbers::pi / 3);
  EXPECT_EQ(scene.fluid.viscosity, 1.8e-3);
  EXPECT_EQ(scene.flow.mean_velocity, 5e-3);
  EXPECT_EQ(scene.particles.diameter, 33e-6);
  EXPECT_EQ(scene.particles.density, 1062);
  EXPECT_DOUBLE_EQ(scene.particles.roughness, 0.165e-6);
  EXPECT_EQ(scene.contact.youngs_modulus, 3e6);
  EXPECT_EQ(scene.contact.wall_friction.torsion, 0.6);
  EXPECT_EQ(scene.inlet.start, InletStart::flowing);
  EXPECT_EQ(scene.unclog.protocol, UnclogProtocol::restart);
  EXPECT_EQ(scene.inlet.strain, scene.unclog.strain);
  EXPECT_DOUBLE_EQ(scene.unclog.after, 33e-3);
  EXPECT_DOUBLE_EQ(scene.stokes_time(), 6.6e-3);
  EXPECT_EQ(scene.ensemble.seeds.size(), 40u);
}

TEST(Scene, DefaultsOfAChannel) {
  const Scene scene = parse_scene(channel, "scene");
  EXPECT_EQ(scene.geometry.neck_height, 100e-6);
  EXPECT_EQ(scene.geometry.channel_width, 400e-6);
  EXPECT_EQ(scene.geometry.channel_length, 10 * 100e-6);
  EXPECT_EQ(scene.geometry.neck_length, 100e-6);
  EXPECT_EQ(scene.flow.source, FlowSource::openfoam);
  EXPECT_EQ(scene.flow.lookup, Lookup::nearest);
  EXPECT_TRUE(scene.lubrication.enabled && scene.drag.enabled && scene.inlet.enabled);
  EXPECT_EQ(scene.lubrication.cutoff, 33e-6 / 2);
  EXPECT_EQ(scene.porosity.strips, 3);
  EXPECT_EQ(scene.contact.friction.rolling, 0);
  EXPECT_EQ(scene.contact.wall_friction.sliding, 0.6);
  EXPECT_EQ(scene.passages.plane, 50e-6);
  EXPECT_DOUBLE_EQ(scene.output.series_interval, 0.66e-3);
  EXPECT_DOUBLE_EQ(scene.unclog.after, 33e-3);
  EXPECT_NEAR(scene.unclog.duration, 1.5e-3, 0.02e-3) << "a share of tau: as in the paper's scene";
  EXPECT_THAT(scene.ensemble.seeds, ElementsAre(1));
}

TEST(Scene, AbsentSectionsAreOff) {
  const Scene scene = parse_scene(laboratory, "scene");
  EXPECT_FALSE(scene.geometry.present || scene.box.present);
  EXPECT_FALSE(scene.lubrication.enabled || scene.drag.enabled || scene.inlet.enabled);
  EXPECT_EQ(scene.porosity.strips, 0);
  EXPECT_EQ(scene.flow.source, FlowSource::none);
  EXPECT_EQ(scene.stokes_time(), 0);
  EXPECT_EQ(scene.output.series_interval, 1e-3);
  EXPECT_EQ(scene.porosity.update_interval, 0);
  EXPECT_EQ(scene.contact.friction.sliding, 0);
}

TEST(Scene, LaboratoryKeys) {
  const Scene scene = parse_scene("body_force = [\"0 N\", \"-2 nN\", \"0 N\"]\n" + laboratory +
                                      "[box]\nmin = [\"0 m\", \"0 m\", \"0 m\"]\nmax = [\"1 mm\", \"2 mm\", \"3 mm\"]\n"
                                      "[flow]\nsource = \"uniform\"\nvelocity = \"5 mm/s\"\n",
                                  "scene");
  EXPECT_THAT(scene.body_force, ElementsAre(0, -2e-9, 0));
  EXPECT_TRUE(scene.box.present);
  EXPECT_THAT(scene.box.max, ElementsAre(1e-3, 2e-3, 3e-3));
  EXPECT_THAT(scene.flow.velocity, ElementsAre(5e-3, 0, 0));
  EXPECT_DOUBLE_EQ(scene.stokes_time(), 6.6e-3);
  const Scene three =
      parse_scene(laboratory, "scene", {"flow.source=uniform", R"(flow.velocity=["1 m/s","2 m/s","3 m/s"])"});
  EXPECT_THAT(three.flow.velocity, ElementsAre(1, 2, 3));
  const Scene mean = parse_scene(laboratory, "scene", {"flow.source=uniform", "flow.mean_velocity=4 m/s"});
  EXPECT_THAT(mean.flow.velocity, ElementsAre(4, 0, 0));
}

TEST(Scene, OverridesNeedNoQuotes) {
  const Scene scene = parse_scene(channel, "scene",
                                  {"particles.diameter=22 um", "inlet.start = empty", "contact.friction.rolling=0.1",
                                   "ensemble.seeds=1-4,9", "drag.enabled=false", "time.step_fraction=0.5"});
  EXPECT_EQ(scene.particles.diameter, 22e-6);
  EXPECT_EQ(scene.inlet.start, InletStart::empty);
  EXPECT_EQ(scene.contact.friction.rolling, 0.1);
  EXPECT_THAT(scene.ensemble.seeds, ElementsAre(1, 2, 3, 4, 9));
  EXPECT_FALSE(scene.drag.enabled);
  EXPECT_EQ(scene.time.step_fraction, 0.5);
}

TEST(Scene, AnOverrideReplacesAWrongValue) {
  const std::string wrong = channel + "step_fraction = 7\n";
  EXPECT_EQ(parse_scene(wrong, "scene", {"time.step_fraction=0.1"}).time.step_fraction, 0.1);
}

TEST(Scene, AnOverriddenStepBeatsTheFraction) {
  const std::string text = channel + "step_fraction = 0.1\n";
  const Scene fixed = parse_scene(text, "scene", {"time.step=1 us"});
  EXPECT_EQ(fixed.time.step, 1e-6);
  EXPECT_EQ(fixed.time.step_fraction, 0);
  const Scene fraction = parse_scene(effective_scene(fixed), "scene", {"time.step_fraction=0.3"});
  EXPECT_EQ(fraction.time.step, 0);
  EXPECT_EQ(fraction.time.step_fraction, 0.3);
}

TEST(Scene, EffectiveTextIsReadBackToItself) {
  const std::vector<Scene> scenes = {
      read_scene(paper),
      parse_scene(channel, "scene"),
      parse_scene(laboratory, "scene"),
      parse_scene(laboratory, "scene", {"time.step=1 us", "flow.source=uniform", "flow.velocity=1 m/s"}),
      parse_scene(laboratory, "scene",
                  {R"(box.min=["0 m","0 m","0 m"])", R"(box.max=["1 m","1 m","1 m"])",
                   R"(body_force=["0 N","1 nN","0 N"])", "particles.initial=a \"strange\" \\ name.csv"}),
      parse_scene(channel, "scene",
                  {"flow.pulsation.strength=1", "flow.pulsation.time=1 ms", "drag.fluctuation.strength=1",
                   "drag.fluctuation.time=1 ms", "fidelity.preset=fast", "ensemble.seeds=[3, 4, 9]"}),
      parse_scene(channel, "scene",
                  {"flow.drive=pressure", "flow.pressure_drop=1 mbar", "drag.velocity=mixture",
                   "flow.oscillation.amplitude=0.3", "flow.oscillation.frequency=2 Hz", "flow.oscillation.phase=0.25",
                   "flow.oscillation.shape=square"}),
      parse_scene(channel, "scene", {"flow.compliance=10 uL/bar", "drag.velocity=mixture"}),
  };
  for (const Scene& scene : scenes) {
    const std::string text = effective_scene(scene);
    EXPECT_EQ(effective_scene(parse_scene(text, "effective")), text);
  }
}

// The value as --set text, different from any default; empty where other tests cover the key.
std::string other_value(const Key& key) {
  if (const auto* number = std::get_if<NumberSlot>(&key.slot)) {
    const double value = number->range.high <= 0 ? -123 : number->range.high <= 1 ? 0.25 : 123;
    return number->dimension == dimension::number ? fmt::format("{}", value)
                                                  : si_quantity(1e-7 * value, number->dimension);
  }
  if (std::holds_alternative<CountSlot>(key.slot)) return "7";
  if (std::holds_alternative<SwitchSlot>(key.slot)) return "true";
  if (const auto* word = std::get_if<WordSlot>(&key.slot)) return std::string(word->words.back());
  return {};
}

TEST(Scene, EveryKeyReachesTheEffectiveText) {
  for (const Key& key : scene_keys()) {
    const std::string value = other_value(key);
    if (value.empty()) continue;
    // The draft alone: values chosen one by one need not agree with each other.
    SCOPED_TRACE(std::string(key.path) + " = " + value);
    SceneDraft draft = read_draft(channel, "scene", {fmt::format("{}={}", key.path, value)});
    draft.scene.geometry.present = true;
    const std::string text = effective_scene(draft.scene);
    const std::string leaf(key.path.substr(section_of(key.path).size() + 1));
    const bool quoted =
        std::holds_alternative<WordSlot>(key.slot) ||
        (std::holds_alternative<NumberSlot>(key.slot) && std::get<NumberSlot>(key.slot).dimension != dimension::number);
    EXPECT_THAT(text, HasSubstr(fmt::format("{} = {}\n", leaf, quoted ? '"' + value + '"' : value)));
  }
}

TEST(Scene, EveryKeyIsExplained) {
  for (const Key& key : scene_keys()) EXPECT_FALSE(key.doc.empty()) << key.path;
}

TEST(Scene, FlowInputsAreOnlyWhatDecidesTheFlow) {
  const std::string inputs = flow_inputs(parse_scene(channel, "scene"));
  EXPECT_THAT(inputs, HasSubstr("geometry.neck_width = \"0.0001 m\"\n"));
  EXPECT_THAT(inputs, HasSubstr("flow.grid_spacing"));
  EXPECT_EQ(inputs,
            flow_inputs(parse_scene(channel, "other",
                                    {"particles.diameter=22 um", "flow.lookup=trilinear", "drag.enabled=false"})));
  EXPECT_NE(inputs, flow_inputs(parse_scene(channel, "scene", {"fluid.viscosity=1 mPa s"})));
}

TEST(Scene, AFlowRateIsAMeanVelocity) {
  // 12 uL/min = 2e-10 m3/s over 400 um times 100 um
  const Scene scene = parse_scene(channel, "scene", {"flow.rate=12 uL/min"});
  EXPECT_DOUBLE_EQ(scene.flow.mean_velocity, 5e-3);
  EXPECT_EQ(scene.flow.rate, 0);
  EXPECT_EQ(effective_scene(parse_scene(effective_scene(scene), "again")), effective_scene(scene));
  const std::string by_rate = std::regex_replace(channel, std::regex("mean_velocity = [^\n]*"), "rate = \"24 uL/min\"");
  EXPECT_DOUBLE_EQ(parse_scene(by_rate, "scene").flow.mean_velocity, 10e-3);
  EXPECT_DOUBLE_EQ(parse_scene(by_rate, "scene", {"flow.mean_velocity=7 mm/s"}).flow.mean_velocity, 7e-3);
  EXPECT_DOUBLE_EQ(
      parse_scene(by_rate, "scene", {"geometry.neck_height=50 um", "particles.diameter=30 um"}).flow.mean_velocity,
      20e-3);
}

TEST(Scene, SpacingOfTheGridFromATolerance) {
  const auto spacing = [](const Overrides& overrides) {
    const std::string text = std::regex_replace(channel, std::regex("grid_spacing[^\n]*\n"), "");
    return parse_scene(text, "scene", overrides).flow.grid_spacing;
  };
  // 1.54 h / D = 0.1 needs 15.4 layers, 2.4 (h / D)^1.5 = 0.1 needs 8.3: whole ones, rounded up.
  EXPECT_NEAR(spacing({"flow.grid_tolerance=0.1"}), 1e-4 / 16, 1e-12);
  EXPECT_NEAR(spacing({"flow.grid_tolerance=0.1", "flow.lookup=trilinear"}), 1e-4 / 9, 1e-12);
  EXPECT_NEAR(spacing({"flow.grid_tolerance=0.1", "flow.grid_spacing=5 um"}), 5e-6, 1e-12);
  EXPECT_NEAR(spacing({}), 2e-6, 1e-12);
}

TEST(Scene, AFileOfWallsCountsByItsContent) {
  const auto folder = scratch_folder();
  const auto inputs = [&](const char* name, const char* content) {
    std::ofstream(folder / name) << content;
    return flow_inputs(parse_scene(channel, "scene", {fmt::format("geometry.stl={}", (folder / name).string())}));
  };
  EXPECT_EQ(inputs("a.stl", "solid"), inputs("b.stl", "solid"));
  EXPECT_NE(inputs("a.stl", "solid"), inputs("b.stl", "other"));
}

TEST(Scene, FilesAreFoundBesideTheScene) {
  const auto folder = scratch_folder() / "scene_folder";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "start.csv") << "x,y,z\n";
  std::ofstream(folder / "scene.toml") << laboratory << "[output]\n";
  std::ofstream(folder / "with.toml")
      << "particles.initial = \"start.csv\"\n"
      << "particles.diameter = \"33 um\"\nparticles.density = \"1 kg/m3\"\n"
      << "contact.youngs_modulus = \"3 MPa\"\ncontact.poisson_ratio = 0.3\ntime.end = \"1 s\"\n";
  EXPECT_EQ(read_scene(folder / "with.toml").particles.initial, (folder / "start.csv").string());
  EXPECT_THAT(refusal([&] { read_scene(folder / "scene.toml", {"particles.initial=absent.csv"}); }),
              HasSubstr("there is no file absent.csv"));
}

TEST(Seeds, BothWays) {
  EXPECT_THAT(parse_seeds("1-3,9"), ElementsAre(1, 2, 3, 9));
  EXPECT_THAT(parse_seeds(" 5 "), ElementsAre(5));
  EXPECT_EQ(format_seeds({1, 2, 3, 9}), "1-3,9");
  EXPECT_THAT(refusal([] { parse_seeds("4-1"); }), HasSubstr("runs backwards"));
  EXPECT_THAT(refusal([] { parse_seeds("1,1"); }), HasSubstr("named twice"));
  EXPECT_THAT(refusal([] { parse_seeds("1-999999999"); }), HasSubstr("more than 1000000 seeds"));
  for (const char* text : {"", "a", "1,", "-1", "1.5", "1--2", "99999999999999999999999"})
    EXPECT_THAT(refusal([&] { parse_seeds(text); }), HasSubstr("must be whole numbers")) << text;
}

// Published test vectors of FNV-1a with 64 bits (Noll's page): "" and "foobar".
TEST(ContentHash, PublishedValues) {
  EXPECT_EQ(content_hash(""), "cbf29ce484222325");
  EXPECT_EQ(content_hash("foobar"), "85944171f73967e8");
}

}  // namespace
}  // namespace clogflow
