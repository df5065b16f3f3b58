// Points, then a fit per series.
#include "postprocess/summary/trend.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <boost/math/distributions/normal.hpp>

#include "coupling/base/require.hpp"
#include "coupling/scene/unclog_protocol.hpp"
#include "postprocess/laws/counting_interval.hpp"
#include "postprocess/summary/quantities.hpp"
#include "postprocess/summary/totals.hpp"

namespace clogflow::postprocess {
namespace {

constexpr double level = Resampling{}.level;

/// Wider of the interval over seeds and the exact one of the counts.
Estimate widest(const QuantityStatistics& over_seeds, const Totals& totals) {
  return wider(over_seeds.quantity->counted(totals, level), over_seeds.whole);
}

void add_mean_burst(TrendPoint& point, const RunGroup& group, const Totals& totals, const GroupStatistics& numbers) {
  const bool stops = group.scene.unclog.protocol == UnclogProtocol::stop;
  const QuantityStatistics& mean = numbers.of(stops ? "first_burst_mean" : "mean_burst_memoryless");
  point.stops = static_cast<std::size_t>(stops ? totals.first_clogs : all_stops(totals));
  point.passages = static_cast<std::size_t>(stops ? totals.until_first : all_escaped(totals));
  if (point.stops > 0) {
    const bool blocks = numbers.of("share_failed").whole.value > 0.5;  // NaN without a release
    point.mean_burst = {widest(mean, totals), blocks ? PointStatus::mostly_empty : PointStatus::measured};
  } else {
    point.mean_burst = {mean.quantity->counted(totals, level),
                        point.passages > 0 ? PointStatus::lower_bound : PointStatus::no_passage};
  }
}

PointStatus status_of_arrests(UnclogProtocol protocol) {
  if (clears_clogs(protocol)) return PointStatus::cut_by_releases;
  return protocol == UnclogProtocol::stop ? PointStatus::cut_by_stop : PointStatus::measured;
}

void add_exponent(TrendPoint& point, const RunGroup& group, const Totals& totals, const GroupStatistics& numbers) {
  const QuantityStatistics& alpha = numbers.of("alpha_fixed");
  point.ended = static_cast<std::size_t>(totals.arrests - totals.censored);
  point.cut = static_cast<std::size_t>(totals.censored);
  if (point.ended == 0) {
    point.alpha = {alpha.quantity->counted(totals, level),
                   point.cut > 0 ? PointStatus::upper_bound : PointStatus::no_arrest};
  } else {
    point.alpha = {widest(alpha, totals), status_of_arrests(group.scene.unclog.protocol)};
  }
}

/// One number along a series: where it lies in a point, and against what its logarithm is fitted.
struct Law {
  PointNumber TrendPoint::*quantity;
  std::string x;
  std::function<double(double)> transform;
};

double logarithm_error(const Estimate& known) {
  const double reach = 2 * quantile(boost::math::normal(), 0.5 * (1 + level));
  return std::log(known.high / known.low) / reach;
}

bool is_measured(const PointNumber& number) {
  // A mean of first bursts may be 0, which has no logarithm.
  return number.status == PointStatus::measured && number.known.low > 0 && std::isfinite(number.known.high);
}

std::vector<LinePoint> line_points(const std::vector<TrendPoint>& points, const Law& law) {
  std::vector<LinePoint> line;
  for (const TrendPoint& point : points) {
    const PointNumber& number = point.*law.quantity;
    if (is_measured(number))
      line.push_back({law.transform(point.x), std::log(number.known.value), logarithm_error(number.known)});
  }
  return line;
}

std::vector<LeftOut> left_out(const std::vector<TrendPoint>& points, const Law& law, const WeightedLine& line) {
  std::vector<LeftOut> all;
  for (const TrendPoint& point : points) {
    const auto& [known, status] = point.*law.quantity;
    if (is_measured(point.*law.quantity)) continue;
    const double fitted = std::exp(line.intercept.value + line.slope.value * law.transform(point.x));
    all.push_back({point.group, status, fitted, {}});
    if (status == PointStatus::lower_bound) all.back().agrees = fitted >= known.low;
    if (status == PointStatus::upper_bound) all.back().agrees = fitted <= known.high;
  }
  return all;
}

SweepLaw fit(const std::vector<TrendPoint>& points, const Law& law) {
  const auto measured = line_points(points, law);
  SweepLaw fitted{.x = law.x, .points = measured.size(), .line = {}, .refused = {}, .left_out = {}};
  try {
    fitted.line = fit_line(measured, level);
    fitted.left_out = left_out(points, law, *fitted.line);
  } catch (const Error& error) {
    fitted.refused = error.what();
  }
  return fitted;
}

double same(double x) { return x; }
double squared(double x) { return x * x; }
double cubed(double x) { return x * x * x; }
double logarithm(double x) { return std::log(x); }

/// <s> against other powers of D/d, and as a power law of it: is the third power the straightest?
std::vector<SweepLaw> rivals(const std::vector<TrendPoint>& points) {
  std::vector<SweepLaw> all;
  for (const Law& law :
       {Law{&TrendPoint::mean_burst, "D/d", same}, Law{&TrendPoint::mean_burst, "(D/d)^2", squared},
        Law{&TrendPoint::mean_burst, "(D/d)^3", cubed}, Law{&TrendPoint::mean_burst, "ln(D/d)", logarithm}}) {
    SweepLaw fitted = fit(points, law);
    if (fitted.line) all.push_back(std::move(fitted));
  }
  return all;
}

void add_laws(TrendSeries& series, const std::vector<TrendPoint>& points, const SweepAxis& axis) {
  if (!axis.numeric) {
    series.mean_burst.refused = series.alpha.refused = axis.key + " is no number";
  } else if (axis.neck_ratio) {
    series.mean_burst = fit(points, {&TrendPoint::mean_burst, "(D/d)^3", cubed});
    series.alpha = fit(points, {&TrendPoint::alpha, "D/d", same});
    series.rivals = rivals(points);
  } else {
    series.mean_burst = fit(points, {&TrendPoint::mean_burst, axis.key, same});
    series.alpha = fit(points, {&TrendPoint::alpha, axis.key, same});
  }
}

}  // namespace

const char* name(PointStatus status) {
  switch (status) {
    case PointStatus::measured:
      return "measured";
    case PointStatus::lower_bound:
      return "lower bound";
    case PointStatus::upper_bound:
      return "upper bound";
    case PointStatus::mostly_empty:
      return "mostly empty";
    case PointStatus::cut_by_releases:
      return "cut by releases";
    case PointStatus::cut_by_stop:
      return "cut by the stop";
    case PointStatus::no_passage:
      return "no passage";
    case PointStatus::no_arrest:
      return "no arrest";
  }
  return "";
}

Trend trend(const std::vector<RunGroup>& groups, const std::vector<GroupStatistics>& numbers) {
  Trend result;
  result.keys = chosen_keys(groups);
  result.axis = sweep_axis(groups, result.keys);
  const auto x = axis_values(groups, result.axis);
  const auto labels = series_labels(groups, result.axis, result.keys);
  std::vector<std::vector<TrendPoint>> members;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto known = std::ranges::find(result.series, labels[i], &TrendSeries::label);
    TrendPoint point;
    point.group = i;
    point.series = static_cast<std::size_t>(known - result.series.begin());
    point.x = x[i];
    if (known == result.series.end()) {
      result.series.emplace_back().label = labels[i];
      members.emplace_back();
    }
    for (const std::string& key : result.keys) point.values.push_back(key_value(groups[i].lines, key).text);
    const Totals totals = totals_of(groups[i].records, groups[i].scale);
    add_mean_burst(point, groups[i], totals, numbers[i]);
    add_exponent(point, groups[i], totals, numbers[i]);
    members[point.series].push_back(point);
    result.points.push_back(std::move(point));
  }
  for (std::size_t k = 0; k < result.series.size(); ++k) add_laws(result.series[k], members[k], result.axis);
  return result;
}

}  // namespace clogflow::postprocess
