#include "dem/run/contact_lists.hpp"

#include <algorithm>

#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

/// Steps for which a sorting of the candidates holds if the fastest particle keeps its speed: rarer
/// sorting means more candidates to watch.
constexpr double sorted_steps = 32;

}  // namespace

ContactLists::ContactLists(const Model& model)
    : walls(model.walls, model.largest_radius, model.reach, model.weld), model_(model) {}

void ContactLists::change_walls(const Walls& others, const Particles& particles) {
  walls.change(others, model_.largest_radius, particles);
  outdated_ = true;
}

bool ContactLists::hold() const {
  // Two particles may approach each other by twice the way of one.
  return !outdated_ && !(2 * drifted_ > model_.reach.skin);
}

void ContactLists::rebuild(Particles& particles, const std::vector<std::uint8_t>& leaving) {
  const std::vector<int> numbers = pairs.rebuild(particles, leaving, model_.reach);
  if (!walls.empty()) walls.rebuild(particles, numbers);
  drifted_ = 0;
  outdated_ = false;
  renumbered_ = true;
  sort(particles);
}

void ContactLists::sort_if_due(const Particles& particles) {
  if (2 * (drifted_ - drifted_when_sorted_) >= margin_) sort(particles);
}

void ContactLists::sort(const Particles& particles) {
  const double skin = model_.reach.skin;
  margin_ = std::clamp(2 * sorted_steps * last_distance_, 1e-3 * skin, skin);
  drifted_when_sorted_ = drifted_;
  pairs.sort(particles, margin_, model_.laws.film);
  if (!walls.empty()) walls.sort(particles, margin_, model_.laws.wall.lubrication);
}

void ContactLists::moved(double distance) {
  last_distance_ = distance;
  drifted_ += distance;
  renumbered_ = false;
}

bool ContactLists::valid(std::size_t particles) const {
  return finite_from_zero(drifted_, last_distance_, margin_, drifted_when_sorted_) && pairs.valid(particles) &&
         walls.valid(particles);
}

}  // namespace clogflow
