// Points, then a fit per series.
#include "postprocess/summary/trend.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <boost/math/distributions/normal.hpp>

#include "coupling/base/require.hpp"
#include "postprocess/events/sweep_axis.hpp"
#include "postprocess/laws/counting_interval.hpp"
#include "postprocess/laws/weighted_line.hpp"
#include "postprocess/summary/fit_json.hpp"
#include "postprocess/summary/totals.hpp"

namespace clogflow::postprocess {
namespace {

using nlohmann::json;

constexpr double level = Resampling{}.level;

double or_nan(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

Estimate over_seeds(const json& numbers, const char* quantity) {
  const json& q = numbers.at("quantities").at(quantity);
  return {or_nan(q.at("value")), or_nan(q.at("low")), or_nan(q.at("high"))};
}

json mean_burst(const Totals& totals, const json& numbers) {
  const auto stops = static_cast<std::size_t>(all_stops(totals));
  const auto passages = static_cast<std::size_t>(all_escaped(totals));
  Estimate mean = mean_burst_from_counts(stops, passages, level);
  if (stops > 0) mean = wider(mean, over_seeds(numbers, "mean_burst_memoryless"));
  json entry = as_json(mean);
  entry["stops"] = stops;
  entry["passages"] = passages;
  entry["status"] = stops > 0 ? "measured" : passages > 0 ? "lower bound" : "no passage";
  return entry;
}

json exponent(const RunGroup& group, const Totals& totals, const json& numbers) {
  const auto ended = static_cast<std::size_t>(totals.arrests - totals.censored);
  Estimate alpha = rate_from_counts(ended, totals.log_exposure, level);
  for (double* side : {&alpha.value, &alpha.low, &alpha.high}) *side += 1.0;
  if (ended > 0) alpha = wider(alpha, over_seeds(numbers, "alpha_fixed"));
  if (ended == 0) alpha.value = alpha.low = std::numeric_limits<double>::quiet_NaN();
  const bool by_release = group.scene.unclog.protocol == UnclogProtocol::release;
  json entry = as_json(alpha);
  entry["ended"] = ended;
  entry["cut"] = static_cast<std::size_t>(totals.censored);
  entry["status"] = totals.arrests == 0 ? "no arrest"
                    : ended == 0        ? "upper bound"
                    : by_release        ? "cut by releases"
                                        : "measured";
  return entry;
}

/// One number along a series: where it lies in a point, and against what its logarithm is fitted.
struct Law {
  const char* quantity;
  std::string variable;
  std::function<double(double)> transform;
};

double logarithm_error(const json& entry) {
  const double reach = 2 * quantile(boost::math::normal(), 0.5 * (1 + level));
  return std::log(entry.at("high").get<double>() / entry.at("low").get<double>()) / reach;
}

bool is_measured(const json& entry) {
  return entry.at("status") == "measured" && !entry.at("low").is_null() && !entry.at("high").is_null();
}

std::vector<LinePoint> line_points(const std::vector<json>& points, const Law& law) {
  std::vector<LinePoint> line;
  for (const json& point : points) {
    const json& entry = point.at(law.quantity);
    if (is_measured(entry))
      line.push_back({law.transform(point.at("x").get<double>()), std::log(entry.at("value").get<double>()),
                      logarithm_error(entry)});
  }
  return line;
}

/// What was not fitted, and whether the law respects the bound.
json left_out(const std::vector<json>& points, const Law& law, const WeightedLine& line) {
  json all = json::array();
  for (const json& point : points) {
    const json& entry = point.at(law.quantity);
    if (is_measured(entry)) continue;
    json out{{"group", point.at("group")}, {"status", entry.at("status")}};
    const double x = law.transform(point.at("x").get<double>());
    const double fitted = std::exp(line.intercept.value + line.slope.value * x);
    out["law"] = number_or_null(fitted);
    if (entry.at("status") == "lower bound") out["agrees"] = fitted >= entry.at("low").get<double>();
    if (entry.at("status") == "upper bound") out["agrees"] = fitted <= entry.at("high").get<double>();
    all.push_back(out);
  }
  return all;
}

json fit(const std::vector<json>& points, const Law& law) {
  const auto measured = line_points(points, law);
  json result{{"law", fmt::format("{} = A exp(b x)", law.quantity)}, {"x", law.variable}, {"points", measured.size()}};
  try {
    const WeightedLine line = fit_line(measured, level);
    result.update({{"b", as_json(line.slope)},
                   {"ln_A", as_json(line.intercept)},
                   {"chi_squared", line.chi_squared},
                   {"degrees_of_freedom", line.degrees_of_freedom},
                   {"p_value", line.p_value},
                   {"extra_scatter", line.extra_scatter},
                   {"left_out", left_out(points, law, line)}});
  } catch (const Error& error) {
    result["refused"] = error.what();
  }
  return result;
}

/// <s> against other powers of D/d, and as a power law of it: is the third power the straightest?
json rivals(const std::vector<json>& points) {
  json all = json::array();
  for (const Law& law : {Law{"mean_burst", "D/d", [](double x) { return x; }},
                         Law{"mean_burst", "(D/d)^2", [](double x) { return x * x; }},
                         Law{"mean_burst", "(D/d)^3", [](double x) { return x * x * x; }},
                         Law{"mean_burst", "ln(D/d)", [](double x) { return std::log(x); }}}) {
    const json fitted = fit(points, law);
    if (!fitted.contains("refused"))
      all.push_back({{"x", law.variable},
                     {"b", fitted.at("b")},
                     {"chi_squared", fitted.at("chi_squared")},
                     {"extra_scatter", fitted.at("extra_scatter")}});
  }
  return all;
}

json fits(const std::vector<json>& points, const SweepAxis& axis) {
  if (!axis.numeric) {
    const json none{{"refused", axis.key + " is no number"}};
    return {{"mean_burst", none}, {"alpha", none}};
  }
  const auto same = [](double x) { return x; };
  const auto cubed = [](double x) { return x * x * x; };
  const Law size = axis.neck_ratio ? Law{"mean_burst", "(D/d)^3", cubed} : Law{"mean_burst", axis.key, same};
  json both{{"mean_burst", fit(points, size)},
            {"alpha", fit(points, {"alpha", axis.neck_ratio ? "D/d" : axis.key, same})}};
  if (axis.neck_ratio) both["mean_burst"]["rivals"] = rivals(points);
  return both;
}

}  // namespace

json trend(const std::vector<RunGroup>& groups, const std::vector<json>& numbers) {
  const auto chosen = chosen_keys(groups);
  const SweepAxis axis = sweep_axis(groups, chosen);
  const auto x = axis_values(groups, axis);
  const auto labels = series_labels(groups, axis, chosen);
  json result{{"keys", chosen},
              {"variable",
               {{"key", axis.key},
                {"name", axis.neck_ratio ? "D/d" : axis.key},
                {"unit", axis.unit},
                {"numeric", axis.numeric}}},
              {"points", json::array()},
              {"series", json::array()}};
  std::vector<std::string> series;
  std::vector<std::vector<json>> members;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto known = std::find(series.begin(), series.end(), labels[i]);
    const auto index = static_cast<std::size_t>(known - series.begin());
    if (known == series.end()) {
      series.push_back(labels[i]);
      members.emplace_back();
    }
    json values = json::object();
    for (const std::string& key : chosen) values[key] = key_value(groups[i].lines, key).text;
    const Totals totals = totals_of(groups[i].records, groups[i].scale);
    members[index].push_back({{"group", i},
                              {"series", index},
                              {"x", x[i]},
                              {"values", values},
                              {"mean_burst", mean_burst(totals, numbers[i])},
                              {"alpha", exponent(groups[i], totals, numbers[i])}});
    result["points"].push_back(members[index].back());
  }
  for (std::size_t k = 0; k < series.size(); ++k) {
    json entry = fits(members[k], axis);
    entry["label"] = series[k];
    result["series"].push_back(entry);
  }
  return result;
}

}  // namespace clogflow::postprocess
