// The lists of who may meet miss nobody, though they are made for many steps and particles go at different speeds.
#include <gtest/gtest.h>

#include <set>

#include "dem/run/contact_lists.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

/// Pairs within reach of a contact or a film that the list lacks, by looking at each.
int missing_pairs(const Simulation& simulation) {
  const Particles& p = simulation.particles();
  const Neighbours& list = simulation.state().lists.pairs;
  std::set<std::pair<int, int>> listed;
  std::size_t count = 0;
  list.for_each_pair([&](int i, int j) { listed.insert({i, j}), ++count; });
  EXPECT_EQ(listed.size(), count) << "a pair came twice";
  int missing = 0;
  for (int i = 0; i < static_cast<int>(p.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(p.size()); ++j) {
      const double within = simulation.model().reach.contact(p[i].radius, p[j].radius);
      if ((p[i].position() - p[j].position()).norm() < within) missing += !listed.contains({i, j});
    }
  return missing;
}

/// Places where spheres touch the walls, by looking at each triangle.
std::int64_t wall_contacts(const Simulation& simulation, const WallSurface& surface) {
  std::vector<int> all(surface.size());
  for (int t = 0; t < static_cast<int>(all.size()); ++t) all[t] = t;
  std::int64_t contacts = 0;
  std::vector<WallPoint> found;
  for (const ParticleState& p : simulation.particles().states) {
    found.clear();
    surface.closest_points(all, p.position(), p.radius, found);
    join_touches(found, p.radius);
    contacts += std::ssize(found);
  }
  return contacts;
}

struct Seen {
  int steps = 0, lists = 0, passages = 0;
};

/// A run of so many steps, every `every` of them looked at.
Seen watch(const Overrides& overrides, int steps, int every) {
  const Scene scene = short_channel_scene(overrides);
  const FlowGrid grid = synthetic_flow(scene);
  Simulation simulation(scene, &grid, 1);
  const WallSurface surface(simulation.model().walls);
  simulation.fill({});
  Seen seen;
  for (; seen.steps < steps; ++seen.steps) {
    simulation.compute_forces();
    seen.lists += simulation.state().lists.renumbered();
    if (seen.steps % every == 0) {
      EXPECT_EQ(missing_pairs(simulation), 0) << seen.steps;
      EXPECT_EQ(simulation.wall_tally().contacts, wall_contacts(simulation, surface)) << seen.steps;
    }
    simulation.record();
    simulation.advance();
  }
  seen.passages = static_cast<int>(simulation.data().passages.id.size());
  return seen;
}

TEST(ContactLists, MissNobodyWhileTheyLast) {
  const Seen seen = watch({"inlet.start=flowing", "inlet.strain=1", "particles.diameter=33 um",
                           "contact.friction.rolling=0", "contact.friction.torsion=0"},
                          20000, 7);
  EXPECT_GT(seen.passages, 10);
  EXPECT_GT(seen.lists, 50);
  EXPECT_LT(seen.lists, seen.steps / 20);
}

TEST(ContactLists, MissNobodyWhereSizesDiffer) {
  const Seen seen = watch({"inlet.start=flowing", "inlet.strain=1", "particles.diameter=33 um",
                           "particles.size_distribution=lognormal", "particles.size_spread=0.3"},
                          5000, 7);
  EXPECT_GT(seen.lists, 10);
}

}  // namespace
}  // namespace clogflow::test
