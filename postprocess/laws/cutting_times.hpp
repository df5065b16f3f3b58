// When observations are cut, as a sample with cut ones says: for samples that are made up in its likeness.
#pragma once

#include <vector>

#include "coupling/base/random_stream.hpp"
#include "postprocess/laws/censored.hpp"
#include "postprocess/laws/survival.hpp"

namespace clogflow::postprocess {

/// Draws from the Kaplan-Meier function of the cuts, in which what ended by itself counts as cut.
/// \source Efron 1981, J. Am. Stat. Assoc. 76:312
class CuttingTimes {
public:
  explicit CuttingTimes(std::vector<Observation> sample);

  /// Infinite beyond what the sample has seen.
  double operator()(RandomStream& random) const;

private:
  std::vector<SurvivalStep> steps_;
};

}  // namespace clogflow::postprocess
