// run_NNNN.h5: what one seed produced. Tables are groups of equally long columns, each with a unit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "coupling/files/run_record.hpp"

namespace clogflow {

/// Everything a run leaves behind; columns of a table have equal length. Times start when the gate
/// opens (start = "filled") or at the first step.
struct RunData {
  std::uint64_t seed = 0;
  std::string scene_text;  ///< effective scene
  RunRecord record;
  double end_time = 0;  ///< simulated [s]; the last lapse is censored here

  struct {
    std::vector<double> time;  ///< first crossing of passages.plane [s]
    std::vector<std::int64_t> id;
    std::vector<double> y, z;                ///< where [m]
    std::vector<std::uint8_t> friction_off;  ///< 1: while a release held friction off
    std::vector<std::int64_t> neck;          ///< which opening, in order of y; empty: there is one
    std::vector<double> radius;              ///< where particles differ, else empty [m]
    std::vector<std::int64_t> species;       ///< place in particles.species; likewise
  } passages;

  /// One row a release: friction was off in [off, on).
  struct {
    std::vector<double> off, on;        ///< [s]
    std::vector<double> largest_speed;  ///< in the clog just before, over particles within 3 neck widths [m/s]
    std::vector<double> position;       ///< x of the most downstream particle of the clog [m]
  } releases;

  struct {
    std::vector<double> time;                   ///< [s]
    std::vector<std::int64_t> count;            ///< particles in the domain
    std::vector<std::vector<double>> porosity;  ///< one row a sample, one column a strip [-]
    std::vector<double> packing_fraction;       ///< of the whole upstream channel [-]
    std::vector<double> kinetic_energy;         ///< [J]
    std::vector<double> elastic_energy;         ///< [J]
    std::vector<double> largest_overlap;        ///< [m]
    std::vector<std::int64_t> contacts;         ///< particle-particle contacts
    std::vector<std::int64_t> wall_contacts;
    std::vector<double> drag_work;      ///< since the start [J]
    std::vector<double> dissipated;     ///< since the start [J]
    std::vector<double> median_speed;   ///< half a step before the places [m/s]
    std::vector<double> speed_q99;      ///< 99 % quantile of the same [m/s]
    std::vector<double> flow_factor;    ///< q on V0; empty where it is 1 [-]
    std::vector<double> pressure_drop;  ///< over the whole channel; empty where it does not drive the flow [Pa]
  } series;

  /// Who touches whom in a snapshot, and how hard; a row a contact. Films are none.
  struct Contacts {
    std::vector<std::int64_t> a, b;  ///< ids, a < b; b = -1 is a wall
    std::vector<float> normal;       ///< from b to a [n][3] [-]
    std::vector<float> force;        ///< on a, along the normal and across it; b gets the opposite [n][3] [N]

    template <class Archive>
    void exchange(Archive& archive) {
      archive(a, b, normal, force);
    }
  };
  bool has_contacts = false;  ///< whether snapshots tell of contacts (output.contacts)

  /// The state at one time; always at the start and at the end, every output.snapshot_interval, and
  /// during a burst as output.burst_snapshots says. Vectors are interleaved [n][3].
  struct Snapshot {
    double time = 0;  ///< [s]
    std::vector<std::int64_t> id;
    std::vector<double> radius;         ///< [n] [m]
    std::vector<std::int64_t> species;  ///< [n] where particles differ, else empty
    std::vector<double> position;       ///< [m]
    std::vector<double> velocity;       ///< at the same time as the position [m/s]
    std::vector<double> spin;           ///< [rad/s]
    std::vector<double> force;          ///< of all kinds [N]
    std::vector<double> torque;         ///< [N m]
    Contacts contacts;                  ///< empty unless RunData::has_contacts

    template <class Archive>
    void exchange(Archive& archive) {
      archive(time, id, radius, species, position, velocity, spin, force, torque);
    }
  };
  std::vector<Snapshot> snapshots;

  /// Of the solver just before what only the end adds, from which a run is lengthened; empty: none. Written, but
  /// read by read_end_state() alone.
  std::string end_state;

  /// For a checkpoint, see coupling/base/archive.hpp.
  template <class Archive>
  void exchange(Archive& archive) {
    archive(seed, scene_text, record, end_time);
    archive(passages.time, passages.id, passages.y, passages.z, passages.friction_off, passages.radius,
            passages.species);
    archive(releases.off, releases.on, releases.largest_speed, releases.position);
    auto& s = series;
    archive(s.time, s.count, s.porosity, s.packing_fraction, s.kinetic_energy, s.elastic_energy, s.largest_overlap,
            s.contacts, s.wall_contacts, s.drag_work, s.dissipated, s.median_speed, s.speed_q99, snapshots);
    // Whether they are there is known from the scene.
    if (has_contacts)
      for (Snapshot& snapshot : snapshots) archive(snapshot.contacts);
  }
};

/// Rows of the tables.
struct RunRows {
  std::uint64_t passages = 0, releases = 0, series = 0, snapshots = 0;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(passages, releases, series, snapshots);
  }
};
RunRows rows_of(const RunData& run);

/// Takes away the rows beyond. \return whether there were as many
bool cut_rows(RunData& run, const RunRows& rows);

/// What makes the data impossible as the result of a run, or an empty text.
std::string fault(const RunData& run);

/// Writes beside, flushes, renames; an XDMF file for the snapshots beside it. \throws Error
void write_run_file(const RunData& run, const std::filesystem::path& file);

/// \throws Error on an unknown version, missing table or unit, unequal columns, or a truncated file
RunData read_run_file(const std::filesystem::path& file);

/// What statistics need: no snapshots, and of the series time, count, packing fraction and porosity alone.
/// \throws Error likewise, of what it reads
RunData read_run_events(const std::filesystem::path& file);

/// Only seed, scene, record and end_time. \throws Error likewise
RunData read_run_head(const std::filesystem::path& file);

/// Empty for a file of a program that kept none. \throws Error likewise
std::string read_end_state(const std::filesystem::path& file);

/// run_0007.h5
std::string run_file_name(std::uint64_t seed);

}  // namespace clogflow
