// One column of spheres brought to rest and pushed with one step after the other: which step shakes it?
#pragma once

#include <limits>
#include <string>

#include "dem/run/simulation.hpp"

namespace clogflow {

/// Steps of a trial: an unstable mode grows by a factor per step, so a few hundred would do.
inline constexpr int trial_steps = 2000;

/// Spheres pressed on something, made anew for any step.
class Column {
public:
  virtual ~Column() = default;

  virtual Simulation simulation(double step) const = 0;

  /// The same as a run begins with it, loose and under the drive of its scene.
  virtual Simulation loose(double step) const { return simulation(step); }

  /// What motion is compared with [J]
  virtual double scale(const Simulation& simulation) const { return simulation.elastic_energy(); }

  /// Loads that it bears one after the other before anything is measured; from load() on, simulations have the k-th.
  virtual int loads() const { return 1; }
  virtual void load(int) const {}

  /// Step that is not surpassed on the way to rest, however loose the contacts are for a while [s]
  virtual double longest_on_the_way() const { return std::numeric_limits<double>::infinity(); }

  /// What a mean height is compared with [m]
  virtual double diameter() const = 0;
};

enum class Verdict { accurate, inaccurate, refused, unstable };
std::string name(Verdict verdict);

struct StepVerdict {
  Verdict verdict = Verdict::refused;  ///< at the point's own step
  std::string reason;                  ///< of a refusal
  double step = 0;                     ///< the point's own [s]
  double expected = 0;                 ///< limit from the scene alone [s]
  double predicted = 0;                ///< of the column's contacts, at rest if it came to rest [s]; 0: not run
  bool at_rest = false;                ///< and stays there if pushed, with a small step
  double measured = 0;                 ///< largest step with which a small push dies out [s]; 0: not at rest
  bool capped = false;                 ///< nothing shook at the largest step tried
};

/// Fills in all but the point's own step and the expected limit, which it reads. A bounded number of steps.
/// \throws Error with the reason of a refusal
void try_steps(const Column& column, StepVerdict& result);

}  // namespace clogflow
