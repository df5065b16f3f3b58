#include "postprocess/laws/cutting_times.hpp"

#include <limits>

namespace clogflow::postprocess {

CuttingTimes::CuttingTimes(std::vector<Observation> sample) {
  for (Observation& x : sample) x.censored = !x.censored;
  steps_ = kaplan_meier(std::move(sample));
}

double CuttingTimes::operator()(RandomStream& random) const {
  const double u = random.uniform();
  for (const SurvivalStep& step : steps_)
    if (step.survival <= u) return step.time;
  return std::numeric_limits<double>::infinity();
}

}  // namespace clogflow::postprocess
