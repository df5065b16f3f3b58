// What a scene needs, what it models, what it will cost.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene.hpp"
#include "dem/step_limit.hpp"

namespace clog {

/// One physical effect and the number that decides whether it matters.
struct PlannedTerm {
  std::string term;
  std::string number;  ///< what the value is
  double value;
  bool needed;
  bool modelled;
  std::string reason;
};

struct Plan {
  std::vector<PlannedTerm> terms;
  double dt = 0;                          ///< [s]
  StepLimits limits;
  double way_limit = 0;                   ///< step in which the flow at the neck moves 0.01 d [s]
  double steps = 0, filling_steps = 0;
  double particles = 0;
  double memory = 0;                      ///< of one run, without its flow [bytes]
  double seconds = 0;                     ///< of one seed on one core, at the nominal rate [s]
};

/// Particle-steps per second and core that the estimate assumes; a run prints its own.
inline constexpr double nominal_rate = 5e6;

/// \throws Error if the scene has no time step
Plan make_plan(const Scene& scene);

/// One line for each needed term that the scene leaves out, and each assumption that fails.
std::vector<std::string> warnings(const Plan& plan);

}  // namespace clog
