#include "dem/run/inlet.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "coupling/base/expect.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "dem/state/placed_spheres.hpp"

namespace clogflow {

namespace {

/// Share of tau between two calls: fresh space appears as the flow carries particles away.
constexpr double interval_share = 0.02;

/// Attempts per call and per sphere that would fit across the slab side by side.
constexpr int attempts_per_place = 4;

/// Packing fraction of the random start; random sequential addition of spheres ends near 0.38.
constexpr double scattered_packing = 0.30;

/// Bounds the search for room; the channel is filled less densely where it ends it.
constexpr int attempts_per_scattered = 200;

/// Of a sample that found no room whole, the next one's packing fraction.
constexpr double thinner = 0.97;

/// Points across the slab, along y and z each, at which the fastest flow is looked for.
constexpr int looks = 65;

/// Depth of the slab in diameters, if the straight channel is as long: spheres enter at any depth, so no
/// layers form.
constexpr double slab_depth = 2;

/// Uniform in the box; in braces the three numbers are drawn in the order in which they stand.
Vec3 random_place(const Vec3& low, const Vec3& high, RandomStream& random) {
  return Vec3{random.uniform(low.x, high.x), random.uniform(low.y, high.y), random.uniform(low.z, high.z)};
}

}  // namespace

Inlet::Inlet(const Model& model) : model_(&model), enabled_(model.scene.inlet.enabled), rate_(model.scene.inlet.rate) {
  if (!enabled_) return;
  const Scene& s = model.scene;
  const double x = channel_start(s.geometry), y = s.geometry.channel_width / 2;
  low_ = Vec3(x, -y, 0);
  high_ =
      Vec3(std::min(x + slab_depth * model.sizes.largest(), -narrowing_length(s.geometry)), y, s.geometry.neck_height);
  interval_ = interval_share * s.stokes_time();
  if (s.inlet.concentration > 0)
    rate_ = channel_flow_rate(s.geometry, s.inlet.concentration * s.flow.mean_velocity) / model.sizes.mean_volume();
}

/// Whether a sphere lies within a round inlet; true in a rectangle, whose sides bound the places already.
bool Inlet::fits_round(const Vec3& place, double radius) const {
  const double diameter = model_->scene.geometry.inlet_diameter;
  if (diameter == 0) return true;
  return std::hypot(place.y, place.z - (low_.z + high_.z) / 2) <= diameter / 2 - radius;
}

/// Whether the flow would have brought a particle here rather than elsewhere.
bool Inlet::carries(const Fluid& fluid, const Vec3& place, RandomStream& random) {
  if (model_->scene.inlet.concentration == 0) return true;
  const bool is_first = fastest_ == 0;
  for (int k = 0; is_first && k < looks * looks; ++k) {
    const int row = k / looks, column = k % looks;
    const double y = row / (looks - 1.0), z = column / (looks - 1.0);
    const Vec3 at((low_.x + high_.x) / 2, low_.y + y * (high_.y - low_.y), low_.z + z * (high_.z - low_.z));
    fastest_ = std::max(fastest_, fluid.field().at(at.x, at.y, at.z)[0]);
  }
  return random.uniform(0, fastest_) <= fluid.field().at(place.x, place.y, place.z)[0];
}

ParticleSizes::Drawn Inlet::draw(RandomStream& random) const {
  const ParticleSizes& sizes = model_->sizes;
  if (sizes.equal()) return {model_->scene.particles.diameter, 0};
  const double which = sizes.species() > 1 ? random.uniform() : 0;
  return sizes.draw(which, random.uniform());
}

bool Inlet::is_valid(const ParticleSizes::Drawn& drawn) const {
  return finite_from_zero(drawn.diameter) && drawn.diameter <= 2 * model_->largest_radius && drawn.species >= 0 &&
         static_cast<std::size_t>(drawn.species) < model_->sizes.species();
}

void Inlet::choose_next(RandomStream& random) {
  if (next_.diameter == 0) next_ = draw(random);
}

void Inlet::put(Particles& p, const ParticleSizes::Drawn& drawn, const Vec3& c) {
  Particle particle = model_->particle(drawn);
  particle.id = first_id_ + next_id_++;
  particle.x = c.x, particle.y = c.y, particle.z = c.z;
  p.add(particle);
}

int Inlet::insert(Particles& p, const Fluid& fluid, RandomStream& random, double time) {
  const double usual = model_->scene.particles.diameter / 2;
  std::vector<int> near;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p[i].x < high_.x + p[i].radius) near.push_back(static_cast<int>(i));
  const Vec3 size = high_ - low_;
  const int attempts = attempts_per_place * std::max(1, static_cast<int>(size.y * size.z / (4 * usual * usual)));
  int inserted = 0;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (rate_ > 0 && static_cast<double>(fed_) >= rate_ * rated_time(fluid, time)) break;
    choose_next(random);
    const double r = next_.diameter / 2;
    const Vec3 c = random_place(low_ + Vec3::Constant(r), high_ - Vec3::Constant(r), random);
    if (!fits_round(c, r) || !carries(fluid, c, random)) continue;
    const bool free = std::none_of(near.begin(), near.end(), [&](int i) {
      const double apart = r + p[i].radius;
      return (Vec3(p[i].x, p[i].y, p[i].z) - c).squaredNorm() < apart * apart;
    });
    if (!free) {
      ++refused_;
      continue;
    }
    near.push_back(static_cast<int>(p.size()));
    put(p, next_, c);
    ParticleState& state = p.states.back();
    const auto u = fluid.field().at(c.x, c.y, c.z);
    const double speed = fluid.drive().factor();
    state.vx = speed * u[0], state.vy = speed * u[1], state.vz = speed * u[2];
    next_ = {0, 0};
    ++inserted;
    ++fed_;
    last_fed_ = fluid.drive().flow_time(time);
  }
  return inserted;
}

