#include "dem/run/contact_lists.hpp"

#include <algorithm>

#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

/// Steps for which a sorting of the candidates holds if the fastest particle keeps its speed: rarer
/// sorting means more candidates to watch.
constexpr double sorted_steps = 32;

double fastest_speed(const Particles& particles) {
  double most = 0;
  for (const ParticleState& p : particles.states) most = std::max(most, p.velocity().squaredNorm());
  return std::sqrt(most);
}

}  // namespace

ContactLists::ContactLists(const Model& model)
    : walls(model.walls, model.largest_radius, model.reach, model.weld), model_(model) {}

void ContactLists::change_walls(const Walls& others, const Particles& particles) {
  walls.change(others, model_.largest_radius, particles);
  outdated_ = true;
}

double ContactLists::room_left(const Particles& p) const {
  double left = model_.reach.skin;
  for (std::size_t i = 0; i < p.size(); ++i)
    left = std::min(left, pairs.room[i] - (p[i].position() - made_at_[i]).norm());
  return left;
}

bool ContactLists::hold(const Particles& particles) {
  if (outdated_) return false;
  if (drifted_ - drifted_when_seen_ <= room_left_) return true;
  room_left_ = room_left(particles);
  drifted_when_seen_ = drifted_;
  return room_left_ >= 0;
}

void ContactLists::rebuild(Particles& particles, const std::vector<std::uint8_t>& leaving, Team& team) {
  Reach reach = model_.reach;
  const double fastest = fastest_speed(particles);
  if (fastest > 0) reach.hold_time = reach.skin / 2 / fastest;
  const std::vector<int> numbers = pairs.rebuild(particles, leaving, reach, team);
  if (!walls.empty()) walls.rebuild(particles, numbers, pairs.room);
  made_at_.clear();
  for (const ParticleState& p : particles.states) made_at_.push_back(p.position());
  drifted_ = drifted_when_seen_ = 0;
  room_left_ = room_left(particles);
  outdated_ = false;
  renumbered_ = true;
  sort(particles, team);
}

void ContactLists::sort_if_due(const Particles& particles, Team& team) {
  if (2 * (drifted_ - drifted_when_sorted_) >= margin_) sort(particles, team);
}

void ContactLists::sort(const Particles& particles, Team& team) {
  const double skin = 2 * model_.reach.least_room;
  margin_ = std::clamp(2 * sorted_steps * last_distance_, 1e-3 * skin, skin);
  drifted_when_sorted_ = drifted_;
  pairs.sort(particles, margin_, model_.laws.film, team);
  if (!walls.empty()) walls.sort(particles, margin_, model_.laws.wall.lubrication);
}

void ContactLists::moved(double distance) {
  last_distance_ = distance;
  drifted_ += distance;
  renumbered_ = false;
}

bool ContactLists::valid(std::size_t particles) const {
  const bool has_rooms = made_at_.size() == particles && pairs.room.size() == particles;
  return finite_from_zero(drifted_, drifted_when_seen_, last_distance_, margin_, drifted_when_sorted_) &&
         (outdated_ || has_rooms) && pairs.valid(particles) && walls.valid(particles);
}

}  // namespace clogflow
