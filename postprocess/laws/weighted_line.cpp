// Weighted least squares with the extra scatter found by bisection.
#include "postprocess/laws/weighted_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "coupling/base/require.hpp"

namespace clogflow::postprocess {
namespace {

struct Solution {
  double slope, intercept, slope_error, intercept_error, chi_squared;
};

/// Least squares with the weights 1/(sigma^2 + variance).
Solution solve(const std::vector<LinePoint>& points, double variance) {
  double sum = 0, mean_x = 0, mean_y = 0;
  const auto weight = [&](const LinePoint& p) { return 1.0 / (p.sigma * p.sigma + variance); };
  for (const LinePoint& p : points) sum += weight(p);
  for (const LinePoint& p : points) {
    mean_x += weight(p) * p.x / sum;
    mean_y += weight(p) * p.y / sum;
  }
  double xx = 0, xy = 0;
  for (const LinePoint& p : points) {
    xx += weight(p) * (p.x - mean_x) * (p.x - mean_x);
    xy += weight(p) * (p.x - mean_x) * (p.y - mean_y);
  }
  Solution s{};
  s.slope = xy / xx;
  s.intercept = mean_y - s.slope * mean_x;
  s.slope_error = std::sqrt(1.0 / xx);
  s.intercept_error = std::sqrt(1.0 / sum + mean_x * mean_x / xx);
  for (const LinePoint& p : points) {
    const double miss = p.y - s.intercept - s.slope * p.x;
    s.chi_squared += weight(p) * miss * miss;
  }
  return s;
}

/// Chi squared falls as the variance grows: bisection on its logarithm.
double extra_variance(const std::vector<LinePoint>& points, double least, double degrees) {
  double largest = 0;
  for (const LinePoint& p : points)
    for (const LinePoint& q : points) largest = std::max(largest, std::abs(p.y - q.y));
  if (largest == 0 || solve(points, least).chi_squared <= degrees) return 0;
  double low = least, high = largest * largest;
  for (int step = 0; step < 200; ++step) {
    const double middle = std::sqrt(low * high);
    (solve(points, middle).chi_squared > degrees ? low : high) = middle;
  }
  return high;
}

}  // namespace

WeightedLine fit_line(const std::vector<LinePoint>& points, double level) {
  require(points.size() >= fewest_line_points, "{} points (a line needs {})", points.size(), fewest_line_points);
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  require(left->x < right->x, "{} points at one place x = {}: no line", points.size(), left->x);
  const auto degrees = static_cast<double>(points.size() - 2);
  // Errors of 0 would weigh infinitely: below this variance nothing changes any more.
  double scale = 0;
  for (const LinePoint& p : points) scale = std::max({scale, std::abs(p.y), p.sigma});
  const double least = std::max(scale * scale * 1e-24, std::numeric_limits<double>::min());

  WeightedLine line;
  line.degrees_of_freedom = points.size() - 2;
  line.chi_squared = solve(points, least).chi_squared;
  line.p_value = cdf(complement(boost::math::chi_squared(degrees), line.chi_squared));
  const double variance = extra_variance(points, least, degrees);
  line.extra_scatter = std::sqrt(variance);
  const Solution s = solve(points, std::max(variance, least));
  const double reach = variance > 0 ? quantile(boost::math::students_t(degrees), 0.5 * (1 + level))
                                    : quantile(boost::math::normal(), 0.5 * (1 + level));
  line.slope = {s.slope, s.slope - reach * s.slope_error, s.slope + reach * s.slope_error};
  line.intercept = {s.intercept, s.intercept - reach * s.intercept_error, s.intercept + reach * s.intercept_error};
  return line;
}

}  // namespace clogflow::postprocess
