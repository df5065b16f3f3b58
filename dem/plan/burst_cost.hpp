// What a burst costs, and how many are needed for a mean of wanted precision: from what was measured.
#pragma once

#include <string>

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// What the friction map says of a scene: docs/reports/friction.md, friction/map.csv.
struct ExpectedBurst {
  std::string unknown;       ///< why the map does not say, or empty: then the rest holds
  double mean = 0;           ///< <s> [-]
  double spread = 0;         ///< standard deviation of s over <s> [-]
  bool spread_seen = false;  ///< otherwise that of a law without memory, the largest that was seen anywhere
  double start = 0;          ///< simulated before friction begins: flow without it [s]
  double flow = 0;           ///< from then until the last passage [s]
  double proof = 0;          ///< from then until the clog is proved to rest for good [s]

  double simulated() const { return start + flow + proof; }  ///< for one burst [s]
};

/// Of unclog.protocol "restart", burst after burst, and "stop", one burst a seed. Between the sizes of the map <s>
/// and the rate of passages are interpolated, exponentially in D/d; times scale with D/v.
ExpectedBurst expected_burst(const Scene& scene);

/// Widths of that interval over <s> that a plan tells the price of [-].
inline constexpr double planned_precisions[] = {0.2, 0.1, 0.05};

/// Bursts for which the 95 % interval of <s> is within a share of it: (1.96 spread / share)^2.
double bursts_for(double spread, double share);

}  // namespace clogflow
