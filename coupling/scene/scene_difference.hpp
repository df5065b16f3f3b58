// What separates the scenes of two runs, and whether that can change what happens in them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace clogflow {

/// What a key of a scene decides in a run.
enum class KeyRole {
  trajectory,  ///< what happens: no state of one value goes on with another
  length,      ///< how long it is watched
  records,     ///< how often it is written down
  nothing,     ///< which runs are made, and when their states are saved
};

/// Every key that is not known to be harmless decides the trajectory.
KeyRole role_of(std::string_view key);

/// Keys that the scenes of earlier programs do not print, each with the value, as printed, at which nothing is
/// otherwise than it was for them.
std::span<const std::pair<std::string_view, std::string_view>> later_keys();

/// A key whose values differ, as the effective scenes print them; "nothing" where one has none.
struct SceneDifference {
  std::string key;
  std::string before, now;

  /// `time.end = "20 ms", now "40 ms"`
  std::string words() const;
};

/// In the order in which scenes are printed. Quantities are compared by value: 60 deg
/// is 1.0471975511965976 rad. \param before, now  texts that effective_scene() made, this program's
/// or an earlier one's
std::vector<SceneDifference> scene_differences(const std::string& before, const std::string& now);

/// The first of that role.
std::optional<SceneDifference> find_role(const std::vector<SceneDifference>& differences, KeyRole role);

}  // namespace clogflow
