// Cost against error: what a study found, as data.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "trade/study.hpp"

namespace clogflow::trade {

/// Fewer whole bursts than this in a sample, and no difference of it is judged.
inline constexpr double least_bursts = 10;

/// Everything a study measured, and what it did not run; keys are documented in trade/README.md. The
/// reference is the first setting of the matrix that has runs. Cost is particle-steps per simulated
/// second, which the load of the machine does not change; seconds stand beside it.
nlohmann::json study_results(const Study& study);

/// Several studies (diameters) together: each setting of numerics that all of them ran with the same
/// overrides (those aside that were dearer than a study's reference), its smallest gain in cost over the
/// studies with the first one's reference, its largest errors, and the presets.
///   reference  the first setting
///   standard   the cheapest whose `error` is at most 5 %
///   fast       the cheapest whose `error` is at most 10 %
/// `error` is the largest difference from the reference, over observables and studies, whose interval
/// excludes zero; `hidden` is the far end of the widest interval: what could hide. A setting whose step came
/// nearer than `near_limit` to the limit of its contacts is no preset and no tolerance's choice, whatever
/// these runs showed: a pack a little tighter would shake.
nlohmann::json combine(const std::vector<nlohmann::json>& studies);

/// Cheapest entry of `measured` within a tolerance. \throws Error if there is none
const nlohmann::json& cheapest_within(const nlohmann::json& measured, double tolerance);

/// A table for a person.
std::string table(const nlohmann::json& results);

}  // namespace clogflow::trade
