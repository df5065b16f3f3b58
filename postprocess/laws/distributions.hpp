// Histograms for the figures: burst sizes on linear bins, lapses on logarithmic ones.
#pragma once

#include <cstddef>
#include <vector>

namespace clogflow::postprocess {

struct Bin {
  double from = 0, to = 0;  ///< [unit of the data]
  std::size_t count = 0;
  double density = 0;  ///< share of the sample per unit [1/unit]
  double error = 0;    ///< sqrt(count) of it, as for independent values [1/unit]
};

/// Bins of a whole number of particles from s = 1 on: a bin that held a fraction of a particle
/// would be empty or full by chance. Up to five per mean burst, fewer for fewer than 50 bursts,
/// each a quarter wider than the one before, as the tail is thin. from and to lie between the
/// integers.
std::vector<Bin> burst_histogram(const std::vector<std::size_t>& sizes);

/// Logarithmic bins, eight a decade, between the smallest and largest positive value.
std::vector<Bin> logarithmic_histogram(const std::vector<double>& values);

}  // namespace clogflow::postprocess
