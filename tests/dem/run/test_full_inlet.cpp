// An inlet at a full channel: nothing pops. Spheres come in where there is room, with the fluid's own velocity.
#include <gtest/gtest.h>

#include "dem/run/inlet.hpp"
#include "dem/stability/pack_estimates.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

/// Steps for which a newcomer is watched: some ten times as long as a contact lasts.
constexpr int first_steps = 500;

struct Newcomer {
  std::int64_t id;
  int age = 0;
};

/// Largest overlaps, over the diameter.
struct Overlaps {
  double inserted = -1;  ///< at the moment of insertion, with particles and walls; negative: a gap
  double first = 0;      ///< of newcomers in their first steps
  double pack = 0;       ///< of all others
  double fastest = 0;    ///< newcomer in its first steps, over the fastest fluid there [-]
  int count = 0;
};

double wall_overlap(const Scene& s, const Particles& p, std::size_t i) {
  const double r = p[i].radius, y = s.geometry.channel_width / 2, z = s.geometry.neck_height;
  return std::max({channel_start(s.geometry) + r - p[i].x, std::abs(p[i].y) + r - y, r - p[i].z, p[i].z + r - z});
}

/// With all others.
double pair_overlap(const Particles& p, std::size_t i) {
  double deepest = -1;
  for (std::size_t j = 0; j < p.size(); ++j)
    if (j != i)
      deepest = std::max(deepest, p[i].radius + p[j].radius -
                                      std::sqrt(Vec3(p[i].x - p[j].x, p[i].y - p[j].y, p[i].z - p[j].z).squaredNorm()));
  return deepest;
}

std::int64_t newest_id(const Particles& p) { return p.size() == 0 ? -1 : *std::max_element(p.id.begin(), p.id.end()); }

Overlaps watch(const Overrides& overrides, double duration) {
  const Scene scene = short_channel_scene(overrides);
  const FlowGrid grid = synthetic_flow(scene);
  // The middle of the parabola, between the spheres of a pack.
  const double d = scene.particles.diameter, fluid = 2.25 * scene.flow.mean_velocity / pack_porosity;
  Simulation simulation(scene, &grid, 1);
  simulation.fill({});
  Overlaps seen;
  std::vector<Newcomer> newcomers;
  std::int64_t known = newest_id(simulation.particles());
  while (simulation.time() < duration) {
    simulation.compute_forces();
    const Particles& p = simulation.particles();
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.id[i] <= known) continue;
      newcomers.push_back({p.id[i]});
      ++seen.count;
      seen.inserted = std::max(seen.inserted, std::max(pair_overlap(p, i), wall_overlap(scene, p, i)) / d);
    }
    known = std::max(known, newest_id(p));
    for (Newcomer& newcomer : newcomers)
      for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.id[i] != newcomer.id) continue;
        ++newcomer.age;
        seen.first = std::max(seen.first, std::max(pair_overlap(p, i), wall_overlap(scene, p, i)) / d);
        seen.fastest = std::max(seen.fastest, std::hypot(p[i].vx, p[i].vy, p[i].vz) / fluid);
      }
    std::erase_if(newcomers, [](const Newcomer& n) { return n.age >= first_steps; });
    seen.pack =
        std::max({seen.pack, simulation.pair_tally().largest_overlap / d, simulation.wall_tally().largest_overlap / d});
    simulation.record();
    simulation.advance();
  }
  return seen;
}

class FullInlet : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(FullInlet, DoesNotPop) {
  const auto& [diameter, start] = GetParam();
  const Overlaps seen =
      watch({fmt::format("particles.diameter={}", diameter), fmt::format("inlet.start={}", start), "unclog.after=3 ms"},
            40e-3);
  ASSERT_GT(seen.count, 2);
  RecordProperty("overlaps", fmt::format("{} came, at insertion {:.3g}, then {:.3g}, pack {:.3g}, speed {:.3g}",
                                         seen.count, seen.inserted, seen.first, seen.pack, seen.fastest));
  EXPECT_LE(seen.inserted, 0);
  EXPECT_LT(seen.first, seen.pack);
  EXPECT_LT(seen.fastest, 1);
}

INSTANTIATE_TEST_SUITE_P(Inlet, FullInlet,
                         testing::Combine(testing::Values("33 um", "50 um", "60 um"),
                                          testing::Values("filled", "empty")));

}  // namespace
}  // namespace clogflow::test
