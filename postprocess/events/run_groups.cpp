// From folders to ensembles.
#include "postprocess/events/run_groups.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "coupling/base/require.hpp"
#include "coupling/files/run_file.hpp"

namespace clogflow::postprocess {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> run_files_right_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("run_") && name.ends_with(".h5")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What the first run file of a folder showed.
struct Known {
  SceneLines lines;
  fs::path file;
};

void require_same_scene(const SceneLines& lines, const fs::path& file, const Known& known) {
  const auto keys = differing_keys(lines, known.lines);
  if (keys.empty()) return;
  const auto value = [&](const SceneLines& of) {
    const auto found = of.find(keys.front());
    return found == of.end() ? std::string("nothing") : found->second;
  };
  throw Error(
      fmt::format("{}: another scene than {} in the same folder ({} = {} against {}): runs of different "
                  "scenes do not mix; a sweep has a folder for each scene",
                  file.string(), known.file.filename().string(), keys.front(), value(lines), value(known.lines)));
}

void require_new_seed(const RunGroup& group, const RunData& run, const fs::path& file) {
  for (const SeedRecord& record : group.records) {
    require(record.seed != run.seed, "{}: seed {} of this scene was already read from {}", file.string(), run.seed,
            record.file.string());
  }
}

class Gatherer {
public:
  explicit Gatherer(std::optional<double> threshold) : threshold_(threshold) {}

  void add(const fs::path& file) {
    const RunData run = read_run_events(file);
    const SceneLines lines = scene_lines(run.scene_text);
    const auto known = folders_.try_emplace(fs::canonical(fs::absolute(file).parent_path()), Known{lines, file});
    require_same_scene(lines, file, known.first->second);
    RunGroup& group = group_of(run, lines, file);
    require_new_seed(group, run, file);
    group.records.push_back(record_of(run, group.scene, group.scale));
    group.records.back().file = file;
    require(run.record.necks.value_or(1) == std::max<std::int64_t>(1, std::ssize(group.necks)),
            "{}: counted at {} necks, the runs before it at {}: made by different programs, so they do not mix",
            file.string(), run.record.necks.value_or(1), std::max<std::int64_t>(1, std::ssize(group.necks)));
    for (std::size_t k = 0; k < group.necks.size(); ++k) {
      group.necks[k].push_back(record_of(through_neck(run, static_cast<std::int64_t>(k)), group.scene, group.scale));
      group.necks[k].back().file = file;
    }
  }

  std::vector<RunGroup> result() && { return std::move(groups_); }

private:
  RunGroup& group_of(const RunData& run, const SceneLines& lines, const fs::path& file) {
    const auto found =
        std::find_if(groups_.begin(), groups_.end(), [&](const RunGroup& group) { return group.lines == lines; });
    if (found != groups_.end()) return *found;
    RunGroup& group = groups_.emplace_back();
    group.scene = parse_scene(run.scene_text, file.string());
    group.scene_text = run.scene_text;
    group.lines = lines;
    group.scale = clog_scale(group.scene, threshold_, file.string());
    group.record = run.record;
    if (run.record.necks.value_or(1) > 1) group.necks.resize(static_cast<std::size_t>(*run.record.necks));
    return group;
  }

  std::optional<double> threshold_;
  std::vector<RunGroup> groups_;
  std::map<fs::path, Known> folders_;
};

}  // namespace

std::vector<fs::path> find_run_files(const fs::path& folder) {
  require(fs::is_directory(folder), "{}: no such folder", folder.string());
  std::vector<fs::path> files = run_files_right_in(folder);
  if (files.empty()) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (!entry.is_directory()) continue;
      const auto below = run_files_right_in(entry.path());
      files.insert(files.end(), below.begin(), below.end());
    }
    std::sort(files.begin(), files.end());
  }
  require(!files.empty(), "{}: no run_*.h5 here or one folder below (`clog run` writes them)", folder.string());
  return files;
}

std::vector<std::string> points_without_runs(const fs::path& folder) {
  std::vector<std::string> points;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && name.find('=') != std::string::npos && run_files_right_in(entry.path()).empty())
      points.push_back(name);
  }
  std::sort(points.begin(), points.end());
  return points;
}

std::vector<RunGroup> gather(const std::vector<fs::path>& folders, std::optional<double> threshold) {
  Gatherer gatherer(threshold);
  std::set<fs::path> seen;
  for (const auto& folder : folders) {
    for (const auto& file : find_run_files(folder)) {
      if (seen.insert(fs::weakly_canonical(file)).second) gatherer.add(file);
    }
  }
  auto groups = std::move(gatherer).result();
  for (auto& group : groups) {
    const auto sort = [](std::vector<SeedRecord>& records) {
      std::sort(records.begin(), records.end(),
                [](const SeedRecord& a, const SeedRecord& b) { return a.seed < b.seed; });
    };
    sort(group.records);
    for (auto& records : group.necks) sort(records);
  }
  std::stable_sort(groups.begin(), groups.end(), [](const RunGroup& a, const RunGroup& b) {
    return a.scene.particles.diameter > b.scene.particles.diameter;
  });
  return groups;
}

std::vector<std::string> swept_keys(const std::vector<RunGroup>& groups) {
  std::set<std::string> keys;
  for (const auto& group : groups) {
    for (auto& key : differing_keys(groups.front().lines, group.lines)) keys.insert(key);
  }
  return {keys.begin(), keys.end()};
}

}  // namespace clogflow::postprocess
