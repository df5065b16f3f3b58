// Tails with right-censored values: a clog that outlives the run lasted at least this long.
#pragma once

#include <cstddef>
#include <vector>

namespace clogflow::postprocess {

/// A duration, or a lower bound of one.
struct Observation {
  double value = 0;       ///< [unit of the data]
  bool censored = false;  ///< the true value is larger
};

struct CensoredFit {
  double parameter = 0;      ///< alpha of the power law [-], or rate of the exponential [1/unit]
  double sigma = 0;          ///< standard error of it
  std::size_t complete = 0;  ///< values seen whole
  std::size_t censored = 0;
  double exposure = 0;  ///< sum of ln(x/x_min), or of x - x_min, over whole and censored values
};

/// alpha of the law below from sums alone. \param complete number of whole values \param log_exposure sum of
/// ln(x_i/x_min) over whole and censored ones
double censored_exponent(double complete, double log_exposure);

/// Power-law exponent for a given x_min with censored values: a whole value enters with the density
/// p(x) = (alpha-1)/x_min (x/x_min)^-alpha, a censored one with the survival function
/// (x/x_min)^(1-alpha):
///   alpha = 1 + n_complete / sum_i ln(x_i/x_min)   (the sum over whole and censored values)
///   sigma = (alpha - 1)/sqrt(n_complete)
/// Values below x_min, censored or not, say nothing about the tail and are left out. Without
/// censored values this is Eq. (3.1) of Clauset, Shalizi & Newman 2009. \throws Error when no whole
/// value lies above xmin, or xmin <= 0
CensoredFit fit_power_law_censored(const std::vector<Observation>& sample, double xmin);

/// Rate of an exponential that starts at x_min:
///   lambda = n_complete / sum_i (x_i - x_min), sigma = lambda/sqrt(n_complete)
/// \throws Error as above
/// \source Lawless, Statistical Models and Methods for Lifetime Data, sec. 4.1 (type I censoring)
CensoredFit fit_exponential_censored(const std::vector<Observation>& sample, double xmin);

}  // namespace clogflow::postprocess
