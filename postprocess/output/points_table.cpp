// Rows from the statistics; text is quoted, what is undefined stays empty.
#include "postprocess/output/points_table.hpp"

#include <vector>

#include <fmt/format.h>

#include "postprocess/output/tables.hpp"

namespace clogflow::postprocess {
namespace {

using Row = std::vector<std::string>;

std::string quoted(const std::string& text) { return fmt::format("\"{}\"", text); }

void add(Row& row, const Estimate& estimate) {
  for (const double value : {estimate.value, estimate.low, estimate.high}) row.push_back(cell(value));
}

void add(Row& row, std::initializer_list<std::size_t> counts) {
  for (const std::size_t count : counts) row.push_back(std::to_string(count));
}

std::string line(const Row& row) { return fmt::format("{}\n", fmt::join(row, ",")); }

double simulated_time(const RunGroup& group) {
  double time = 0;
  for (const SeedRecord& record : group.records) time += record.window.end - record.window.start;
  return time;
}

Row header(const Trend& trend) {
  const std::string& key = trend.axis.key;
  Row row{"group", "label", "series",
          fmt::format("{} [{}]",
                      trend.axis.neck_ratio ? "D/d"
                      : key.empty()         ? "x"
                                            : key,
                      trend.axis.unit)};
  row.insert(row.end(), trend.keys.begin(), trend.keys.end());
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

Row row_of(const TrendPoint& point, const RunGroup& group, const GroupStatistics& numbers) {
  Row row{std::to_string(point.group), quoted(numbers.label), std::to_string(point.series), fmt::format("{}", point.x)};
  for (const std::string& value : point.values) row.push_back(quoted(value));
  add(row, {group.records.size()});
  row.push_back(fmt::format("{}", simulated_time(group)));
  add(row, {numbers.bursts.counted, numbers.bursts.cut_off, numbers.bursts.first});
  add(row, numbers.of("mean_burst").whole);
  add(row, point.mean_burst.known);
  add(row, {point.stops, point.passages});
  row.push_back(quoted(name(point.mean_burst.status)));
  add(row, numbers.of("mean_burst_by_threshold").whole);
  add(row, point.alpha.known);
  add(row, {point.ended, point.cut});
  row.push_back(quoted(name(point.alpha.status)));
  for (const char* key : {"share_failed", "flow_rate"}) row.push_back(cell(numbers.of(key).whole.value));
  row.push_back(cell(numbers.steady.packing_fraction.value));
  return row;
}

}  // namespace

std::string points_table(const Statistics& statistics) {
  std::string text = line(header(statistics.trend));
  for (const TrendPoint& point : statistics.trend.points)
    text += line(row_of(point, statistics.groups[point.group], statistics.numbers[point.group]));
  return text;
}

}  // namespace clogflow::postprocess
