// Binning.
#include "postprocess/laws/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace clogflow::postprocess {
namespace {

constexpr double most_bins_per_mean_burst = 5.0;
constexpr double bursts_per_bin = 10.0;
constexpr double growth = 1.25;
constexpr double bins_per_decade = 8.0;

void normalize(std::vector<Bin>& bins) {
  double n = 0;
  for (const Bin& bin : bins) n += static_cast<double>(bin.count);
  for (Bin& bin : bins) {
    const double unit = 1.0 / (n * (bin.to - bin.from));
    bin.density = static_cast<double>(bin.count) * unit;
    bin.error = std::sqrt(static_cast<double>(bin.count)) * unit;
  }
}

}  // namespace

std::vector<Bin> burst_histogram(const std::vector<std::size_t>& sizes) {
  if (sizes.empty()) return {};
  const auto n = static_cast<double>(sizes.size());
  const double mean = static_cast<double>(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0})) / n;
  const double largest = static_cast<double>(*std::max_element(sizes.begin(), sizes.end()));
  double width = mean / std::clamp(n / bursts_per_bin, 1.0, most_bins_per_mean_burst);
  std::vector<Bin> bins;
  for (double edge = 0.5; edge < largest; width *= growth) {
    const double next = edge + std::max(1.0, std::round(width));
    bins.push_back({edge, next, 0, 0, 0});
    edge = next;
  }
  for (const std::size_t s : sizes) {
    const auto bin =
        std::find_if(bins.begin(), bins.end(), [&](const Bin& b) { return static_cast<double>(s) < b.to; });
    ++bin->count;
  }
  normalize(bins);
  return bins;
}

std::vector<Bin> logarithmic_histogram(const std::vector<double>& values) {
  std::vector<double> logarithms;
  for (const double x : values) {
    if (x > 0) logarithms.push_back(std::log10(x) * bins_per_decade);
  }
  if (logarithms.empty()) return {};
  const auto [low, high] = std::minmax_element(logarithms.begin(), logarithms.end());
  const double first = std::floor(*low);
  std::vector<Bin> bins(static_cast<std::size_t>(std::floor(*high) - first) + 1);
  for (std::size_t k = 0; k < bins.size(); ++k) {
    bins[k].from = std::pow(10.0, (first + static_cast<double>(k)) / bins_per_decade);
    bins[k].to = std::pow(10.0, (first + static_cast<double>(k) + 1.0) / bins_per_decade);
  }
  for (const double x : logarithms) ++bins[static_cast<std::size_t>(std::floor(x) - first)].count;
  normalize(bins);
  return bins;
}

}  // namespace clogflow::postprocess
