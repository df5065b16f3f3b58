// How the numbers of a sweep change along it: <s> and alpha of every point, and the laws through them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/events/sweep_axis.hpp"
#include "postprocess/laws/weighted_line.hpp"
#include "postprocess/summary/group_statistics.hpp"

namespace clogflow::postprocess {

/// What is known of a number in a point of the sweep.
enum class PointStatus {
  measured,
  lower_bound,
  upper_bound,
  mostly_empty,  ///< more than half of the releases let nothing pass: the neck blocks, and `<s>` is of the few others
  cut_by_releases,
  cut_by_stop,
  no_passage,
  no_arrest
};

/// "measured", "lower bound", ...
const char* name(PointStatus status);

struct PointNumber {
  Estimate known;
  PointStatus status = PointStatus::measured;
};

struct TrendPoint {
  std::size_t group = 0;            ///< index of the ensemble
  std::size_t series = 0;           ///< index of the series
  double x = 0;                     ///< [unit of the axis]
  std::vector<std::string> values;  ///< of the keys of the trend, in words
  PointNumber mean_burst;
  std::size_t stops = 0, passages = 0;  ///< behind the mean burst
  PointNumber alpha;
  std::size_t ended = 0, cut = 0;  ///< arrests behind alpha: ended by a passage, and not
};

/// A point that was not fitted, and whether the law respects its bound.
struct LeftOut {
  std::size_t group = 0;
  PointStatus status = PointStatus::measured;
  double law = 0;              ///< value of the law there
  std::optional<bool> agrees;  ///< absent without a bound
};

/// quantity = A exp(b x)
struct SweepLaw {
  std::string x;                     ///< in words: "(D/d)^3"; empty where nothing varies
  std::size_t points = 0;            ///< measured ones
  std::optional<WeightedLine> line;  ///< of the logarithm: slope b, intercept ln A
  std::string refused;               ///< why there is no line
  std::vector<LeftOut> left_out;
};

/// Ensembles that differ in the variable alone.
struct TrendSeries {
  std::string label;
  SweepLaw mean_burst, alpha;
  std::vector<SweepLaw> rivals;  ///< `<s>` against other powers of D/d where D/d varies, those with a line
};

struct Trend {
  std::vector<std::string> keys;  ///< that were chosen
  SweepAxis axis;
  std::vector<TrendPoint> points;  ///< one a group
  std::vector<TrendSeries> series;
};

/// The mean burst `<s>` of a point is that of a memoryless stopping, all bursts used; its interval is the wider of the
/// one over seeds and the exact one of the counts, so that few seeds or few bursts do not look sure. Where runs stop
/// at their first clog it is that of the first, free bursts, none included.
/// A point without a clog has a lower bound only. Laws, fitted by fit_line to the logarithms:
///   `<s>` = A exp(b x), x = (D/d)^3 when D/d varies, otherwise the swept key
///   alpha = A exp(b x), x = D/d or the key
/// Points with a bound alone are not fitted but compared with the law. A neck that blocks (mostly empty) is not fitted
/// either: bursts of none do not count in `<s>`, so its `<s>` is near 1 whatever the law. Arrests that releases or the
/// stop at a clog cut do not enter the law of alpha: their range ends where the protocol ends it. \param numbers
/// group_statistics of each group \source Thomas & Durian 2015, Phys. Rev. Lett. 114:178001 (exponential in
/// (D/d)^dimension)
Trend trend(const std::vector<RunGroup>& groups, const std::vector<GroupStatistics>& numbers);

}  // namespace clogflow::postprocess
