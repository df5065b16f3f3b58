#include "ensemble/packing.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/files/run_file.hpp"
#include "coupling/files/run_pack.hpp"
#include "ensemble/seed_lock.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

constexpr const char* ledger_name = "ensemble.csv";

/// What the name of a file in the folder says of work that is not done, or an empty text.
std::string unfinished_word(const std::string& name) {
  if (name.ends_with(".part")) return "a file that was not written to its end";
  if (name.starts_with("ahead_")) return "a run whose use --until has not decided";
  if (name.starts_with("shorter_")) return "a run that is being lengthened";
  if (!name.starts_with("run_")) return "";
  if (name.find(".state") != std::string::npos) return "a run that stopped half-way";
  if (name.ends_with(".failed")) return "a run that failed";
  return "";
}

void refuse(const fs::path& folder, const std::string& name, const std::string& word) {
  throw Error(
      fmt::format("{}: is not finished ({}: {}): let the same clog run end, then pack", folder.string(), name, word));
}

/// Names of the run files, in order.
std::vector<std::string> runs_of_finished(const fs::path& folder) {
  require(fs::is_directory(folder), "{}: no such folder", folder.string());
  std::vector<std::string> runs, locks;
  bool has_folders = false;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    has_folders |= entry.is_directory();
    if (const std::string word = unfinished_word(name); !word.empty()) refuse(folder, name, word);
    if (name.starts_with("run_") && name.ends_with(".h5")) runs.push_back(name);
    if (name.starts_with("run_") && name.ends_with(".lock")) locks.push_back(name);
  }
  require(!runs.empty(), "{}: no run_*.h5 here{}", folder.string(),
          has_folders ? "; of a sweep each of its folders is packed by itself" : " (`clog run` writes them)");
  for (const std::string& lock : locks)
    if (!SeedLock::take((folder / lock).replace_extension(".h5"), "")) refuse(folder, lock, "a run at work");
  std::ranges::sort(runs);
  return runs;
}

/// The ledger knows of seeds that left no file.
void check_ledger(const fs::path& folder, const std::string& ledger) {
  std::map<std::string, std::string> last_ends;
  std::istringstream lines(ledger);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    constexpr std::size_t seed = 3, outcome = 6;
    if (cells.size() > outcome && !cells[seed].empty() &&
        cells[seed].find_first_not_of("0123456789") == std::string::npos && cells[seed].size() < 20)
      last_ends[cells[seed]] = cells[outcome];
  }
  for (const auto& [seed, end] : last_ends)
    if ((end == "failed" || end == "stopped") && !fs::exists(folder / run_file_name(std::stoull(seed))))
      refuse(folder, ledger_name, fmt::format("seed {} {}", seed, end));
}

void compare(const Packing& job, const std::vector<std::string>& runs) {
  for (const std::string& run : runs) {
    const std::string differs = run_difference(job.folder / run, job.pack / run);
    require(differs.empty(), "{}: {} differs from its file at {}: nothing is removed", job.pack.string(), run, differs);
  }
}

void remove_packed(const Packing& job, const std::vector<std::string>& runs) {
  for (const std::string& run : runs) {
    std::error_code failure, ignored;
    fs::remove(job.folder / run, failure);
    require(!failure, "{}: cannot be removed ({}); the pack is whole", (job.folder / run).string(), failure.message());
    fs::remove((job.folder / run).replace_extension(".xmf"), ignored);
  }
  std::error_code ignored;
  fs::remove(job.folder / ledger_name, ignored);
  fs::remove(job.folder, ignored);  // only if it is empty
}

}  // namespace

std::size_t pack_ensemble(const Packing& job) {
  const std::vector<std::string> runs = runs_of_finished(job.folder);
  require(!fs::exists(job.pack), "{}: is there already: remove it, or give another --out", job.pack.string());
  const fs::path ledger = job.folder / ledger_name;
  const std::string entries = fs::exists(ledger) ? read_text_file(ledger) : "";
  check_ledger(job.folder, entries);
  RunPackWriter pack(job.pack);
  for (const std::string& run : runs) pack.add(job.folder / run);
  if (!entries.empty()) pack.add_text(ledger_name, entries);
  pack.finish();
  compare(job, runs);
  if (job.remove) remove_packed(job, runs);
  return runs.size();
}

}  // namespace clogflow
