// How large the time step may be: what can be said before a run, and from the contacts of a run.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"
#include "dem/contact/laws.hpp"
#include "dem/stability/network_limit.hpp"

namespace clogflow {

/// Largest stable steps, each on its own [s]; infinite where nothing limits. The two times are no limits but
/// what the literature measures steps by.
struct StepLimits {
  double contact_time = 0;   ///< tau_Hertz; 0: nothing moves
  double rayleigh_time = 0;  ///< 0: the law knows no modulus
  bool linear = false;       ///< springs that know no modulus: the contact time is theirs, not that of Hertz
  double drag = 0;           ///< 2 m / c at the pack's porosity; infinite when implicit
  double lubrication = 0;    ///< 2 m* / c of two particles 2 xi apart
  double contacts = 0;       ///< of a sphere in a pack at the expected load, all springs and dashpots
  double impact = std::numeric_limits<double>::infinity();  ///< of two spheres that meet alone, springs and dashpot
                                                            ///< along the normal
  bool films_brake = false;  ///< films take the energy of collisions, whatever the dry restitution
  double passing =
      std::numeric_limits<double>::infinity();  ///< in which the flow or the fastest initial particle goes one diameter
  double expected_overlap = 0;                  ///< that `contacts` assumes, over the diameter [-]

  double smallest() const;
};

/// Largest factors on V0 that a drive of the flow gives: to moving particles, and to those that stand [-].
struct FlowFactors {
  double fastest = 1, load = 1;
};

/// What limits are asked of.
struct StepScene {
  const Scene& scene;
  const Laws& laws;
  double contact_time;  ///< tau_Hertz; 0: nothing moves [s]
  bool has_walls;
  FlowFactors factors = {};
};

/// A step, the scene's key that decides it, and whether one above its limit is warned of only.
struct StepChoice {
  double dt;  ///< [s]
  const char* key;
  bool allow_unstable;
  const Scene::Contact& contact;  ///< decides what is to be made stiffer or softer
};

/// Of any particle that comes into the scene or begins in it [m]
double smallest_radius(const Scene& scene, const std::vector<Particle>& initial);

/// Limits that follow from the scene alone: of the smallest of every species, among themselves and among the largest.
/// The load is the larger of a collision at 0.1 v (or of the fastest initial particle) and the drag and body force of
/// an arch.
StepLimits expected_limits(const StepScene& asked, const std::vector<Particle>& initial);

/// "dt = 7e-8 s: dt/tau_Hertz 0.02, ... dt/contacts 0.3"
std::string limit_words(const StepLimits& limits, double dt);

/// Above this share of a limit a run warns: contacts that carry twice the load (the limit falls with its sixth
/// root) would be above it.
inline constexpr double near_limit = 0.9;

/// Overlap over the diameter beyond which a run is refused or stopped: Hertz's law is off by some 10 % at a
/// tenth and means nothing at a quarter. Softened scenes of the paper reach 0.17.
inline constexpr double deepest_overlap = 0.25;

/// Overlap over the diameter from which a run warns: Hertz's law is off by some 10 %.
inline constexpr double deep_overlap = 0.1;

/// Share of a diameter that nothing may go in a step: a run takes what is faster for thrown by a contact that
/// was met too late. Above the smaller share a run and its plan warn.
inline constexpr double longest_share = 0.25, long_share = 0.1;

/// One line where overlaps are to be expected that a run refuses, or nothing.
std::string overlap_warning(const StepLimits& limits, const Scene::Contact& contact);

/// One line on a step in which particles go far, or nothing.
std::string passing_warning(const StepLimits& limits, double dt);

/// Largest error of the restitution of one impact at the expected overlap: 0.36 (dt / impact)^2 of it, measured at
/// e = 0.7 over the phases of the step at which the contact is met. The mean over many impacts stays within 1 %.
double impact_error(const StepLimits& limits, double dt);

/// One line where that is above 1 % and no film brakes the impact, or nothing.
std::string impact_warning(const StepLimits& limits, double dt);

/// \throws Error if the step is above a limit and the scene does not allow that, naming it and what to do
/// \return a warning, or nothing, when it is near one
std::string check_step(const StepLimits& limits, const StepChoice& step);

}  // namespace clogflow
