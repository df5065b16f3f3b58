// The same bits with any number of threads.
#include <gtest/gtest.h>

#include <cstring>

#include "dem/kernels/blocks.hpp"
#include "tests/benchmarks/scenes.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

/// Particles, springs and energies after some steps, as numbers.
std::vector<double> state_after(int steps, int threads, const Scene& scene, const FlowGrid* flow,
                                const std::vector<Particle>& particles) {
  Simulation simulation(scene, flow, 1, particles, threads);
  simulation.fill({});
  int lists = 0;
  for (int k = 0; k < steps; ++k) {
    simulation.compute_forces();
    lists += simulation.state().lists.renumbered();
    simulation.record();
    simulation.advance();
  }
  EXPECT_GT(lists, 1);
  const RunState& state = simulation.state();
  std::vector<double> numbers{state.energy.drag_work, state.energy.body_work};
  for (const ParticleState& p : simulation.particles().states)
    numbers.insert(numbers.end(), {p.x, p.y, p.z, p.vx, p.vy, p.vz, p.wx, p.wy, p.wz});
  state.lists.pairs.for_each_contact([&](int i, int j, const Springs<double>& s) {
    numbers.insert(numbers.end(), {1.0 * i, 1.0 * j, s.sliding.x, s.sliding.y, s.sliding.z, s.rolling.x, s.torsion});
  });
  return numbers;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

TEST(Threads, ChangeNoBitOfAStirredPack) {
  // 16000 spheres, stirred: new lists, sorting, contacts that begin and end.
  std::vector<Particle> particles = tiled_particles(4, 4);
  std::mt19937 random(3);
  stir(particles, 1, random);
  const Scene scene = tiled_box(4, 4, "");
  ASSERT_GE(Blocks(particles.size()).count(), 3);
  const std::vector<double> alone = state_after(100, 1, scene, nullptr, particles);
  EXPECT_TRUE(same_bits(state_after(100, 2, scene, nullptr, particles), alone));
  EXPECT_TRUE(same_bits(state_after(100, 3, scene, nullptr, particles), alone));
}

TEST(Threads, ChangeNoBitOfAChannel) {
  const double spacing = 8e-6;
  std::vector<Particle> lattice;
  for (int x = 0; x < 30; ++x)
    for (int y = -24; y < 24; ++y)
      for (int z = 1; z < 12; ++z)
        lattice.push_back({.radius = 3.5e-6, .x = -4e-4 + x * spacing, .y = (y + 0.5) * spacing, .z = z * spacing});
  const Scene scene = cheap_paper_scene(
      {"particles.diameter=7 um", "inlet.start=empty", "unclog.protocol=none", "geometry.channel_length=500 um"});
  const FlowGrid flow = synthetic_flow(scene);
  ASSERT_GE(Blocks(lattice.size()).count(), 3);
  const std::vector<double> alone = state_after(300, 1, scene, &flow, lattice);
  EXPECT_TRUE(same_bits(state_after(300, 2, scene, &flow, lattice), alone));
}

TEST(Blocks, HoldEachParticleOnce) {
  for (const std::size_t count : {0, 1, 4095, 8191, 8192, 8193, 12289, 100000}) {
    const Blocks blocks(count);
    EXPECT_EQ(blocks.count(), std::max<int>(1, static_cast<int>(count / Blocks::least_length))) << count;
    std::size_t next = 0;
    for (int k = 0; k < blocks.count(); ++k) {
      EXPECT_EQ(blocks.begin(k), next);
      next = blocks.end(k);
      for (std::size_t i = blocks.begin(k); i < next; i += 997) EXPECT_EQ(blocks.of(static_cast<int>(i)), k);
    }
    EXPECT_EQ(next, count);
  }
}

}  // namespace
}  // namespace clogflow::test
