#include "postprocess/summary/statistics.hpp"

namespace clogflow::postprocess {

Statistics statistics_of(const std::vector<std::filesystem::path>& folders, std::optional<double> threshold,
                         const StatisticsRequest& request) {
  Statistics all;
  all.groups = gather(folders, threshold);
  all.swept_keys = swept_keys(all.groups);
  all.resampling = request.resampling;
  for (const RunGroup& group : all.groups) all.numbers.push_back(group_statistics(group, request));
  all.trend = trend(all.groups, all.numbers);
  for (std::size_t i = 0; i < all.groups.size(); ++i) all.numbers[i].label = group_label(all.groups[i], all.trend.keys);
  for (const auto& folder : folders)
    for (auto& point : points_without_runs(folder)) all.without_runs.push_back(std::move(point));
  return all;
}

}  // namespace clogflow::postprocess
