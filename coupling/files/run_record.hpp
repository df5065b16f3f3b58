// How a run came about: the text /provenance/record of a run file.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "coupling/files/record_entry.hpp"

namespace clogflow {

struct RunRecord;

/// As one line of JSON, for a saved state.
std::string record_text(const RunRecord& record);

/// The way back. \throws Error if it is none
RunRecord run_record_of(const std::string& text);

/// Every entry may be missing: another program need not write it.
struct RunRecord {
  std::optional<std::string> program;              ///< name and version
  std::optional<std::string> revision;             ///< of its source
  std::optional<std::string> compiler;             ///< that built it
  std::optional<std::string> instruction_set;      ///< that the loops used
  std::optional<std::string> host;                 ///< where the run ended
  std::optional<std::string> flow_hash;            ///< of the flow file, if there was one
  std::optional<std::string> inputs_hash;          ///< of flow, walls and initial particles
  std::optional<std::string> step_limits;          ///< the step over each of its limits, as expected at the start
  std::optional<std::string> experiment;           ///< what was computed wrongly on purpose
  std::optional<double> wall_time;                 ///< computing time of the wall clock [s]
  std::optional<double> processor_time;            ///< the same, of the processor [s]
  std::optional<double> particle_steps;            ///< sum of the particles over the steps [-]
  std::optional<double> particle_steps_per_s;      ///< [1/s]
  std::optional<double> time_step;                 ///< [s]
  std::optional<double> contact_time;              ///< of the collision that the step is a fraction of; 0: none [s]
  std::optional<double> contact_limit;             ///< shortest step limit that the contacts set; absent: none met [s]
  std::optional<double> shaking_speed;             ///< largest of a pack that rests at whole steps only [m/s]
  std::optional<double> fill_time;                 ///< simulated before the gate opened; 0: no gate [s]
  std::optional<bool> fill_at_rest;                ///< whether the pack rested when the gate opened
  std::optional<bool> start_flowed;                ///< whether a flowing start passed its strain; it jammed if not
  std::optional<double> clogged_at;                ///< when the clog that ended the run was known to be one [s]
  std::optional<bool> clog_proved;                 ///< it is at rest for good; if not, it was waited for
  std::optional<double> clog_position;             ///< x of its most downstream particle [m]
  std::optional<double> drained_at;                ///< when the run ended because the neck was supplied no more [s]
  std::optional<std::int64_t> necks;               ///< openings at passages.plane; absent: one [-]
  std::optional<std::int64_t> poked;               ///< particles that were taken out of arches [-]
  std::optional<std::int64_t> inserted;            ///< particles by the inlet [-]
  std::optional<std::int64_t> insertions_refused;  ///< attempts that found no room [-]
  std::map<std::string, std::string> others;       ///< entries of another program: their JSON text, carried along

  static constexpr auto entries() {
    using R = RunRecord;
    return std::tuple{RecordEntry{"program", "", &R::program},
                      RecordEntry{"revision", "", &R::revision},
                      RecordEntry{"compiler", "", &R::compiler},
                      RecordEntry{"instruction_set", "", &R::instruction_set},
                      RecordEntry{"host", "", &R::host},
                      RecordEntry{"flow_hash", "", &R::flow_hash},
                      RecordEntry{"inputs_hash", "", &R::inputs_hash},
                      RecordEntry{"step_limits", "", &R::step_limits},
                      RecordEntry{"experiment", "", &R::experiment},
                      RecordEntry{"wall_time_s", "s", &R::wall_time},
                      RecordEntry{"processor_time_s", "s", &R::processor_time},
                      RecordEntry{"particle_steps", "1", &R::particle_steps},
                      RecordEntry{"particle_steps_per_s", "1/s", &R::particle_steps_per_s},
                      RecordEntry{"time_step_s", "s", &R::time_step},
                      RecordEntry{"contact_time_s", "s", &R::contact_time},
                      RecordEntry{"contact_limit_s", "s", &R::contact_limit},
                      RecordEntry{"shaking_speed_m_s", "m/s", &R::shaking_speed},
                      RecordEntry{"fill_time_s", "s", &R::fill_time},
                      RecordEntry{"fill_at_rest", "", &R::fill_at_rest},
                      RecordEntry{"start_flowed", "", &R::start_flowed},
                      RecordEntry{"clogged_at_s", "s", &R::clogged_at},
                      RecordEntry{"clog_proved", "", &R::clog_proved},
                      RecordEntry{"clog_position_m", "m", &R::clog_position},
                      RecordEntry{"drained_at_s", "s", &R::drained_at},
                      RecordEntry{"necks", "1", &R::necks},
                      RecordEntry{"poked", "1", &R::poked},
                      RecordEntry{"inserted", "1", &R::inserted},
                      RecordEntry{"insertions_refused", "1", &R::insertions_refused}};
  }

  /// For a checkpoint, see coupling/base/archive.hpp.
  template <class Archive>
  void exchange(Archive& archive) {
    std::string text;
    if constexpr (!Archive::loading) text = record_text(*this);
    archive(text);
    if constexpr (Archive::loading) *this = run_record_of(text);
  }

  bool operator==(const RunRecord&) const = default;
};

}  // namespace clogflow
