// Writes stats.json and the tables.
#include "postprocess/statistics_files.hpp"

#include "coupling/require.hpp"
#include "postprocess/tables.hpp"
#include "postprocess/text_file.hpp"

namespace clog::postprocess {
namespace {

constexpr int statistics_version = 1;

/// Of every key that is not a pure number, wherever it stands.
const nlohmann::json units{{"tau", "s"},         {"t_min", "s"},          {"longest", "s"},
                           {"xmin", "s"},        {"rate", "1/s"},         {"start", "s"},
                           {"end", "s"},         {"filling_time", "s"},   {"neck_width", "m"},
                           {"neck_height", "m"}, {"channel_width", "m"},  {"channel_length", "m"},
                           {"neck_length", "m"}, {"half_angle", "rad"},   {"passage_plane", "m"},
                           {"upper", "m"},       {"lower", "m"},
                           {"diameter", "m"},    {"mean_velocity", "m/s"}};

/// "D/d = 3.03", and what else varies in a sweep.
std::string label_of(const RunGroup& group, const std::vector<std::string>& swept) {
  std::string label;
  const double neck = group.scene.geometry.neck_width;
  if (neck > 0) label = fmt::format("D/d = {:.3g}", neck / group.scene.particles.diameter);
  for (const auto& key : swept) {
    const auto found = group.lines.find(key);
    const bool follows_from_diameter = key == "particles.roughness" ||
                                       key == "lubrication.cutoff" ||
                                       key == "porosity.update_interval" || key == "unclog.after";
    if (found == group.lines.end() || (neck > 0 && key == "particles.diameter") ||
        follows_from_diameter)
      continue;
    label += fmt::format("{}{} = {}", label.empty() ? "" : ", ", key.substr(key.find('.') + 1),
                         found->second);
  }
  return label.empty() ? "all runs" : label;
}

}  // namespace

nlohmann::json write_statistics(const StatisticsJob& job) {
  const auto groups = gather(job.folders, job.threshold);
  const auto swept = swept_keys(groups);
  nlohmann::json statistics{{"format", "clogflow statistics"},
                            {"version", statistics_version},
                            {"program", CLOG_VERSION},
                            {"units", units},
                            {"sweep", swept},
                            {"confidence", job.request.resampling.level},
                            {"bootstrap_seed", job.request.resampling.seed},
                            {"groups", nlohmann::json::array()}};
  for (const auto& group : groups) {
    auto numbers = group_statistics(group, job.request);
    numbers["label"] = label_of(group, swept);
    statistics["groups"].push_back(std::move(numbers));
  }
  std::error_code status;
  std::filesystem::create_directories(job.out, status);
  require(!status, "{}: cannot be created ({})", job.out.string(), status.message());
  for (const auto& [file, text] : tables_of(groups)) write_text_file(text, job.out / file);
  write_text_file(statistics.dump(1) + "\n", job.out / "stats.json");
  return statistics;
}

}  // namespace clog::postprocess
