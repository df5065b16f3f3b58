// Points far beyond the paper, each run to a verdict: is the predicted step safe, and is it tight?
#pragma once

#include "coupling/scene/scene.hpp"
#include "trade/step_trials.hpp"

namespace clogflow {

/// One column of spheres pressed on a floor by a uniform flow.
struct ExtremePoint {
  int number;
  double diameter;        ///< d, 1 um to 1 mm [m]
  double viscosity;       ///< eta, 1e-6 to 10 [Pa s]
  double youngs_modulus;  ///< E, 1e5 to 1e11 [Pa]
  double velocity;        ///< v, 1e-6 to 1 [m/s]
  double porosity;        ///< eps, 0.36 to 1: the flow is f(eps) v / eps
  double friction;        ///< all three, 0 to 10
  double restitution;     ///< 0.01 to 1
  int particles;          ///< 1 to 27
  double step_fraction;   ///< of tau_Hertz, 1/200 to 1/2
  bool films;             ///< lubrication
  Integrator integrator;
};

/// Spread evenly over the logarithms of the axes (multiples of roots of primes). \param number  from 1 on
ExtremePoint extreme_point(int number);

/// Fluid, particles, contact law and end of its scene, as text. \param diameter  of the spheres [m]
std::string spheres_in_liquid(const ExtremePoint& point, double diameter);

/// Its scene, without particles. \param step  0: not known yet [s]
Scene extreme_scene(const ExtremePoint& point, double step);

/// Refuses, or measures. A bounded number of steps; throws nothing.
StepVerdict measure(const ExtremePoint& point);

}  // namespace clogflow
