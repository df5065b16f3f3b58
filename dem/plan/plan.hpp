// What a scene needs, what it models, what it will cost.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"
#include "dem/plan/burst_cost.hpp"
#include "dem/plan/disk_use.hpp"
#include "dem/stability/step_limit.hpp"

namespace clogflow {

/// One physical effect and the number that decides whether it matters.
struct PlannedTerm {
  std::string term;
  std::string number;  ///< what the value is
  double value;
  bool needed;
  bool modelled;
  std::string reason;
  double share = 0;  ///< of the instructions of a step [-]
};

struct Plan {
  std::vector<PlannedTerm> terms;
  double dt = 0;  ///< [s]
  StepLimits limits;
  double way_limit = 0;  ///< step in which the flow at the neck moves 0.01 d [s]
  double steps = 0, filling_steps = 0;
  double particles = 0;
  double memory = 0;                                     ///< of one run, without its flow [bytes]
  double instructions = 0;                               ///< of one seed
  double grid_reach = 0;                                 ///< how far the neck is felt upstream of the narrowing [m]
  Scene::Contact contact;                                ///< what the warnings advise on
  std::string drag_note;                                 ///< what the scene's drag.velocity means, or empty
  std::string drag_gap;                                  ///< what it leaves out, or empty
  std::vector<std::string> drive_notes, drive_warnings;  ///< on a flow that is not steady
  std::string law_note;                                  ///< on a law of adhesion that another would replace, or empty
  std::string sizes_note;                                ///< on several sizes, or empty
  std::string layers_note;                               ///< on layers of spheres that just fit, or empty
  std::string walls_note;                                ///< on walls from a file, or empty
  double scaling_error = 0;  ///< of a creeping flow scaled to this rate, over the neck's mean velocity [-]

  ExpectedBurst burst;
  double burst_steps = 0;         ///< particle-steps of one burst [-]
  double burst_instructions = 0;  ///< of one burst
  DiskUse disk;

  /// Of one seed on one core that does so many instructions a second. [s]
  double seconds(double speed = nominal_speed) const { return instructions / speed; }

  /// Where none was tried out. [1/s]
  static constexpr double nominal_speed = 6e9;
};

/// Ratio of diameter to overlap below which a scene is called too soft: preliminary runs with other
/// programs saw biased bursts at E = 3e5 Pa and 33 um (about 18) and none at 3e6 Pa (about 85).
inline constexpr double softest = 30;

/// Stokes number above which particles are called too heavy [-].
inline constexpr double largest_inertia = 0.1;

/// Stokes number up to which no inertia is seen in a neck: at D/d = 2.13, 0.005 (mass x 10) makes the column 2 % denser
/// and 0.015 (mass x 30) 8 %. \measured docs/reports/trade.md
inline constexpr double unseen_inertia = 0.005;

/// Difference from the developed duct profile, over the mean velocity, that `grid_reach` allows [-].
inline constexpr double reach_tolerance = 0.01;

/// What solids of so many neck widths times its cross-section take to flow through without friction, with the fluid
/// between them. \param packing  fraction at which they move through the channel, as seen [s]
double frictionless_time(const Scene& scene, double strain, double packing);

/// At a start, which begins loosely filled: runs of the friction map took 0.102 to 0.106 s for a strain of 10.
inline constexpr double packing_of_start = 0.33;
/// At a restart the column is packed: 0.070 to 0.076 s for the same strain.
inline constexpr double packing_of_restart = 0.41;

/// \throws Error if the scene has no time step
Plan make_plan(const Scene& scene);

/// One line for each needed term that the scene leaves out, and each assumption that fails.
std::vector<std::string> warnings(const Plan& plan);

}  // namespace clogflow
