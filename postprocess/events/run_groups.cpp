// From folders to ensembles.
#include "postprocess/events/run_groups.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "coupling/base/archive.hpp"
#include "coupling/base/in_processes.hpp"
#include "coupling/base/require.hpp"
#include "coupling/files/run_pack.hpp"
#include "postprocess/events/run_digest.hpp"

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

/// Takes the digests of run files in the order of the files.
class Gatherer {
public:
  Gatherer(std::optional<double> threshold, std::size_t readers) : threshold_(threshold), kinds_(readers) {}

  /// \param reader  who made it: its kinds are numbered for itself
  void add(const fs::path& file, std::size_t reader, RunDigest digest) {
    std::vector<RunKind>& kinds = kinds_[reader];
    if (digest.kind_is_new) kinds.push_back(std::move(digest.new_kind));
    require(digest.kind_known, "{}", digest.error);
    const RunKind& kind = kinds.at(digest.kind);
    const auto known = folders_.try_emplace(folder_of(file), Known{kind.lines, file});
    require_same_scene(kind.lines, file, known.first->second);
    const std::size_t index = group_of(kind, digest.necks, file);
    require(digest.error.empty(), "{}", digest.error);
    RunGroup& group = groups_[index];
    const auto [earlier, is_new] = seeds_[index].emplace(digest.record.seed, file);
    require(is_new, "{}: seed {} of this scene was already read from {}", file.string(), digest.record.seed,
            earlier->second.string());
    const std::int64_t necks = std::max<std::int64_t>(1, std::ssize(group.necks));
    require(digest.necks == necks,
            "{}: counted at {} necks, the runs before it at {}: made by different programs, so they do not mix",
            file.string(), digest.necks, necks);
    group.records.push_back(std::move(digest.record));
    group.records.back().file = file;
    for (std::size_t k = 0; k < group.necks.size(); ++k) {
      group.necks[k].push_back(std::move(digest.of_necks[k]));
      group.necks[k].back().file = file;
    }
  }

  std::vector<RunGroup> result() && { return std::move(groups_); }

private:
  const fs::path& folder_of(const fs::path& file) {
    const fs::path parent = file.parent_path();
    if (last_parent_ != parent || last_folder_.empty()) {
      last_parent_ = parent;
      last_folder_ = fs::canonical(fs::absolute(file).parent_path());
    }
    return last_folder_;
  }

  std::size_t group_of(const RunKind& kind, std::int64_t necks, const fs::path& file) {
    const auto found = std::ranges::find(groups_, kind.lines, &RunGroup::lines);
    if (found != groups_.end()) return static_cast<std::size_t>(found - groups_.begin());
    RunGroup group;
    group.scene = parse_scene(kind.scene_text, file.string());
    group.scene_text = kind.scene_text;
    group.lines = kind.lines;
    group.scale = clog_scale(group.scene, threshold_, file.string());
    group.record = run_record_of(kind.record);
    if (necks > 1) group.necks.resize(static_cast<std::size_t>(necks));
    groups_.push_back(std::move(group));
    seeds_.emplace_back();
    return groups_.size() - 1;
  }

  std::optional<double> threshold_;
  std::vector<std::vector<RunKind>> kinds_;  ///< of each reader
  std::vector<RunGroup> groups_;
  std::vector<std::unordered_map<std::uint64_t, fs::path>> seeds_;  ///< of each group, and where each was read
  std::map<fs::path, Known> folders_;
  fs::path last_parent_, last_folder_;
};

/// So few files are read before further processes have begun.
constexpr std::size_t files_for_processes = 32;

void read_all(const std::vector<fs::path>& files, std::size_t readers, std::optional<double> threshold,
              Gatherer& gatherer) {
  DigestMaker maker(threshold);
  in_processes(
      files.size(), readers,
      [&](std::size_t i) {
        RunDigest digest = maker.digest_of(files[i]);
        ArchiveWriter archive;
        archive(digest);
        return archive.bytes();
      },
      [&](std::size_t i, std::string bytes) {
        RunDigest digest;
        ArchiveReader archive(std::move(bytes));
        archive(digest);
        gatherer.add(files[i], i % readers, std::move(digest));
      });
}

}  // namespace

std::vector<fs::path> find_run_files(const fs::path& folder) {
  if (fs::is_regular_file(folder)) return runs_in_pack(folder);
  require(fs::is_directory(folder), "{}: no such folder, and no pack of runs", folder.string());
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

std::vector<fs::path> unfinished_seeds(const std::vector<fs::path>& folders) {
  constexpr auto readable = fs::directory_options::skip_permission_denied;
  std::set<fs::path> states;
  for (const fs::path& folder : folders) {
    if (!fs::is_directory(folder)) continue;
    std::set<fs::path> within{folder};
    for (const auto& entry : fs::directory_iterator(folder, readable))
      if (entry.is_directory()) within.insert(entry.path());
    for (const fs::path& one : within)
      for (const auto& entry : fs::directory_iterator(one, readable)) {
        const fs::path& file = entry.path();
        if (file.extension() != ".state" || !file.filename().string().starts_with("run_")) continue;
        if (!fs::exists(fs::path(file).replace_extension(".h5"))) states.insert(file);
      }
  }
  return {states.begin(), states.end()};
}

std::vector<std::string> points_without_runs(const fs::path& folder) {
  std::vector<std::string> points;
  if (!fs::is_directory(folder)) return points;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && name.find('=') != std::string::npos && run_files_right_in(entry.path()).empty())
      points.push_back(name);
  }
  std::sort(points.begin(), points.end());
  return points;
}

std::vector<RunGroup> gather(const std::vector<fs::path>& folders, std::optional<double> threshold,
                             std::size_t most_readers) {
  std::vector<fs::path> files;
  std::set<fs::path> seen;
  for (const auto& folder : folders) {
    for (auto& file : find_run_files(folder))
      if (seen.insert(fs::weakly_canonical(file)).second) files.push_back(std::move(file));
  }
  const std::size_t readers = files.size() < files_for_processes ? 1 : most_readers > 0 ? most_readers : usable_cores();
  Gatherer gatherer(threshold, readers);
  read_all(files, readers, threshold, gatherer);
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
