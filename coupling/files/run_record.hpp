// Names in the record of a run, the JSON object /provenance/record of a run file: who writes and
// who reads take them from here, so that they cannot part.
#pragma once

namespace clogflow::run_record {

inline constexpr const char* wall_time = "wall_time_s";  ///< computing time [s]
inline constexpr const char* fill_time = "fill_time_s";  ///< simulated before the gate opened; 0: no gate [s]
inline constexpr const char* time_step = "time_step_s";  ///< [s]
inline constexpr const char* contact_limit =
    "contact_limit_s";  ///< shortest one that the contacts set; absent: none met [s]
inline constexpr const char* particle_steps = "particle_steps";  ///< sum of the particles over the steps
inline constexpr const char* particle_steps_per_s = "particle_steps_per_s";
inline constexpr const char* inputs_hash = "inputs_hash";  ///< of flow, walls and initial particles

}  // namespace clogflow::run_record