std::size_t Inlet::scatter_some(Particles& p, const std::vector<ParticleSizes::Drawn>& wanted, RandomStream& random) {
  const Vec3 corner(-narrowing_length(model_->scene.geometry), high_.y, high_.z);
  PlacedSpheres there(model_->sizes.smallest() / 2, model_->sizes.largest() / 2);
  std::size_t placed = 0;
  for (std::size_t attempt = 0; placed < wanted.size() && attempt < attempts_per_scattered * wanted.size(); ++attempt) {
    const double r = wanted[placed].diameter / 2;
    const Vec3 low = low_ + Vec3::Constant(r), high = corner - Vec3::Constant(r);
    const Vec3 c = random_place(low, high, random);
    if (!fits_round(c, r) || !there.has_room(c, r)) continue;
    there.add(c, r);
    put(p, wanted[placed], c);
    ++placed;
  }
  return placed;
}

void Inlet::scatter(Particles& p, RandomStream& random) {
  const double end = -narrowing_length(model_->scene.geometry), widest = model_->sizes.largest();
  const double section = model_->scene.geometry.inlet_area;
  const double volume = (end - low_.x) * (section > 0 ? section : (high_.y - low_.y) * (high_.z - low_.z));
  if ((Vec3(end, high_.y, high_.z) - low_).minCoeff() <= widest) return;
  const bool equal = model_->sizes.equal();
  const std::int64_t first = next_id_;
  expect(p.size() == 0);
  for (double packing = scattered_packing;; packing *= thinner) {
    std::vector<ParticleSizes::Drawn> wanted(static_cast<std::size_t>(packing * volume / model_->sizes.mean_volume()));
    for (auto& each : wanted) each = draw(random);
    std::ranges::stable_sort(wanted, std::greater<>(), &ParticleSizes::Drawn::diameter);
    // Equal ones stay as far as they came: no size is missing.
    if (scatter_some(p, wanted, random) == wanted.size() || equal) return;
    p = {};
    next_id_ = first;
  }
}

}  // namespace clogflow
