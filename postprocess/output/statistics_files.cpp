// Writes stats.json and the tables.
#include "postprocess/output/statistics_files.hpp"

#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "postprocess/events/sweep_axis.hpp"
#include "postprocess/output/points_table.hpp"
#include "postprocess/output/tables.hpp"
#include "postprocess/summary/trend.hpp"

namespace clogflow::postprocess {
namespace {

constexpr int statistics_version = 1;

/// Of every key that is not a pure number, wherever it stands.
const nlohmann::json units{{"tau", "s"},
                           {"t_min", "s"},
                           {"longest", "s"},
                           {"xmin", "s"},
                           {"largest_miss_at", "s"},
                           {"rate", "1/s"},
                           {"start", "s"},
                           {"end", "s"},
                           {"filling_time", "s"},
                           {"wall_time", "s"},
                           {"neck_width", "m"},
                           {"neck_height", "m"},
                           {"channel_width", "m"},
                           {"channel_length", "m"},
                           {"neck_length", "m"},
                           {"half_angle", "rad"},
                           {"passage_plane", "m"},
                           {"upper", "m"},
                           {"lower", "m"},
                           {"diameter", "m"},
                           {"mean_velocity", "m/s"}};

}  // namespace

nlohmann::json write_statistics(const StatisticsJob& job) {
  const auto groups = gather(job.folders, job.threshold);
  const auto chosen = chosen_keys(groups);
  nlohmann::json statistics{{"format", "clogflow statistics"},
                            {"version", statistics_version},
                            {"program", CLOG_VERSION},
                            {"units", units},
                            {"sweep", swept_keys(groups)},
                            {"confidence", job.request.resampling.level},
                            {"bootstrap_seed", job.request.resampling.seed}};
  std::vector<nlohmann::json> numbers;
  for (const auto& group : groups) {
    numbers.push_back(group_statistics(group, job.request));
    numbers.back()["label"] = group_label(group, chosen);
  }
  statistics["groups"] = numbers;
  statistics["trend"] = trend(groups, numbers);
  auto& empty = statistics["trend"]["without_runs"] = nlohmann::json::array();
  for (const auto& folder : job.folders)
    for (auto& point : points_without_runs(folder)) empty.push_back(point);
  std::error_code status;
  std::filesystem::create_directories(job.out, status);
  require(!status, "{}: cannot be created ({})", job.out.string(), status.message());
  for (const auto& [file, text] : tables_of(groups)) publish_file(text, job.out / file);
  publish_file(points_table(statistics), job.out / "points.csv");
  publish_file(statistics.dump(1) + "\n", job.out / "stats.json");
  return statistics;
}

}  // namespace clogflow::postprocess
