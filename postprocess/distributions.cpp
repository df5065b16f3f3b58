// Binning.
#include "postprocess/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace clog::postprocess {
namespace {

constexpr double bins_per_mean_burst = 5.0;
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
  const double mean = static_cast<double>(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0})) /
                      static_cast<double>(sizes.size());
  const auto width = static_cast<std::size_t>(std::max(1.0, std::round(mean / bins_per_mean_burst)));
  const std::size_t largest = *std::max_element(sizes.begin(), sizes.end());
  std::vector<Bin> bins((largest + width - 1) / width);
  for (std::size_t k = 0; k < bins.size(); ++k) {
    bins[k].from = static_cast<double>(k * width) + 0.5;
    bins[k].to = static_cast<double>((k + 1) * width) + 0.5;
  }
  for (const std::size_t s : sizes) ++bins[(s - 1) / width].count;
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

}  // namespace clog::postprocess
