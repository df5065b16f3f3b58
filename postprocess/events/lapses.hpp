// Lapses: the times between consecutive passages, and what ended each.
#pragma once

#include <vector>

#include "coupling/files/run_file.hpp"
#include "postprocess/laws/censored.hpp"

namespace clogflow::postprocess {

/// Part of a run that counts: after the filling, until the end.
struct Window {
  double start = 0;  ///< [s]
  double end = 0;    ///< [s]
};

enum class LapseEnd {
  passage,  ///< the next particle passed: the lapse is known whole
  release,  ///< friction was switched off: the arrest would have lasted longer
  run,      ///< the run ended: likewise
};

/// "passage", "release", "run"
const char* name(LapseEnd end);

struct Lapse {
  double start = 0;     ///< when the particle before it passed [s]
  double duration = 0;  ///< T [s]
  LapseEnd end = LapseEnd::passage;
};

/// Lapses that start in the window, in order of time. A lapse starts at a passage with friction on
/// and ends at the first of: the next passage, a release, the end of the window. A passage while
/// friction is off is the doing of the release: it starts no lapse. \throws Error when the passages
/// are not in order of time
std::vector<Lapse> lapses_of(const RunData& run, const Window& window);

/// Lapses of at least the threshold: arrests. \param threshold T_min, tau/2 in the paper [s]
std::vector<Lapse> arrests_of(const std::vector<Lapse>& lapses, double threshold);

/// A run whose last arrest has lasted this many Stokes times counts as permanently clogged: the
/// rest criterion of the release protocol (`unclog.after`, default 5 tau).
inline constexpr double permanent_after = 5.0;

/// Whether nothing passed in the end for permanent_after Stokes times, or in the whole window.
/// \param lapses of the window \param tau [s]
bool ends_clogged(const std::vector<Lapse>& lapses, const Window& window, double tau);

/// For the survival analysis: what no passage ended is censored.
Observation as_observation(const Lapse& lapse);

}  // namespace clogflow::postprocess
