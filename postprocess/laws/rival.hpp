// Power law against exponential on the same tail: Vuong's likelihood-ratio test.
#pragma once

#include <vector>

#include "postprocess/laws/censored.hpp"
#include "postprocess/laws/sorted_sample.hpp"

namespace clogflow::postprocess {

struct RivalTest {
  double log_ratio = 0;   ///< R: log-likelihood of the power law minus that of the exponential [-]
  double normalized = 0;  ///< R / (sqrt(n) sigma): standard normal when both are equally good [-]
  double p_value = 1;     ///< probability of such an |R| when both are equally good [-]
  double rate = 0;        ///< of the exponential [1/unit]
};

/// "power law" or "exponential"; "undecided" where the sign of R means nothing.
const char* favoured(const RivalTest& test);

/// Which law lies closer to the tail x >= x_min, each at its maximum likelihood, censored values
/// through the survival functions. R > 0 favours the power law, R < 0 the exponential; with a large
/// p-value (> 0.1) the sign means nothing.
///   R = sum_i [l1_i - l2_i],  sigma^2 = 1/n sum_i [(l1_i - l2_i) - R/n]^2,
///   p = erfc(|R| / (sqrt(2 n) sigma))
/// \throws Error when no whole value lies above xmin
/// \source Clauset, Shalizi & Newman 2009, SIAM Rev. 51:661, appendix C; Vuong 1989, Econometrica
/// 57:307
RivalTest power_law_against_exponential(const std::vector<Observation>& sample, double xmin);

/// The same for whole numbers, both laws in their discrete forms:
///   p(x) = x^-alpha / zeta(alpha, x_min)  against  p(x) = (1 - e^-rate) e^(-rate (x - x_min))
/// \param alpha of the power law, at its maximum likelihood
/// \throws Error when all values equal xmin, or none reaches it
/// \source Clauset et al. 2009, table 2.1
RivalTest discrete_power_law_against_exponential(const std::vector<double>& sample, double xmin, double alpha);

}  // namespace clogflow::postprocess
