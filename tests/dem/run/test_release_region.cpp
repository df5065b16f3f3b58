// A release near the neck: friction ends where its region begins, and only there. The arch that a poke takes out.
#include <map>

#include <gtest/gtest.h>

#include "dem/protocol/frictionless_flow.hpp"
#include "dem/run/arch.hpp"
#include "tests/faults/small_channel.hpp"

namespace clogflow::test {
namespace {

/// Steps on while `goes_on`, at most to the end. \return whether it stopped before
template <class Goes>
bool step_while(Simulation& simulation, const Goes& goes_on) {
  while (simulation.time() < simulation.model().scene.time.end) {
    simulation.compute_forces();
    simulation.record();
    if (!goes_on(simulation.state())) return true;
    simulation.advance();
  }
  return false;
}

double largest(const Springs<double>& s) {
  return std::max({std::sqrt(dot(s.sliding, s.sliding)), std::sqrt(dot(s.rolling, s.rolling)), std::abs(s.torsion)});
}

struct Springs2 {
  int held = 0, none = 0;  ///< contacts with and without a wound spring

  void count(const Springs<double>& s) { largest(s) > 0 ? ++held : ++none; }
};

TEST(ReleaseRegion, HasNoSpringsAndTheRestHasThem) {
  const Scene scene = small_channel({"unclog.region=0.5"});
  const FlowGrid grid = synthetic_flow(scene);
  Simulation simulation(scene, &grid, 3);
  simulation.fill({});
  ASSERT_TRUE(step_while(simulation, [](const RunState& s) { return !s.clog_watch.friction_off(); }));
  simulation.advance();
  simulation.compute_forces();
  const RunState& state = simulation.state();
  ASSERT_TRUE(state.clog_watch.friction_off());
  const double border = -0.5 * scene.geometry.neck_width;
  Springs2 near, far;
  const auto& p = state.particles;
  state.lists.pairs.for_each_contact([&](int i, int j, const Springs<double>& springs) {
    ((p[i].x + p[j].x) / 2 > border ? near : far).count(springs);
  });
  for (const auto& touch : state.lists.walls.touches(p))
    (p[touch.particle].x > border ? near : far).count(touch.springs);
  EXPECT_GE(near.none, 2);
  EXPECT_EQ(near.held, 0);
  EXPECT_GE(far.held, 5);
  EXPECT_EQ(far.none, 0);
}

TEST(Arch, StandsAtTheNeckAndBearsLoad) {
  const Scene scene = small_channel({"unclog.protocol=poke"});
  const FlowGrid grid = synthetic_flow(scene);
  Simulation simulation(scene, &grid, 3);
  simulation.fill({});
  ASSERT_TRUE(step_while(simulation, [](const RunState& s) { return !s.clog_watch.pokes(); }));
  const RunState& state = simulation.state();
  const std::vector<int> arch = arch_of(state);
  // Marin & Souzy 2025: a bridge needs some (D/d)^2 + 1 = 5 spheres at D/d = 2; walls hold the others.
  EXPECT_GE(arch.size(), 2u);
  EXPECT_LE(arch.size(), 12u);
  for (const int i : arch) EXPECT_GT(state.particles[i].x, -100e-6) << "of the neck";
  const std::size_t before = state.count();
  simulation.advance();
  simulation.compute_forces();
  EXPECT_EQ(simulation.state().count(), before - arch.size());
  EXPECT_EQ(simulation.state().clog_watch.taken_out(), static_cast<std::int64_t>(arch.size()));
  EXPECT_EQ(simulation.data().releases.off.size(), 1u);
}

TEST(FrictionlessFlow, StrainIsAVolumeOfSolids) {
  const Scene scene = small_channel();           // d = 50 um, D = H = 100 um, 4 D wide, 5 mm/s
  EXPECT_EQ(particles_of_strain(scene, 2), 31);  // 2 (100 um)^3 / (pi (50 um)^3 / 6) = 30.56
  EXPECT_EQ(particles_of_strain(scene, 1e-6), 1);
  // The flow carries 2 D^3 in 2 D / 4 / (5 mm/s) = 10 ms; ten times that and 20 tau of 10 ms.
  EXPECT_NEAR(longest_flow(scene, 2), 0.3, 1e-12);
}

TEST(FlowingStart, BeginsDenseAndWithFriction) {
  const Scene scene = small_channel({"inlet.start=flowing", "inlet.strain=2", "unclog.protocol=none"});
  const FlowGrid grid = synthetic_flow(scene);
  Simulation simulation(scene, &grid, 3);
  simulation.fill({});
  const RunState& state = simulation.state();
  EXPECT_TRUE(state.filling.flowed());
  EXPECT_EQ(state.filling.note(), "");
  EXPECT_GE(state.gone(), 31);
  EXPECT_TRUE(state.has_friction());
  EXPECT_EQ(simulation.time(), 0);
  EXPECT_TRUE(simulation.data().passages.time.empty());
  EXPECT_GT(state.fluid.strips().packing_fraction(), 0.25);
}

/// Where each particle is, by its number.
std::map<std::int64_t, Vec3> places(const RunState& state) {
  std::map<std::int64_t, Vec3> at;
  for (std::size_t i = 0; i < state.count(); ++i) at[state.particles.id[i]] = state.particles[i].position();
  return at;
}

TEST(Rewind, PutsTheColumnBackToWhereFrictionBegan) {
  const Scene scene =
      small_channel({"inlet.start=flowing", "inlet.strain=2", "unclog.protocol=rewind", "time.end=60 ms"});
  const FlowGrid grid = synthetic_flow(scene);
  Simulation simulation(scene, &grid, 3);
  simulation.fill({});
  simulation.compute_forces();
  const RunState& state = simulation.state();
  for (int restart = 0; restart < 2; ++restart) {
    const auto began = places(state);
    ASSERT_TRUE(step_while(simulation, [](const RunState& s) { return !s.clog_watch.friction_off(); }));
    EXPECT_NE(places(state), began);
    const std::int64_t inserted = state.inlet.inserted();
    const double before = state.energy.supplied() - simulation.kinetic_energy() - simulation.elastic_energy();
    simulation.advance();
    simulation.compute_forces();
    // What came in with this very step is there beside them.
    std::size_t back = 0;
    for (const auto& [id, place] : places(state)) back += began.contains(id) && began.at(id) == place;
    EXPECT_EQ(back, began.size());
    EXPECT_GE(state.inlet.inserted(), inserted);
    // No energy is dissipated or made by it, but for that step's: the clog stood, what is put back flows.
    const double after = state.energy.supplied() - simulation.kinetic_energy() - simulation.elastic_energy();
    EXPECT_NEAR(after, before, 0.1 * simulation.kinetic_energy());
    // The strain of a branch: D^3 over pi d^3 / 6 is 15 particles.
    const std::int64_t gone = state.gone();
    ASSERT_TRUE(step_while(simulation, [](const RunState& s) { return s.clog_watch.friction_off(); }));
    EXPECT_EQ(state.gone() - gone, 15);
    simulation.advance();
    simulation.compute_forces();
  }
}

}  // namespace
}  // namespace clogflow::test
