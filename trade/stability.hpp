// Points far beyond the paper, each run to a verdict: is the predicted step safe, and is it tight?
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"

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

/// Points spread evenly over the logarithms of the axes (multiples of roots of primes).
std::vector<ExtremePoint> extreme_points(int count);

enum class Verdict { accurate, inaccurate, refused, unstable };
std::string name(Verdict verdict);

struct StabilityResult {
  ExtremePoint point;
  Verdict verdict;       ///< at the point's own step
  std::string reason;    ///< of a refusal
  double step = 0;       ///< the point's own [s]
  double expected = 0;   ///< limit from the scene alone [s]
  double predicted = 0;  ///< of the column's contacts, at rest if it came to rest [s]; 0: not run
  bool at_rest = false;  ///< and stays there if pushed, with a small step
  double measured = 0;   ///< largest step with which a small push dies out [s]; 0: not at rest
  bool capped = false;   ///< nothing shook at the largest step tried
};

/// Refuses, or measures. A bounded number of steps; throws nothing.
StabilityResult measure(const ExtremePoint& point);

}  // namespace clogflow
