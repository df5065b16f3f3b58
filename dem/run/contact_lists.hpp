// Who may touch whom, and for how long that holds.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "dem/contact/neighbours.hpp"
#include "dem/contact/wall_contacts.hpp"
#include "dem/run/model.hpp"

namespace clogflow {

/// The pair list and the wall contacts. They are made anew when a particle has gone farther than its room,
/// and their candidates sorted anew, which is cheap, when a gap may have changed by more than a margin.
class ContactLists {
public:
  explicit ContactLists(const Model& model);

  Neighbours pairs;
  WallContacts walls;

  /// Particles came: what is listed is not all.
  void outdate() { outdated_ = true; }

  /// Puts other walls in place; what touches them goes on.
  void change_walls(const Walls& walls, const Particles& particles);

  /// Whether all that can meet is listed.
  bool hold(const Particles& particles);

  /// Drops the particles marked in `leaving`, numbers the others anew and lists who may meet.
  void rebuild(Particles& particles, const std::vector<std::uint8_t>& leaving, Team& team);

  /// Sorts the candidates, if any gap may have changed by the margin.
  void sort_if_due(const Particles& particles, Team& team);

  /// The fastest particle went so far in a step [m].
  void moved(double distance);

  /// Whether the particles were numbered anew since they moved last.
  bool renumbered() const { return renumbered_; }

  /// Whether lists read from a saved state fit these many particles.
  bool valid(std::size_t particles) const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(pairs, walls, made_at_, room_left_, drifted_, drifted_when_seen_, last_distance_, margin_,
            drifted_when_sorted_, outdated_, renumbered_);
  }

private:
  void sort(const Particles& particles, Team& team);

  /// Of the room of every particle the least that is left; below 0 if one has gone too far [m].
  double room_left(const Particles& particles) const;

  const Model& model_;
  std::vector<Vec3> made_at_;  // where each particle was when the lists were made [m]
  double room_left_ = 0;       // of every particle, when last looked at [m]
  double drifted_ = 0;         // bound on any particle's way since the lists were made [m]
  double last_distance_ = 0;   // of the fastest particle in the last step [m]
  double margin_ = 0;          // gaps may change by this much before the candidates are sorted anew [m]
  double drifted_when_seen_ = 0, drifted_when_sorted_ = 0;
  bool outdated_ = true, renumbered_ = false;
};

}  // namespace clogflow
