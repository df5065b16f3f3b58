// A state holds everything: from any of them, a fresh simulation goes on with the same bits.
#include <random>

#include <gmock/gmock.h>

#include "tests/coupling/refusal.hpp"
#include "tests/faults/small_channel.hpp"

namespace clogflow::test {
namespace {

struct Case {
  const char* name;
  Overrides overrides;
};

class ExactRestart : public testing::TestWithParam<Case> {};

struct Saved {
  std::string bytes;
  bool filling;
};

struct Undisturbed {
  std::string result;
  std::vector<Saved> states;
  RunData data;
};

/// The whole run, its state saved at every look of the watcher: saving must not disturb either.
Undisturbed run_and_save(const Scene& scene, const FlowGrid* flow) {
  Undisturbed run;
  Simulation simulation(scene, flow, 3);
  run.data = simulation.run([&](const Progress& progress) {
    run.states.push_back({simulation.save(), progress.filling});
  });
  run.result = result_bytes(run.data);
  return run;
}

std::string resume_and_run(const Scene& scene, const FlowGrid* flow, const std::string& state) {
  Simulation simulation(scene, flow, 3);
  simulation.resume(state);
  return result_bytes(simulation.run());
}

/// Resumes from `count` states, seeded, the first and the last among them.
void expect_exact(const Scene& scene, const FlowGrid* flow, int count) {
  const std::string alone = result_bytes(Simulation(scene, flow, 3).run());
  const Undisturbed saved = run_and_save(scene, flow);
  EXPECT_EQ(saved.result, alone) << "saving changed the run";
  ASSERT_GE(saved.states.size(), 3u);
  std::mt19937 random(1);
  for (int k = 0; k < count; ++k) {
    const std::size_t last = saved.states.size() - 1;
    const std::size_t at = k == 0 ? 0 : k == 1 ? last : random() % last;
    EXPECT_TRUE(resume_and_run(scene, flow, saved.states[at].bytes) == alone)
        << "state " << at << " of " << last << (saved.states[at].filling ? ", filling" : ", running");
  }
}

TEST_P(ExactRestart, FromAnyMoment) {
  const Scene scene = small_channel(GetParam().overrides);
  const FlowGrid flow = synthetic_flow(scene);
  expect_exact(scene, &flow, 6);
}

// NOLINTNEXTLINE(cert-err58-cpp)
INSTANTIATE_TEST_SUITE_P(
    Scenes, ExactRestart,
    testing::Values(Case{"Release", {}}, Case{"StartEmpty", {"inlet.start=empty"}},
                    Case{"InletRate", {"inlet.start=empty", "inlet.rate=2000 1/s"}},
                    Case{"ConcentrationAndGravity",
                         {"inlet.start=empty", "inlet.concentration=0.2", "particles.density=1200 kg/m3",
                          "gravity=[\"0 m/s2\", \"0 m/s2\", \"-9.81 m/s2\"]"}},
                    Case{"Cohesion",
                         {"contact.law=jkr", "contact.surface_energy=0.5 mJ/m2", "inlet.start=flowing",
                          "inlet.strain=0.5", "unclog.protocol=restart", "unclog.strain=0.5", "time.end=40 ms"}},
                    Case{"ViscousTorque", {"drag.viscous_torque=true", "flow.lookup=trilinear"}},
                    Case{"WallLubrication", {"lubrication.walls=true", "lubrication.below_roughness=clamp"}},
                    Case{"ImplicitDrag", {"time.integrator=implicit_drag", "drag.velocity=superficial"}},
                    Case{"ImplicitFluid", {"time.integrator=implicit_fluid", "lubrication.walls=true"}},
                    Case{"Noise",
                         {"drag.fluctuation.strength=0.8", "drag.fluctuation.time=0.5 ms",
                          "flow.pulsation.strength=0.3", "flow.pulsation.time=1 ms"}},
                    Case{"Pressure",
                         {"flow.drive=pressure", "flow.pressure_drop=100 Pa", "drag.velocity=mixture",
                          "time.integrator=implicit_drag", "drag.viscous_torque=true", "flow.pulsation.strength=0.1",
                          "flow.pulsation.time=1 ms"}},
                    Case{"Compliance",
                         {"flow.compliance=1e-14 m3/Pa", "drag.velocity=mixture", "flow.oscillation.amplitude=0.5",
                          "flow.oscillation.frequency=300 Hz"}},
                    Case{"Oscillation",
                         {"flow.oscillation.amplitude=0.8", "flow.oscillation.frequency=200 Hz",
                          "flow.oscillation.phase=0.3"}},
                    Case{"NoFriction",
                         {"contact.friction.sliding=0", "contact.friction.rolling=0", "contact.friction.torsion=0",
                          "unclog.protocol=none"}},
                    Case{"FrictionOfSpecies",
                         {R"(particles.species=[{diameter="50 um",share=0.5,friction={sliding=0.2,torsion=0}},)"
                          R"({diameter="50 um",share=0.5}])"}},
                    Case{"StartFlowing", {"inlet.start=flowing", "inlet.strain=1"}},
                    Case{"Stop", {"unclog.protocol=stop", "inlet.start=flowing", "inlet.strain=0.5", "time.end=60 ms"}},
                    Case{"Restart", {"unclog.protocol=restart", "unclog.strain=0.5", "time.end=40 ms"}},
                    Case{"Rewind",
                         {"inlet.start=flowing", "inlet.strain=0.5", "unclog.protocol=rewind", "unclog.strain=0.1",
                          "time.end=40 ms"}},
                    Case{"Poke", {"unclog.protocol=poke"}}, Case{"BurstSnapshots", {"output.burst_snapshots=20 us"}},
                    Case{"Contacts", {"output.contacts=true", "output.snapshot_interval=1 ms"}},
                    Case{"ReleaseNearTheNeck", {"unclog.region=1"}},
                    Case{"RarePorosity", {"porosity.update_interval=1 ms", "porosity.strips=5"}},
                    Case{"Local", {"porosity.method=local", "porosity.update_interval=1 ms"}},
                    Case{"LocalWithoutStrips", {"porosity.method=local", "porosity.strips=0", "drag.law=beetstra"}},
                    Case{"NeckStrip", {"porosity.neck=true", "porosity.update_interval=1 ms"}},
                    Case{"Mixture", {"drag.velocity=mixture", "drag.law=beetstra"}}),
    [](const auto& info) { return info.param.name; });

TEST(ExactRestartScenes, TheChannelClogsAndIsReleased) {
  const Scene scene = small_channel();
  const FlowGrid flow = synthetic_flow(scene);
  const Undisturbed run = run_and_save(scene, &flow);
  EXPECT_GE(run.data.releases.off.size(), 1u);
  EXPECT_GE(run.data.passages.time.size(), 3u);
  EXPECT_GT(std::ranges::count(run.states, true, &Saved::filling), 3);
}

TEST(ExactRestartScenes, ASiloThatIsPoked) {
  const Scene scene =
      small_channel({"flow.source=none", "gravity=[\"9.81 m/s2\", \"0 m/s2\", \"0 m/s2\"]", "time.mass_scale=1",
                     "particles.density=2500 kg/m3", "drag.enabled=false", "lubrication.enabled=false",
                     "contact.wall_restitution=0.5", "unclog.protocol=poke", "time.end=30 ms"});
  ASSERT_TRUE(scene.falls());
  expect_exact(scene, nullptr, 6);
}

/// Grains in a box that fall, rub and roll: no flow, no inlet.
Scene shaken_box(const ScratchFile& particles) {
  Scene scene = laboratory_scene({.youngs_modulus = 1e7, .diameter = 0.01}, 2e-5);
  scene.contact.restitution = 0.6;
  set_friction(scene, {.sliding = 0.5, .rolling = 0.1, .torsion = 0.1});
  set_floor(scene, 0.05);
  scene.body_force = {0.002, 0.001, -0.01};
  scene.time.end = 0.2;
  scene.output.series_interval = 0.01;
  scene.output.snapshot_interval = 0.05;
  scene.particles.initial = particles.name();
  return scene;
}

std::string grains_csv() {
  std::vector<Particle> grains;
  for (int k = 0; k < 27; ++k) {
    Particle grain;
    grain.radius = 0.004 + 0.0005 * (k % 3);
    const int row = k / 3 % 3, layer = k / 9;
    grain.x = -0.012 + 0.0121 * (k % 3), grain.y = -0.012 + 0.0121 * row;
    grain.z = 0.006 + 0.0121 * layer;
    grain.vx = 0.1 * (k % 5), grain.wz = k;
    grains.push_back(grain);
  }
  return as_csv(grains);
}

TEST(ExactRestartScenes, Laboratory) {
  const ScratchFile particles(grains_csv());
  expect_exact(shaken_box(particles), nullptr, 8);
}

// State, resume, state: what comes out is what went in. Seconds of wall-clock time are the one exception.
TEST(ExactRestartScenes, AStateSurvivesItself) {
  const ScratchFile particles(grains_csv());
  const Scene scene = shaken_box(particles);
  const Undisturbed run = run_and_save(scene, nullptr);
  Simulation simulation(scene, nullptr, 3);
  simulation.resume(run.states[5].bytes);
  const std::string again = simulation.save();
  ASSERT_EQ(again.size(), run.states[5].bytes.size());
  std::size_t different = 0;
  for (std::size_t k = 0; k < again.size(); ++k) different += again[k] != run.states[5].bytes[k];
  EXPECT_LE(different, 2 * sizeof(double));  // the clocks of the wall and of the processor
}

TEST(ExactRestartScenes, AStateCutShortOrTooLongIsRefused) {
  const ScratchFile particles(grains_csv());
  const Scene scene = shaken_box(particles);
  const std::string state = run_and_save(scene, nullptr).states[2].bytes;
  for (const std::size_t length : {std::size_t{0}, std::size_t{1}, state.size() / 2, state.size() - 1})
    EXPECT_THAT(refusal([&] { Simulation(scene, nullptr, 3).resume(state.substr(0, length)); }),
                testing::HasSubstr("a saved state"));
  EXPECT_THAT(refusal([&] { Simulation(scene, nullptr, 3).resume(state + "x"); }),
              testing::HasSubstr("longer than it should be"));
}

}  // namespace
}  // namespace clogflow::test
