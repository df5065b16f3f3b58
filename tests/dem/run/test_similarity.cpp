// Slower, softer and heavier by a factor of four is the same run in slow motion, to the last bit: a constant in
// seconds, metres or newtons that hides in any law, start or protocol would show. Powers of four, whose roots are exact
// too.
#include <gtest/gtest.h>

#include "tests/faults/small_channel.hpp"

namespace clogflow::test {
namespace {

/// A quantity that goes with a power of the slowness.
struct Scaled {
  const char* key;
  double value;
  const char* unit;
  int power;
};

struct Case {
  const char* name;
  Overrides overrides;
  std::vector<Scaled> scaled = {};
};

class Similarity : public testing::TestWithParam<Case> {};

/// Velocity, modulus, 1 / mass and 1 / step divided by `slowness`: forces are too, and times multiplied.
RunData run_of(const Case& given, double slowness) {
  Overrides all = {"inlet.taps=1", "unclog.after=" + std::to_string(3 * slowness) + " ms"};
  const auto set = [&](const char* key, double value, const char* unit) {
    all.push_back(fmt::format("{}={} {}", key, value, unit));
  };
  set("flow.mean_velocity", 5 / slowness, "mm/s");
  set("contact.youngs_modulus", 4 / slowness, "MPa");
  set("time.mass_scale", 8 * slowness, "");
  set("time.end", 80 * slowness, "ms");
  set("unclog.duration", 2 * slowness, "ms");
  set("output.snapshot_interval", 5 * slowness, "ms");
  for (const auto& [key, value, unit, power] : given.scaled) set(key, value * std::pow(slowness, power), unit);
  all.insert(all.end(), given.overrides.begin(), given.overrides.end());
  Scene scene = small_channel(all);
  scene.time.step_fraction = 0;
  scene.time.step = 1.5e-6 * slowness;
  const FlowGrid grid = synthetic_flow(scene);
  return Simulation(scene, &grid, 3).run();
}

std::vector<double> times(double factor, std::vector<double> values) {
  for (double& value : values) value *= factor;
  return values;
}

bool protocol_clears(const RunData& run) {
  for (const char* word : {"release", "restart", "poke"})
    if (run.scene_text.find(fmt::format("protocol = \"{}\"", word)) != std::string::npos) return true;
  return false;
}

TEST_P(Similarity, ToTheLastBit) {
  const RunData fast = run_of(GetParam(), 1), slow = run_of(GetParam(), 4);
  EXPECT_EQ(slow.end_time, 4 * fast.end_time);
  ASSERT_GE(fast.passages.time.size(), 2u);
  EXPECT_EQ(slow.passages.time, times(4, fast.passages.time));
  EXPECT_EQ(slow.passages.id, fast.passages.id);
  EXPECT_EQ(slow.passages.y, fast.passages.y);
  if (protocol_clears(fast)) {
    EXPECT_GE(fast.releases.off.size(), 1u);
  }
  EXPECT_EQ(slow.releases.off, times(4, fast.releases.off));
  EXPECT_EQ(slow.releases.on, times(4, fast.releases.on));
  EXPECT_EQ(slow.series.count, fast.series.count);
  EXPECT_EQ(slow.series.flow_factor, fast.series.flow_factor);
  EXPECT_EQ(slow.series.pressure_drop, times(0.25, fast.series.pressure_drop));
  EXPECT_EQ(slow.series.porosity, fast.series.porosity);
  EXPECT_EQ(slow.series.elastic_energy, times(0.25, fast.series.elastic_energy));
  EXPECT_EQ(slow.series.dissipated, times(0.25, fast.series.dissipated));
  ASSERT_EQ(slow.snapshots.size(), fast.snapshots.size());
  EXPECT_EQ(slow.snapshots.back().position, fast.snapshots.back().position);
  EXPECT_EQ(slow.snapshots.back().velocity, times(0.25, fast.snapshots.back().velocity));
}

// NOLINTNEXTLINE(cert-err58-cpp)
INSTANTIATE_TEST_SUITE_P(
    Scenes, Similarity,
    testing::Values(
        Case{"Release", {}}, Case{"ReleaseNearTheNeck", {"unclog.region=1"}},
        Case{"WaitedRelease", {"unclog.shortcut=false"}},
        Case{"Restart", {"unclog.protocol=restart", "unclog.strain=0.5"}}, Case{"Poke", {"unclog.protocol=poke"}},
        Case{"StopFromAFlow", {"unclog.protocol=stop", "inlet.start=flowing", "inlet.strain=1"}},
        Case{"Empty", {"inlet.start=empty", "unclog.protocol=none"}}, Case{"Mixture", {"drag.velocity=mixture"}},
        Case{"Oscillation", {"flow.oscillation.amplitude=0.9"}, {{"flow.oscillation.frequency", 64, "Hz", -1}}},
        Case{"Pressure",
             {"flow.drive=pressure", "drag.velocity=mixture", "time.integrator=implicit_drag"},
             {{"flow.pressure_drop", 64, "Pa", -1}}},
        Case{"Compliance", {"drag.velocity=mixture"}, {{"flow.compliance", 1e-14, "m3/Pa", 1}}},
        Case{"FrictionOfSpecies",
             {R"(particles.species=[{diameter="47 um",share=0.5,friction={sliding=0.2,rolling=0.05}},)"
              R"({diameter="53 um",share=0.5,wall_friction={sliding=0.3}}])"}},
        Case{"WallFilms", {"lubrication.walls=true", "lubrication.below_roughness=clamp"}},
        Case{"ImplicitDrag", {"time.integrator=implicit_drag"}},
        Case{"ImplicitFluid", {"time.integrator=implicit_fluid"}},
        Case{"ViscousTorque", {"drag.viscous_torque=true", "flow.lookup=trilinear"}},
        Case{"MercuryTurning", {"contact.turning=mercury"}}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace clogflow::test
