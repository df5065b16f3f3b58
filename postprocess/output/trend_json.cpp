#include "postprocess/output/trend_json.hpp"

#include <string>

#include <fmt/format.h>

#include "postprocess/output/fit_json.hpp"

namespace clogflow::postprocess {
namespace {

using nlohmann::json;

json as_json(const PointNumber& number) {
  json entry = as_json(number.known);
  entry["status"] = name(number.status);
  return entry;
}

json as_json(const TrendPoint& point, const std::vector<std::string>& keys) {
  json mean_burst = as_json(point.mean_burst), alpha = as_json(point.alpha), values = json::object();
  mean_burst.update({{"stops", point.stops}, {"passages", point.passages}});
  alpha.update({{"ended", point.ended}, {"cut", point.cut}});
  for (std::size_t k = 0; k < keys.size(); ++k) values[keys[k]] = point.values[k];
  return {{"group", point.group}, {"series", point.series},   {"x", point.x},
          {"values", values},     {"mean_burst", mean_burst}, {"alpha", alpha}};
}

json as_json(const LeftOut& point) {
  json out{{"group", point.group}, {"status", name(point.status)}, {"law", number_or_null(point.law)}};
  if (point.agrees) out["agrees"] = *point.agrees;
  return out;
}

json as_json(const SweepLaw& law, const char* quantity, const SweepAxis& axis) {
  json result = json::object();
  if (axis.numeric) result = {{"law", fmt::format("{} = A exp(b x)", quantity)}, {"x", law.x}, {"points", law.points}};
  if (!law.line) {
    result["refused"] = law.refused;
    return result;
  }
  result.update({{"b", as_json(law.line->slope)},
                 {"ln_A", as_json(law.line->intercept)},
                 {"chi_squared", law.line->chi_squared},
                 {"degrees_of_freedom", law.line->degrees_of_freedom},
                 {"p_value", law.line->p_value},
                 {"extra_scatter", law.line->extra_scatter},
                 {"left_out", json::array()}});
  for (const LeftOut& point : law.left_out) result["left_out"].push_back(as_json(point));
  return result;
}

json as_json(const TrendSeries& series, const SweepAxis& axis) {
  json result{{"label", series.label},
              {"mean_burst", as_json(series.mean_burst, "mean_burst", axis)},
              {"alpha", as_json(series.alpha, "alpha", axis)}};
  if (!axis.neck_ratio) return result;
  json& rivals = result["mean_burst"]["rivals"] = json::array();
  for (const SweepLaw& law : series.rivals)
    rivals.push_back({{"x", law.x},
                      {"b", as_json(law.line->slope)},
                      {"chi_squared", law.line->chi_squared},
                      {"extra_scatter", law.line->extra_scatter}});
  return result;
}

}  // namespace

json as_json(const Trend& trend) {
  const SweepAxis& axis = trend.axis;
  json result{{"keys", trend.keys},
              {"variable",
               {{"key", axis.key},
                {"name", axis.neck_ratio ? "D/d" : axis.key},
                {"unit", axis.unit},
                {"numeric", axis.numeric}}},
              {"points", json::array()},
              {"series", json::array()}};
  for (const TrendPoint& point : trend.points) result["points"].push_back(as_json(point, trend.keys));
  for (const TrendSeries& series : trend.series) result["series"].push_back(as_json(series, axis));
  return result;
}

}  // namespace clogflow::postprocess
