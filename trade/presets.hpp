// From what studies measured to what the program may choose: by D/d, since softness matters more the larger it is.
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
  double seconds = 0;          ///< of a processor, for each clog [s]
  double within = 0;           ///< every observable is this near to the paper's particles (95 %, each) [-]
  double step_over_limit = 0;  ///< largest step over the smallest limit that the contacts had [-]
};

using Presets = std::map<std::string, std::string>;  ///< preset -> setting

/// One diameter in one neck.
struct MeasuredStudy {
  double neck_ratio = 0;                ///< D/d [-]
  std::string scene = {};               ///< as effective_scene() made it
  std::vector<Measured> settings = {};  ///< doses whose bound is known
  Presets presets = {};
};

/// The cheapest setting within a tolerance, nullptr without any. A setting whose step came nearer than `near_limit` to
/// the limit of its contacts is none, whatever these runs showed: a pack a little tighter would shake.
const Measured* cheapest_within(const std::vector<Measured>& settings, double tolerance);

///   standard   the cheapest within 5 %
///   fast       the cheapest within 10 %
/// There is no preset whose tolerance no setting meets.
Presets presets_of(const std::vector<Measured>& settings);

/// The study that speaks for a scene: that of the smallest D/d which is not below the scene's (to a thousandth), and
/// that of the largest for a scene beyond it or without a neck. \param studies  by rising D/d, not empty
const MeasuredStudy& study_for(const std::vector<MeasuredStudy>& studies, const Scene& scene);

}  // namespace clogflow::trade
