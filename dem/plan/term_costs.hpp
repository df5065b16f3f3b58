// What the terms of a scene cost, counted once, so that a plan can say each one's share.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"

namespace clogflow {

struct TermCost {
  std::string term;     ///< as PlannedTerm names it
  double instructions;  ///< per particle and step [-]
};

/// Terms that the scene has and that cost something, and "everything else" (contacts with their sliding
/// friction, walls, integration). Counted in the pack of the paper's channel at 33 um, AVX2; packs of other
/// diameters have about as many contacts and films per particle.
/// \source tests/benchmarks/term_costs; the table is in docs/reports/performance.md
std::vector<TermCost> term_costs(const Scene& scene);

/// All of them, and the renewal of the lists, which is the dearer the further particles go in one step.
/// \param diameters  that the flow goes in one step: v dt / d [-]
double instructions_per_particle_step(const Scene& scene, double diameters);

}  // namespace clogflow
