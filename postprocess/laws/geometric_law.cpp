// Kolmogorov-Smirnov distance with its distribution from simulated samples.
#include "postprocess/laws/geometric_law.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/base/require.hpp"
#include "postprocess/laws/random_stream.hpp"

namespace clogflow::postprocess {
namespace {

double mean_of(const std::vector<std::size_t>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
}

/// Both functions are steps at the whole numbers: it is enough to look at those that occur and just
/// before them.
double distance(std::vector<std::size_t>& sizes) {
  std::sort(sizes.begin(), sizes.end());
  const double go_on = 1.0 - 1.0 / mean_of(sizes);
  const auto below = [&](std::size_t s) { return 1.0 - std::pow(go_on, static_cast<double>(s)); };
  const auto n = static_cast<double>(sizes.size());
  double largest = 0;
  for (std::size_t i = 0; i < sizes.size();) {
    std::size_t next = i;
    while (next < sizes.size() && sizes[next] == sizes[i]) ++next;
    largest = std::max({largest, std::abs(static_cast<double>(next) / n - below(sizes[i])),
                        std::abs(static_cast<double>(i) / n - below(sizes[i] - 1))});
    i = next;
  }
  return largest;
}

std::vector<std::size_t> geometric_sample(std::size_t n, double mean, RandomStream random) {
  const double log_go_on = std::log1p(-1.0 / mean);
  std::vector<std::size_t> sizes(n, 1);
  if (mean > 1)
    for (auto& s : sizes) s += static_cast<std::size_t>(std::log1p(-random.uniform()) / log_go_on);
  return sizes;
}

}  // namespace

GeometricTest test_geometric(const std::vector<std::size_t>& sizes, std::size_t replicates, std::uint64_t seed) {
  require(!sizes.empty() && replicates > 0, "{} burst sizes, {} replicates: nothing to test", sizes.size(), replicates);
  std::vector<std::size_t> sorted = sizes;
  GeometricTest test;
  test.ks = distance(sorted);
  const double mean = mean_of(sizes);
  std::size_t further = 0;
  for (std::size_t k = 0; k < replicates; ++k) {
    auto sample = geometric_sample(sizes.size(), mean, RandomStream(seed, k));
    further += distance(sample) >= test.ks ? 1 : 0;
  }
  test.p_value = static_cast<double>(further) / static_cast<double>(replicates);
  return test;
}

}  // namespace clogflow::postprocess
