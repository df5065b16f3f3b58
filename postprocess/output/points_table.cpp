// Rows from the statistics; text is quoted, what is undefined stays empty.
#include "postprocess/output/points_table.hpp"

#include <initializer_list>
#include <vector>

#include <fmt/format.h>

namespace clogflow::postprocess {
namespace {

using nlohmann::json;
using Row = std::vector<std::string>;

std::string cell(const json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return fmt::format("\"{}\"", value.get<std::string>());
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  return value.dump();
}

void add(Row& row, const json& of, std::initializer_list<const char*> keys) {
  for (const char* key : keys) row.push_back(cell(of.at(key)));
}

std::string line(const Row& row) { return fmt::format("{}\n", fmt::join(row, ",")); }

double simulated_time(const json& group) {
  double time = 0;
  for (const json& run : group.at("runs")) time += run.at("end").get<double>() - run.at("start").get<double>();
  return time;
}

Row header(const json& trend) {
  const std::string name = trend.at("variable").at("name");
  Row row{"group", "label", "series",
          fmt::format("{} [{}]", name.empty() ? "x" : name, trend.at("variable").at("unit").get<std::string>())};
  for (const json& key : trend.at("keys")) row.push_back(key);
  for (const char* column : {"runs",
                             "simulated time [s]",
                             "bursts",
                             "bursts cut off",
                             "first bursts",
                             "<s> [1]",
                             "<s> low",
                             "<s> high",
                             "<s> all bursts [1]",
                             "<s> all low",
                             "<s> all high",
                             "stops",
                             "passages",
                             "<s> status",
                             "<s> by T_min [1]",
                             "<s> by T_min low",
                             "<s> by T_min high",
                             "alpha [1]",
                             "alpha low",
                             "alpha high",
                             "arrests ended",
                             "arrests cut",
                             "alpha status",
                             "releases without passage [1]",
                             "flow rate [1/s]",
                             "packing fraction [1]"})
    row.emplace_back(column);
  return row;
}

Row row_of(const json& point, const json& group, const json& keys) {
  const json& quantities = group.at("quantities");
  Row row;
  add(row, point, {"group"});
  add(row, group, {"label"});
  add(row, point, {"series", "x"});
  for (const json& key : keys) row.push_back(cell(point.at("values").at(key)));
  row.push_back(std::to_string(group.at("runs").size()));
  row.push_back(fmt::format("{}", simulated_time(group)));
  add(row, group.at("bursts"), {"counted", "cut_off", "first"});
  add(row, quantities.at("mean_burst"), {"value", "low", "high"});
  add(row, point.at("mean_burst"), {"value", "low", "high", "stops", "passages", "status"});
  add(row, quantities.at("mean_burst_by_threshold"), {"value", "low", "high"});
  add(row, point.at("alpha"), {"value", "low", "high", "ended", "cut", "status"});
  add(row, quantities.at("share_failed"), {"value"});
  add(row, quantities.at("flow_rate"), {"value"});
  add(row, group.at("steady").at("packing_fraction"), {"value"});
  return row;
}

}  // namespace

std::string points_table(const json& statistics) {
  const json& trend = statistics.at("trend");
  std::string text = line(header(trend));
  for (const json& point : trend.at("points"))
    text += line(row_of(point, statistics.at("groups").at(point.at("group").get<std::size_t>()), trend.at("keys")));
  return text;
}

}  // namespace clogflow::postprocess
