// A scene while it is being read: what the file and the overrides gave, and where.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Where a key was given and as what text, for messages.
struct Given {
  std::string where;  ///< "scenes/paper.toml:31" or "--set contact.restitution=1.3"
  std::string shown;  ///< the value as written
};

struct SceneDraft {
  Scene scene{};
  std::string name;  ///< of the file
  std::map<std::string, Given, std::less<>> given{};
  std::set<std::string, std::less<>> sections{};  ///< present in the file, even if empty

  bool has(std::string_view key) const { return given.contains(key); }
  bool has_section(std::string_view section) const { return sections.contains(section); }
  /// "scenes/paper.toml:31: contact.restitution = 1.3", or the name and the default in use.
  std::string says(std::string_view key) const;
};

/// Reads text and overrides through the key table; single values are checked, nothing else.
SceneDraft read_draft(const std::string& text, const std::string& name, const Overrides& overrides);

/// Takes from the STL file of a channel what the scene does not give, and compares what it gives.
/// \throws Error when the file is no such channel, or another one
void measure_stl(SceneDraft& draft);

/// Fills in every value that was not given. \throws Error where there is no default
void fill_defaults(SceneDraft& draft);

/// Checks that concern more than one key.
void check_scene(const SceneDraft& draft);

}  // namespace clogflow
