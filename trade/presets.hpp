// From what studies measured to what the program may choose.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "trade/knobs.hpp"

namespace clogflow::trade {

/// What a setting costs and errs.
struct Measured {
  std::string name = {};
  Overrides overrides = {};    ///< of a scene
  double gain = 0;             ///< cost of the reference over its own [-]
  double error = 0;            ///< largest difference from the reference whose interval excludes zero [-]
  double hidden = 0;           ///< far end of the widest interval: what could hide [-]
  double step_over_limit = 0;  ///< largest step over the smallest limit that the contacts had [-]
};

/// A setting as one study saw it.
struct Seen {
  Measured measured = {};
  bool is_numerics = false;
  bool is_judged = false;  ///< it ran, and long enough; without that only its name counts
};

/// What counts of a study when several are put together.
struct StudySummary {
  double diameter = 0;    ///< [m]
  std::string reference;  ///< name of its most faithful setting
  std::vector<Seen> settings;
};

using Presets = std::map<std::string, std::string>;  ///< preset -> setting

struct MeasuredSettings {
  std::vector<StudySummary> studies = {};  ///< diameter and reference alone
  std::vector<Measured> settings = {};
  Presets presets = {};
};

/// Several studies (diameters) together: each setting of numerics that all of them ran with the same
/// overrides (those aside that were dearer than a study's reference), its smallest gain in cost over the
/// studies with the first one's reference, its largest errors, and the presets.
///   reference  the first setting
///   standard   the cheapest whose `error` is at most 5 %
///   fast       the cheapest whose `error` is at most 10 %
/// A setting whose step came nearer than `near_limit` to the limit of its contacts is no preset and no tolerance's
/// choice, whatever these runs showed: a pack a little tighter would shake.
MeasuredSettings combine(const std::vector<StudySummary>& studies);

/// \throws Error if there is none
const Measured& cheapest_within(const std::vector<Measured>& settings, double tolerance);

}  // namespace clogflow::trade
