// How the numbers of a sweep change along it: <s> and alpha of every point, and the laws through them.
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "postprocess/events/run_groups.hpp"

namespace clogflow::postprocess {

/// The object `trend` of stats.json; its keys are documented in postprocess/README.md.
///
/// The mean burst `<s>` of a point is that of a memoryless stopping, all bursts used; its interval is the wider of the
/// one over seeds and the exact one of the counts, so that few seeds or few bursts do not look sure.
/// A point without a clog has a lower bound only. Laws, fitted by fit_line to the logarithms:
///   `<s>` = A exp(b x), x = (D/d)^3 when D/d varies, otherwise the swept key
///   alpha = A exp(b x), x = D/d or the key
/// Points with a bound alone are not fitted but compared with the law. Arrests that releases cut do
/// not enter the law of alpha: their range ends where the protocol ends it.
/// \param numbers group_statistics of each group
/// \source Thomas & Durian 2015, Phys. Rev. Lett. 114:178001 (exponential in (D/d)^dimension)
nlohmann::json trend(const std::vector<RunGroup>& groups, const std::vector<nlohmann::json>& numbers);

}  // namespace clogflow::postprocess
