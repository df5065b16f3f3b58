// Does a power law describe arrests of which some outlive the run? It is held against their own
// survival function.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "postprocess/laws/censored.hpp"

namespace clogflow::postprocess {

struct SurvivalTest {
  double ks = 0;               ///< largest |S(t) - law(t)|, S by Kaplan & Meier [-]
  double at = 0;               ///< where [unit of the data]
  double standard_errors = 0;  ///< largest deviation over Greenwood's error of S there [-]
  double p_value = 1;          ///< share of samples of the law that lie further from their own fit
  double p_error = 0;          ///< its noise from a finite number of samples
};

/// law(t) = (t/x_min)^(1 - alpha), alpha from the same sample. The p-value comes from samples of
/// that law, censored as these are: times of cutting drawn from their own Kaplan-Meier estimate
/// (ends and cuts change places), each sample fitted anew.
/// \param replicates 0: no p-value \throws Error as fit_power_law_censored
/// \source Efron 1981, J. Am. Stat. Assoc. 76:312 (resampling of censored data)
SurvivalTest test_survival(const std::vector<Observation>& sample, double xmin, std::size_t replicates,
                           std::uint64_t seed);

}  // namespace clogflow::postprocess
