// Who may include whom. The rules are architecture; this test is what keeps them true.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "coupling/source_folder.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path root = clog::source_folder();

// The layer a file belongs to, from its path below the root: the longest folder that is listed.
const std::map<std::string, std::set<std::string>> may_include = {
    {"coupling", {"coupling"}},
    {"dem/physics", {"dem/physics", "coupling"}},
    {"dem", {"dem", "dem/physics", "coupling"}},
    {"postprocess", {"postprocess", "coupling"}},
    {"trade", {"trade", "dem", "dem/physics", "postprocess", "coupling"}},
    {"cli", {"cli", "trade", "dem", "dem/physics", "postprocess", "coupling"}},
};

std::string layer_of(const std::string& path) {
  std::string layer;
  for (const auto& [folder, allowed] : may_include)
    if (path.starts_with(folder + "/") && folder.size() > layer.size()) layer = folder;
  return layer;
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

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const auto& [folder, allowed] : may_include) {
    if (!fs::exists(root / folder) || folder == "dem/physics") continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension();
      if (extension == ".cpp" || extension == ".hpp") files.push_back(entry.path());
    }
  }
  return files;
}

std::vector<Include> all_includes() {
  std::vector<Include> all;
  for (const fs::path& file : sources())
    for (const Include& include : includes_of(file)) all.push_back(include);
  return all;
}

TEST(Layers, EveryIncludePointsDownwards) {
  ASSERT_GT(sources().size(), 20u) << "the sources are not where this test looks for them";
  for (const Include& include : all_includes()) {
    if (!include.quoted) continue;
    const std::string from = layer_of(include.file), to = layer_of(include.target);
    EXPECT_FALSE(to.empty()) << include.file << ":" << include.line << ": \"" << include.target
                             << "\" must be written with its full path";
    EXPECT_TRUE(to.empty() || may_include.at(from).contains(to))
        << include.file << ":" << include.line << ": " << from << " must not include "
        << include.target;
    EXPECT_TRUE(fs::exists(root / include.target))
        << include.file << ":" << include.line << ": there is no " << include.target;
  }
}

// A library that only some files may know.
void expect_only_in(const std::string& header, const std::set<std::string>& allowed) {
  for (const Include& include : all_includes()) {
    if (!include.target.starts_with(header)) continue;
    const bool may = std::ranges::any_of(
        allowed, [&](const std::string& prefix) { return include.file.starts_with(prefix); });
    EXPECT_TRUE(may) << include.file << ":" << include.line << ": must not include "
                     << include.target;
  }
}

TEST(Layers, LibrariesStayInTheirPlaces) {
  expect_only_in("hdf5", {"coupling/hdf5_"});
  expect_only_in("toml++", {"coupling/scene_"});
  expect_only_in("CLI/", {"cli/"});
  expect_only_in("mpi", {"dem/"});
}

TEST(Layers, PhysicsIsPure) {
  // No containers, no files, no message passing: formulas only.
  const std::set<std::string> forbidden = {"vector",   "map",        "unordered_map", "set",
                                           "list",     "deque",      "string",        "fstream",
                                           "iostream", "filesystem", "mpi.h"};
  for (const Include& include : all_includes()) {
    if (layer_of(include.file) != "dem/physics") continue;
    EXPECT_FALSE(forbidden.contains(include.target))
        << include.file << ":" << include.line << ": " << include.target;
  }
}

TEST(Layers, MessagePassingIsInOneOrTwoFiles) {
  std::set<std::string> files;
  for (const Include& include : all_includes())
    if (include.target == "mpi.h") files.insert(include.file);
  EXPECT_LE(files.size(), 2u);
}

TEST(Layers, FilesStayShort) {
  for (const fs::path& file : sources()) {
    std::ifstream stream(file);
    const auto lines = std::count(std::istreambuf_iterator<char>(stream), {}, '\n');
    EXPECT_LE(lines, 400) << fs::relative(file, root) << " holds more than one idea";
  }
}

}  // namespace
