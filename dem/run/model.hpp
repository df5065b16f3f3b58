// The scene turned into what the solver needs: laws, steps, walls, limits. Constant during a run.
#pragma once

#include <optional>

#include "coupling/files/flow_grid.hpp"
#include "coupling/geometry/wall_outlines.hpp"
#include "coupling/scene/particle_sizes.hpp"
#include "coupling/scene/scene.hpp"
#include "dem/contact/laws.hpp"
#include "dem/contact/neighbours.hpp"
#include "dem/fluid/fluid.hpp"
#include "dem/stability/step_limit.hpp"

namespace clogflow {

/// Where particles may be, and where they leave.
struct Domain {
  Vec3 low = Vec3::Constant(-1e300), high = Vec3::Constant(1e300);  ///< [m]
  double outlet = 1e300;                                            ///< particles beyond this x are taken out [m]
  double passage = 1e300;                                           ///< x of the plane whose crossings count [m]
};

struct Model {
  Scene scene;
  ParticleSizes sizes;
  Laws laws;
  Reach reach;
  Walls walls, gate;               ///< the gate closes the neck while the channel is filled
  double largest_radius = 0;       ///< of any particle that will be [m]
  double weld = 0;                 ///< corners of the walls that are nearer than this are one [m]
  std::vector<WallOutline> necks;  ///< openings of a channel from a file at the counting plane, if there are several
  std::string walls_note;          ///< one line on walls from a file that are open, or empty
  Domain domain;
  double contact_time = 0;  ///< tau_Hertz [s]
  FlowFactors factors;      ///< how fast the flow goes at most
  double dt = 0;            ///< [s]
  std::int64_t steps = 0;

  /// The key of the scene that decides the step, for messages that tell what to lower.
  const char* step_key() const;

  /// A particle at rest, masses scaled as the scene says.
  Particle particle(const ParticleSizes::Drawn& drawn) const;
};

/// \param flow  nullptr unless flow.source is "openfoam"
/// \throws Error if the flow file is missing or belongs to another scene, or no time step follows
Model make_model(const Scene& scene, const FlowGrid* flow, const std::vector<Particle>& initial);

/// The limits of the model's step, and what is wrong with it: see dem/stability/step_limit.hpp.
StepLimits expected_limits(const Model& model, const std::vector<Particle>& initial);
std::string check_step(const StepLimits& limits, const Model& model);

/// What the mean flow takes: through the empty channel, and through a pack at rest that fills it upstream of the neck
/// [Pa]. The pack's is of pack_porosity and a developed profile (<V0^2> about 1.3 <V0>^2).
struct ExpectedDrops {
  double channel = 0, pack = 0;
  double mean_factor(double drop) const { return drop / (channel + pack); }  ///< q of a pressure drop through the pack
};

/// Where pressures are balanced. \param flow  nullptr: an estimate \return none where there is no estimate
std::optional<ExpectedDrops> expected_drops(const Scene& scene, const FlowGrid* flow);

/// The fluid as the scene wants it, on the grid if there is one.
Fluid make_fluid(const Scene& scene, const FlowGrid* flow);

}  // namespace clogflow
