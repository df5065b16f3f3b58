// Who may include whom. The rules are architecture; this test is what keeps them true.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "coupling/base/source_folder.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path root = clogflow::source_folder();

// The rooms, and what each may include beside itself and beside what those may include: an arrow of
// docs/architecture.md each.
const std::map<std::string, std::set<std::string>> arrows = {
    {"coupling/base", {}},
    {"coupling/geometry", {"coupling/base"}},
    {"coupling/scene", {"coupling/geometry"}},
    {"coupling/keys", {"coupling/scene"}},
    {"coupling/files", {"coupling/geometry"}},
    {"coupling/openfoam", {"coupling/scene", "coupling/files"}},
    {"coupling/flow", {"coupling/openfoam"}},
    {"dem/physics", {"coupling/base"}},
    {"dem/kernels", {"dem/physics"}},
    {"dem/state", {"dem/kernels", "coupling/scene"}},
    {"dem/contact", {"dem/state"}},
    {"dem/fluid", {"dem/state", "coupling/files"}},
    {"dem/stability", {"dem/contact", "dem/fluid"}},
    {"dem/protocol", {"dem/state"}},
    {"dem/run", {"dem/stability", "dem/protocol", "coupling/flow"}},
    {"dem/plan", {"dem/run"}},
    {"postprocess/laws", {"coupling/base"}},
    {"postprocess/events", {"postprocess/laws", "coupling/scene", "coupling/files"}},
    {"postprocess/summary", {"postprocess/events"}},
    {"postprocess/output", {"postprocess/summary"}},
    {"ensemble", {"dem/run", "postprocess/summary"}},
    {"trade", {"ensemble", "dem/plan"}},
    {"cli/reference", {"coupling/keys"}},
    {"cli", {"trade", "postprocess/output", "cli/reference"}},
};

/// Everything below a room.
std::set<std::string> below(const std::string& room) {
  std::set<std::string> rooms{room};
  for (const std::string& next : arrows.at(room)) rooms.merge(below(next));
  return rooms;
}

/// The room of a file, from its path below the root: the longest folder that is listed.
std::string room_of(const std::string& path) {
  std::string room;
  for (const auto& [folder, next] : arrows)
    if (path.starts_with(folder + "/") && folder.size() > room.size()) room = folder;
  return room;
}

struct Include {
  std::string file;
  int line;
  std::string target;
  bool quoted;
};

std::vector<Include> includes_of(const fs::path& file) {
  static const std::regex directive(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> includes;
  std::ifstream stream(file);
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line) {
    std::smatch match;
    if (std::regex_search(text, match, directive))
      includes.push_back({fs::relative(file, root).string(), line, match[2], match[1] == "\""});
  }
  return includes;
}

const std::vector<std::string> halls = {"coupling", "dem", "postprocess", "ensemble", "trade", "cli"};

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const std::string& hall : halls)
    for (const auto& entry : fs::recursive_directory_iterator(root / hall)) {
      const std::string extension = entry.path().extension();
      if (extension == ".cpp" || extension == ".hpp") files.push_back(entry.path());
    }
  return files;
}

std::vector<Include> all_includes() {
  std::vector<Include> all;
  for (const fs::path& file : sources())
    for (const Include& include : includes_of(file)) all.push_back(include);
  return all;
}

TEST(Layers, EveryFileHasARoom) {
  for (const fs::path& file : sources())
    EXPECT_NE(room_of(fs::relative(file, root).string()), "") << file << " lies in no room that this test knows";
}

TEST(Layers, EveryIncludePointsDownwards) {
  ASSERT_GT(sources().size(), 20u) << "the sources are not where this test looks for them";
  for (const Include& include : all_includes()) {
    if (!include.quoted) continue;
    const std::string from = room_of(include.file), to = room_of(include.target);
    EXPECT_FALSE(to.empty()) << include.file << ":" << include.line << ": \"" << include.target
                             << "\" must be written with its full path";
    EXPECT_TRUE(to.empty() || below(from).contains(to))
        << include.file << ":" << include.line << ": " << from << " must not include " << include.target;
    EXPECT_TRUE(fs::exists(root / include.target))
        << include.file << ":" << include.line << ": there is no " << include.target;
  }
}

// A library that only some files may know.
void expect_only_in(const std::string& header, const std::set<std::string>& allowed) {
  for (const Include& include : all_includes()) {
    if (!include.target.starts_with(header)) continue;
    const bool may =
        std::ranges::any_of(allowed, [&](const std::string& prefix) { return include.file.starts_with(prefix); });
    EXPECT_TRUE(may) << include.file << ":" << include.line << ": must not include " << include.target;
  }
}

TEST(Layers, LibrariesStayInTheirPlaces) {
  expect_only_in("hdf5", {"coupling/files/hdf5_"});
  expect_only_in("toml++", {"coupling/scene/scene_"});
  expect_only_in("CLI/", {"cli/"});
  expect_only_in("mpi", {"ensemble/"});
  // Records and statistics are structs; JSON is made and read at the edge.
  expect_only_in("nlohmann", {"coupling/base/json_text", "coupling/files/record_json", "coupling/keys/",
                              "postprocess/output/", "trade/study_file", "cli/"});
}

TEST(Layers, PhysicsIsPure) {
  // No containers, no files, no message passing: formulas only.
  const std::set<std::string> forbidden = {"vector", "map",     "unordered_map", "set",        "list", "deque",
                                           "string", "fstream", "iostream",      "filesystem", "mpi.h"};
  for (const Include& include : all_includes()) {
    // A registry has words for what it does not know.
    const bool registry = include.file.ends_with("contact_laws.cpp") || include.file.ends_with("drag_law.cpp");
    if (room_of(include.file) != "dem/physics" || registry) continue;
    EXPECT_FALSE(forbidden.contains(include.target)) << include.file << ":" << include.line << ": " << include.target;
  }
}

TEST(Layers, MessagePassingIsInOneOrTwoFiles) {
  std::set<std::string> files;
  for (const Include& include : all_includes())
    if (include.target == "mpi.h") files.insert(include.file);
  EXPECT_LE(files.size(), 2u);
}

TEST(Layers, RoomsStaySmall) {
  std::map<std::string, std::set<std::string>> units;
  for (const fs::path& file : sources()) units[room_of(fs::relative(file, root).string())].insert(file.stem());
  for (const auto& [room, names] : units) EXPECT_LE(names.size(), 24u) << room << " holds more than a stranger reads";
}

TEST(Layers, FilesStayShort) {
  for (const fs::path& file : sources()) {
    std::ifstream stream(file);
    const auto lines = std::count(std::istreambuf_iterator<char>(stream), {}, '\n');
    EXPECT_LE(lines, 400) << fs::relative(file, root) << " holds more than one idea";
  }
}

}  // namespace
