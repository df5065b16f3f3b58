#include "dem/plan/term_costs.hpp"

#include "coupling/scene/particle_sizes.hpp"
#include "dem/contact/species_friction.hpp"

namespace clogflow {

namespace {

/// Of renewing and sorting the lists, per particle and unit of v dt / d: from processor times at steps that differ
/// sevenfold (docs/reports/performance.md); nothing else in a run grows with the step.
constexpr double instructions_per_diameter = 4e5;

}  // namespace

std::vector<TermCost> term_costs(const Scene& scene) {
  std::vector<TermCost> costs{{"everything else", 194}};
  constexpr double rolling = 28, torsion = 8;
  const bool of_species = has_friction_of_species(scene.particles);
  const FrictionLaw friction = of_species ? SpeciesFriction::between_particles(scene).law()
                                          : FrictionLaw{.sliding = scene.contact.friction.sliding,
                                                        .rolling = scene.contact.friction.rolling,
                                                        .torsion = scene.contact.friction.torsion};
  if (friction.rolling > 0) costs.push_back({"rolling friction", rolling});
  if (friction.torsion > 0) costs.push_back({"torsion friction", torsion});
  // Its loop has all terms, whatever their coefficients. \measured docs/sizes.md
  if (of_species)
    costs.push_back(
        {"friction of species", 22 + (friction.rolling > 0 ? 0 : rolling) + (friction.torsion > 0 ? 0 : torsion)});
  if (scene.lubrication.enabled) costs.push_back({"lubrication", 197});
  if (scene.drag.enabled) costs.push_back({"drag", 44});
  if (scene.drag.fluctuation.strength > 0) costs.push_back({"random drag", 72});
  if (scene.flow.balances()) costs.push_back({"balance of pressures", 67});
  // Between a spread of 3 % (1.02 of the time of equal ones) and a mixture 1 : 1.4 (1.15): docs/sizes.md.
  if (!ParticleSizes(scene.particles).equal()) costs.push_back({"unequal sizes", 40});
  return costs;
}

double instructions_per_particle_step(const Scene& scene, double diameters) {
  double sum = instructions_per_diameter * diameters;
  for (const TermCost& cost : term_costs(scene)) sum += cost.instructions;
  return sum;
}

}  // namespace clogflow
