#include "coupling/geometry/duct_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupling/base/expect.hpp"
#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

using std::numbers::pi;

// The terms fall like n^-3: the rest after n = 399 is below 4/pi * 1/(4 * 400^2) = 2e-6.
constexpr int last_term = 399;

// cosh(a) / cosh(b) for |a| <= b, without overflow.
double cosh_ratio(double a, double b) {
  a = std::abs(a);
  return std::exp(a - b) * (1 + std::exp(-2 * a)) / (1 + std::exp(-2 * b));
}

// sinh(a) / cosh(b) for |a| <= b, without overflow.
double sinh_over_cosh(double a, double b) {
  const double size = std::abs(a);
  return std::copysign(std::exp(size - b) * (1 - std::exp(-2 * size)) / (1 + std::exp(-2 * b)), a);
}

}  // namespace

DuctFlow::DuctFlow(double width, double height) : width_(width), height_(height), turned_(width < height) {
  require(width > 0 && height > 0, "duct of {} m x {} m (both sides must be positive)", width, height);
  long_ = turned_ ? height : width;
  narrow_ = turned_ ? width : height;
  mean_ = 0;
  for (int n = 1; n <= last_term; n += 2) {
    const double b = n * pi * long_ / (2 * narrow_);
    mean_ += 8 / (pi * pi * std::pow(n, 4)) * (1 - std::tanh(b) / b);
  }
}

DuctFlow DuctFlow::of_channel(const Geometry& geometry) {
  DuctFlow flow(geometry.channel_width, geometry.neck_height);
  flow.radius_ = std::sqrt(geometry.inlet_area / pi);
  return flow;
}

double DuctFlow::operator()(double y, double z) const {
  if (radius_ > 0) {
    const double r = std::hypot(y, z - height_ / 2) / radius_;
    return std::max(0.0, 2 * (1 - r * r));
  }
  if (std::abs(y) >= width_ / 2 || z <= 0 || z >= height_) return 0;
  // along: from the middle of the long side; across: from a wall of the narrow side
  const double along = turned_ ? z - height_ / 2 : y;
  const double across = turned_ ? y + width_ / 2 : z;
  double sum = 0;
  for (int n = 1; n <= last_term; n += 2) {
    const double k = n * pi / narrow_;
    sum += 4 / (pi * std::pow(n, 3)) * std::sin(k * across) * (1 - cosh_ratio(k * along, k * long_ / 2));
  }
  return sum / mean_;
}

double DuctFlow::resistance() const {
  if (radius_ > 0) return 8 / (radius_ * radius_);
  return pi * pi / (narrow_ * narrow_ * mean_);
}

double DuctFlow::mean_over(const Rectangle& r) const {
  expect(radius_ == 0);
  double along_min = r.y_min, along_max = r.y_max, across_min = r.z_min, across_max = r.z_max;
  if (turned_) {
    along_min = r.z_min - height_ / 2, along_max = r.z_max - height_ / 2;
    across_min = r.y_min + width_ / 2, across_max = r.y_max + width_ / 2;
  }
  double sum = 0;
  for (int n = 1; n <= last_term; n += 2) {
    const double k = n * pi / narrow_;
    const double b = k * long_ / 2;
    const double across = (std::cos(k * across_min) - std::cos(k * across_max)) / k;
    const double along =
        (along_max - along_min) - (sinh_over_cosh(k * along_max, b) - sinh_over_cosh(k * along_min, b)) / k;
    sum += 4 / (pi * std::pow(n, 3)) * across * along;
  }
  return sum / mean_ / ((along_max - along_min) * (across_max - across_min));
}

}  // namespace clogflow
