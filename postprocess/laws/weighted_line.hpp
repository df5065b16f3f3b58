// A straight line through points with errors, honest when the line is not the whole truth.
#pragma once

#include <cstddef>
#include <vector>

#include "postprocess/laws/confidence.hpp"

namespace clogflow::postprocess {

struct LinePoint {
  double x = 0;      ///< [unit of x]
  double y = 0;      ///< [unit of y]
  double sigma = 0;  ///< standard error of y, >= 0 [unit of y]
};

struct WeightedLine {
  Estimate slope;                      ///< [unit of y / unit of x]
  Estimate intercept;                  ///< y at x = 0 [unit of y]
  double chi_squared = 0;              ///< of the line with the weights 1/sigma^2 [-]
  std::size_t degrees_of_freedom = 0;  ///< points - 2
  double p_value = 1;                  ///< that errors alone scatter the points this far from a line
  double extra_scatter = 0;            ///< s, what the points scatter beyond their errors [unit of y]
};

/// Fewest points that make a line one could doubt.
inline constexpr std::size_t fewest_line_points = 3;

/// y = intercept + slope x by least squares with the weights 1/(sigma_i^2 + s^2), where s is 0 if the
/// errors explain the scatter, and else what makes
///   sum_i (y_i - intercept - slope x_i)^2 / (sigma_i^2 + s^2) = n - 2.
/// With errors of 0 that is ordinary least squares. Intervals: normal when s = 0, Student's t with
/// n - 2 degrees of freedom when s had to be estimated. A line that misses its points thus has wide
/// intervals, whatever the number of events behind each point.
/// \param level of the intervals, in (0, 1) [-]
/// \throws Error on fewer than fewest_line_points points or a single x
/// \source Paule & Mandel 1982, J. Res. Natl. Bur. Stand. 87:377 (extra scatter)
WeightedLine fit_line(const std::vector<LinePoint>& points, double level);

}  // namespace clogflow::postprocess
