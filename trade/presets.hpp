// From what studies measured to what the program may choose.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "trade/knobs.hpp"

namespace clogflow::trade {

/// What a setting costs and how far it can be wrong.
struct Measured {
  std::string name = {};
  Overrides overrides = {};    ///< of a scene
  double gain = 0;             ///< processor seconds a clog of the reference over its own [-]
  double within = 0;           ///< every observable is this near to the paper's particles (95 %, each) [-]
  double step_over_limit = 0;  ///< largest step over the smallest limit that the contacts had [-]
};

/// A setting as one study saw it.
struct Seen {
  Measured measured = {};
  bool is_judged = false;  ///< it is a dose, ran long enough, and its study has responses; without that only its name
                           ///< counts
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

/// Several studies (diameters) together: each setting that all of them judged with the same overrides (those aside
/// that were dearer than a study's reference), its smallest gain over the studies with the first one's reference, the
/// widest `within` of all, and the presets.
///   reference  the first setting
///   standard   the cheapest within 5 %
///   fast       the cheapest within 10 %
/// There is no preset whose tolerance no setting meets. A setting whose step came nearer than `near_limit` to the limit
/// of its contacts is no preset and no tolerance's choice, whatever these runs showed: a pack a little tighter would
/// shake.
MeasuredSettings combine(const std::vector<StudySummary>& studies);

/// \throws Error if there is none
const Measured& cheapest_within(const std::vector<Measured>& settings, double tolerance);

}  // namespace clogflow::trade
