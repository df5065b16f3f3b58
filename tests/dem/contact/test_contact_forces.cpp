// The forces of single contacts: their sum is what the solver added up, they balance at rest, and a run records them.
#include <map>

#include <gtest/gtest.h>

#include "dem/contact/contact_forces.hpp"
#include "tests/dem/laboratory.hpp"
#include "tests/faults/small_channel.hpp"

namespace clogflow::test {
namespace {

std::vector<ContactForce> forces_of(const RunState& state) {
  return contact_forces(state.particles, state.lists.pairs, state.lists.walls, state.present(state.model.laws.pair),
                        state.present(state.model.laws.wall.contact), state.clock.stretch_time());
}

/// On each particle; the other gets the opposite.
std::vector<Vec3> sums_of(const std::vector<ContactForce>& forces, std::size_t particles) {
  std::vector<Vec3> sums(particles, Vec3::Zero());
  for (const ContactForce& each : forces) {
    sums[static_cast<std::size_t>(each.particle)] += each.force;
    if (each.other >= 0) sums[static_cast<std::size_t>(each.other)] -= each.force;
  }
  return sums;
}

/// A channel with a made-up flow, no films: then contacts alone add to the loads before the drag.
void expect_sums_of_the_solver(Overrides law) {
  law.insert(law.begin(), {"lubrication.enabled=false", "unclog.protocol=none", "time.end=15 ms"});
  const Scene scene = small_channel(law);
  const FlowGrid flow = synthetic_flow(scene);
  Simulation simulation(scene, &flow, 3);
  simulation.fill({});
  std::size_t pairs = 0, walls = 0;
  double slipping = 0;
  for (int step = 0; step < 4000; ++step) {
    simulation.compute_forces();
    if (step % 200 == 0) {
      const Particles& p = simulation.particles();
      const auto forces = forces_of(simulation.state());
      const std::vector<Vec3> sums = sums_of(forces, p.size());
      double largest = 0;
      for (const ContactForce& each : forces) {
        largest = std::max(largest, each.force.norm());
        (each.other < 0 ? walls : pairs) += 1;
        slipping = std::max(slipping, (each.force - dot(each.force, each.normal) * each.normal).norm());
      }
      for (std::size_t i = 0; i < p.size(); ++i)
        EXPECT_LT((sums[i] - Vec3(p[i].fx, p[i].fy, p[i].fz)).norm(), 1e-9 * largest) << "step " << step;
    }
    simulation.record();
    simulation.advance();
  }
  EXPECT_GT(pairs, 50u);
  EXPECT_GT(walls, 50u);
  EXPECT_GT(slipping, 0);
}

TEST(ContactForces, SumUpToWhatTheSolverAdds) { expect_sums_of_the_solver({}); }

TEST(ContactForces, SumUpWithStickingSpheresOfManySizes) {
  expect_sums_of_the_solver({"contact.law=jkr", "contact.surface_energy=0.5 mJ/m2", "particles.size_spread=0.1"});
}

TEST(ContactForces, AreTheWeightOfWhatRestsOnThem) {
  // Two spheres on a floor: by hand, the upper contact bears one weight and the lower one two.
  Substance soft;
  soft.youngs_modulus = 1e7;
  Scene scene = laboratory_scene(soft, 2e-5);
  scene.contact.restitution = 0.3;
  set_floor(scene, 0.2);
  const double mass = soft.density * 3.14159265358979 / 6 * std::pow(soft.diameter, 3), weight = 9.81 * mass;
  scene.body_force = {0, 0, -weight};
  const double r = soft.diameter / 2;
  std::vector<Particle> spheres(2);
  for (int k : {0, 1})
    spheres[static_cast<std::size_t>(k)].radius = r, spheres[static_cast<std::size_t>(k)].z = (2 * k + 1) * r;
  Laboratory lab(scene, spheres);
  lab.run_until(1);
  lab->compute_forces();
  const auto forces = forces_of(lab->state());
  ASSERT_EQ(forces.size(), 2u);
  EXPECT_NEAR(std::abs(forces[0].force.z), weight, 1e-6 * weight);
  EXPECT_EQ(forces[1].other, -1);
  EXPECT_NEAR(forces[1].force.z, 2 * weight, 1e-6 * weight);
  EXPECT_NEAR(forces[1].normal.z, 1, 1e-12);
}

/// An arch at rest: drag, contacts and nothing else act, and they cancel on every particle.
TEST(ContactForces, BalanceTheDragOfARestingArch) {
  const Scene scene =
      small_channel({"particles.diameter=47 um", "inlet.start=flowing", "inlet.strain=0.5", "unclog.protocol=stop",
                     "time.end=400 ms", "output.snapshot_interval=0 s", "output.contacts=true"});
  const FlowGrid flow = synthetic_flow(scene);
  Simulation simulation(scene, &flow, 3);
  const RunData run = simulation.run();
  ASSERT_TRUE(run.record.clogged_at);
  ASSERT_TRUE(run.has_contacts);
  const RunData::Snapshot& last = run.snapshots.back();
  const Particles& p = simulation.particles();
  std::map<std::int64_t, Vec3> sum;
  for (std::size_t k = 0; k < last.contacts.a.size(); ++k) {
    const float* f = &last.contacts.force[3 * k];
    const Vec3 force(f[0], f[1], f[2]);
    sum.try_emplace(last.contacts.a[k], Vec3::Zero()).first->second += force;
    if (last.contacts.b[k] >= 0) sum.try_emplace(last.contacts.b[k], Vec3::Zero()).first->second -= force;
  }
  Vec3 all = Vec3::Zero(), all_drag = Vec3::Zero();
  int bearing = 0;
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    largest = std::max(largest, simulation.state().fluid.drag_force(static_cast<int>(i), p[i].velocity()).norm());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 drag = simulation.state().fluid.drag_force(static_cast<int>(i), p[i].velocity());
    if (!sum.contains(p.id[i])) continue;  // one that hangs in the flow moves with it
    EXPECT_LT((sum[p.id[i]] + drag).norm(), 0.02 * largest) << "particle " << p.id[i];
    all += sum[p.id[i]], all_drag += drag, ++bearing;
  }
  EXPECT_GE(bearing, 5);
  // Pairs cancel (Newton's third law): what remains is the walls' and bears the drag of all, within 1 %.
  EXPECT_LT((all + all_drag).norm(), 0.01 * all_drag.norm());
  for (const float normal : last.contacts.normal) EXPECT_LE(std::abs(normal), 1.0000001f);
}

TEST(ContactForces, AreLeftOutUnlessAskedForAndChangeNothing) {
  const Scene without = small_channel(), with = small_channel({"output.contacts=true"});
  const FlowGrid flow = synthetic_flow(without);
  RunData a = Simulation(without, &flow, 3).run(), b = Simulation(with, &flow, 3).run();
  EXPECT_FALSE(a.has_contacts);
  std::size_t contacts = 0;
  for (RunData::Snapshot& snapshot : b.snapshots) {
    contacts += snapshot.contacts.a.size();
    EXPECT_TRUE(std::ranges::is_sorted(snapshot.contacts.a));
    snapshot.contacts = {};
  }
  EXPECT_GT(contacts, 20u);
  b.has_contacts = false;
  b.scene_text = a.scene_text;
  EXPECT_EQ(result_bytes(std::move(a)), result_bytes(std::move(b)));
}

}  // namespace
}  // namespace clogflow::test
