// What a sweep varies: the keys that someone chose, and the one that the figures are drawn against.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "postprocess/events/run_groups.hpp"

namespace clogflow::postprocess {

/// Value of a key in words and, if it has one, as a number.
struct KeyValue {
  std::string text;              ///< "33 um", "60 deg", "0.6", "nearest"; "not given" for a missing key
  std::optional<double> number;  ///< [SI unit, rad for angles]
  std::string unit;              ///< SI unit, "rad", or "1"
};

KeyValue key_value(const SceneLines& lines, const std::string& key);

/// Those of swept_keys that do not follow from others: a key whose line can be left out of each scene without
/// changing its value has the default that the others imply (roughness from diameter, walls' friction
/// from the particles'). `time.end` is left out beside others: how long was watched is no property.
std::vector<std::string> chosen_keys(const std::vector<RunGroup>& groups);

/// The variable of the figures: D/d when it varies, otherwise the first chosen key; `key` is empty when
/// nothing varies.
struct SweepAxis {
  std::string key;          ///< "particles.diameter"
  bool neck_ratio = false;  ///< x is D/d, and the mean burst is drawn against its cube
  bool numeric = true;      ///< otherwise x counts the values in order of appearance
  std::string unit = "1";   ///< of x
};

SweepAxis sweep_axis(const std::vector<RunGroup>& groups, const std::vector<std::string>& chosen);

/// x of each group [unit of the axis].
std::vector<double> axis_values(const std::vector<RunGroup>& groups, const SweepAxis& axis);

/// Ensembles that differ in the axis alone share a series: "friction.rolling = 0.3" by what they have in
/// common, "" when there is one.
std::vector<std::string> series_labels(const std::vector<RunGroup>& groups, const SweepAxis& axis,
                                       const std::vector<std::string>& chosen);

/// "D/d = 3.03", and what else was chosen.
std::string group_label(const RunGroup& group, const std::vector<std::string>& chosen);

}  // namespace clogflow::postprocess
