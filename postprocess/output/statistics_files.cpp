// Writes stats.json and the tables.
#include "postprocess/output/statistics_files.hpp"

#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "postprocess/output/points_table.hpp"
#include "postprocess/output/statistics_json.hpp"
#include "postprocess/output/tables.hpp"

namespace clogflow::postprocess {

Statistics write_statistics(const StatisticsJob& job) {
  Statistics statistics = statistics_of(job.folders, job.threshold, job.request);
  std::error_code status;
  std::filesystem::create_directories(job.out, status);
  require(!status, "{}: cannot be created ({})", job.out.string(), status.message());
  for (const auto& [file, text] : tables_of(statistics.groups)) publish_file(text, job.out / file);
  publish_file(points_table(statistics), job.out / "points.csv");
  publish_file(as_json(statistics).dump(1) + "\n", job.out / "stats.json");
  return statistics;
}

}  // namespace clogflow::postprocess
