// The scene and the spheres of a point of the second family.
#pragma once

#include <memory>

#include "coupling/files/flow_grid.hpp"
#include "trade/stability_terms.hpp"

namespace clogflow {

/// Everything that a simulation of a point is made from.
struct TermScene {
  Scene scene;                      ///< without a step
  std::shared_ptr<FlowGrid> flow;   ///< of a channel, else none
  std::vector<Particle> particles;  ///< the column
};

/// In a box, or in a channel whose neck no sphere passes.
Scene term_scene(const TermPoint& point);

/// The flow of a channel's point: plug flow, as wide as the channel. None in a box.
std::shared_ptr<FlowGrid> term_flow(const Scene& scene);

/// Nine stacks of large and small spheres by turns, every contact pressed a little, spinning a little.
/// \param overlap  over the smaller diameter of a contact [-]
std::vector<Particle> term_particles(const TermPoint& point, double overlap);

/// Drag of one of the larger spheres in the mean flow, as loads are counted [N]
double drag_of_one(const ExtremePoint& base, const Scene& scene);

bool in_channel(Term term);

}  // namespace clogflow
