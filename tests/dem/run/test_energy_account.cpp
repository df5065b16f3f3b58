// Energy term by term: what dashpots, sliders, films, drag and body force each did adds up, with all of them at work.
#include <gmock/gmock.h>

#include "tests/coupling/refusal.hpp"
#include "tests/dem/kernels/clouds.hpp"

namespace clogflow::test {
namespace {

constexpr double d = crowd_diameter;
constexpr int across = 4;

/// Every friction, film and fluid force, in a box that is a little too small for its spheres.
Scene full_box(double step, Integrator integrator) {
  Scene s = crowd_scene(step);
  s.time.integrator = integrator;
  s.contact.friction = s.contact.wall_friction = {.sliding = 0.5, .rolling = 0.3, .torsion = 0.2};
  s.lubrication.walls = true;
  s.particles.roughness = 0.01 * d;
  s.box.present = true;
  s.box.max = {across * d, across * d, across * d};
  s.body_force = {2e-8, -1e-8, -6e-8};
  s.drag.enabled = s.drag.viscous_torque = true;
  s.flow.source = FlowSource::uniform;
  s.flow.velocity = {2e-2, 0, 1e-2};
  return s;
}

/// On a lattice, of sizes from 0.97 to 1.01 of its spacing, stirred.
std::vector<Particle> crowd() {
  std::vector<Particle> particles;
  for (int k = 0; k < across * across * across; ++k) {
    const int row = k / across % across, layer = k / across / across;
    particles.push_back({.radius = (0.97 + 0.04 * (k % 7) / 6) * d / 2,
                         .x = (0.5 + k % across) * d,
                         .y = (0.5 + row) * d,
                         .z = (0.5 + layer) * d});
  }
  std::mt19937 random(3);
  stir(particles, 0.05, random);
  return particles;
}

struct Closure {
  double gap = 0;       ///< largest change of what should stay [J]
  double at_first = 0;  ///< kinetic and elastic energy [J]
  EnergyTerms terms;
};

Closure closure(double step, Integrator integrator, double time) {
  Laboratory lab(full_box(step, integrator), crowd());
  lab->account_for_energy();
  Closure result;
  while (lab->time() < time) {
    lab->compute_forces();
    const double stored = lab->kinetic_energy() + lab->elastic_energy();
    if (lab->time() == 0) result.at_first = stored;
    result.terms = lab->energy_account().terms();
    result.gap = std::max(result.gap, std::abs(stored + result.terms.lost() - result.at_first));
    lab->advance();
  }
  return result;
}

constexpr double duration = 4e-5, step = 2e-8;  // [s]

class EnergyAccountOf : public testing::TestWithParam<Integrator> {};

TEST_P(EnergyAccountOf, AllTermsClosesToFirstOrderInTheStep) {
  const Closure coarse = closure(step, GetParam(), duration), fine = closure(step / 4, GetParam(), duration);
  EXPECT_LT(coarse.gap, 0.01 * coarse.at_first);
  EXPECT_LT(fine.gap, 0.3 * coarse.gap);
}

TEST_P(EnergyAccountOf, AllTermsMissesEachThatIsLeftOut) {
  const Closure whole = closure(step / 4, GetParam(), duration);
  const EnergyTerms& t = whole.terms;
  for (const double term : {t.dashpots, t.sliders, t.films, t.stiffening, t.drag, t.body_force})
    EXPECT_GT(std::abs(term), 10 * whole.gap);
  // Nothing that dissipates gives energy back.
  for (const double term : {t.dashpots, t.sliders, t.films}) EXPECT_GT(term, 0);
}

INSTANTIATE_TEST_SUITE_P(With, EnergyAccountOf,
                         testing::Values(Integrator::verlet, Integrator::implicit_drag, Integrator::implicit_fluid),
                         [](const auto& info) {
                           return info.param == Integrator::verlet          ? "Verlet"
                                  : info.param == Integrator::implicit_drag ? "ImplicitDrag"
                                                                            : "ImplicitFluid";
                         });

TEST(EnergyAccount, ChangesNoBitOfTheRun) {
  Laboratory plain(full_box(step, Integrator::verlet), crowd()), watched(full_box(step, Integrator::verlet), crowd());
  watched->account_for_energy();
  for (int k = 0; k < 200; ++k) plain.step(), watched.step();
  for (std::size_t i = 0; i < plain->particles().size(); ++i) EXPECT_EQ(plain.position(i), watched.position(i));
}

TEST(EnergyAccount, OfContactsThatStickIsRefused) {
  Scene s = full_box(step, Integrator::verlet);
  s.contact.law = "jkr";
  s.contact.surface_energy = 1e-4;
  Laboratory lab(s, crowd());
  EXPECT_THAT(refusal([&] { lab->account_for_energy(); }), testing::HasSubstr("contacts stick"));
}

}  // namespace
}  // namespace clogflow::test
