#include "dem/run/inlet.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "coupling/geometry/channel_shape.hpp"
#include "dem/physics/porosity.hpp"

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
      Vec3(std::min(x + slab_depth * s.particles.diameter, -narrowing_length(s.geometry)), y, s.geometry.neck_height);
  interval_ = interval_share * s.stokes_time();
  if (s.inlet.concentration > 0)
    rate_ = channel_flow_rate(s.geometry, s.inlet.concentration * s.flow.mean_velocity) /
            sphere_volume(s.particles.diameter / 2);
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

int Inlet::insert(Particles& p, const Fluid& fluid, RandomStream& random, double time) {
  const double r = model_->scene.particles.diameter / 2;
  std::vector<int> near;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p[i].x < high_.x + p[i].radius) near.push_back(static_cast<int>(i));
  const Vec3 size = high_ - low_;
  const int attempts = attempts_per_place * std::max(1, static_cast<int>(size.y * size.z / (4 * r * r)));
  int inserted = 0;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (rate_ > 0 && static_cast<double>(fed_) >= rate_ * rated_time(fluid, time)) break;
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
    Particle particle = model_->particle(r);
    particle.id = first_id_ + next_id_++;
    particle.x = c.x, particle.y = c.y, particle.z = c.z;
    const auto u = fluid.field().at(c.x, c.y, c.z);
    const double speed = fluid.drive().factor();
    particle.vx = speed * u[0], particle.vy = speed * u[1], particle.vz = speed * u[2];
    near.push_back(static_cast<int>(p.size()));
    p.add(particle);
    ++inserted;
    ++fed_;
    last_fed_ = fluid.drive().flow_time(time);
  }
  return inserted;
}

void Inlet::scatter(Particles& p, RandomStream& random) {
  const double r = model_->scene.particles.diameter / 2;
  const double end = -narrowing_length(model_->scene.geometry);
  const Vec3 low = low_ + Vec3::Constant(r), high = Vec3(end, high_.y, high_.z) - Vec3::Constant(r);
  const double section = model_->scene.geometry.inlet_area;
  const double volume = (end - low_.x) * (section > 0 ? section : (high_.y - low_.y) * (high_.z - low_.z));
  const auto wanted = static_cast<std::int64_t>(scattered_packing * volume / sphere_volume(r));
  if ((high - low).minCoeff() <= 0) return;
  // Hash of cells one diameter wide: a sphere can only overlap those in the 27 cells around.
  const auto key = [&](int x, int y, int z) {
    return (static_cast<std::int64_t>(x) << 40) ^ (static_cast<std::int64_t>(y) << 20) ^ z;
  };
  std::unordered_map<std::int64_t, std::vector<Vec3>> cells;
  const auto cell = [&](double value, double from) { return 1 + static_cast<int>((value - from) / (2 * r)); };
  std::int64_t placed = 0;
  for (std::int64_t attempt = 0; placed < wanted && attempt < attempts_per_scattered * wanted; ++attempt) {
    const Vec3 c = random_place(low, high, random);
    const int cx = cell(c.x, low.x), cy = cell(c.y, low.y), cz = cell(c.z, low.z);
    bool free = fits_round(c, r);
    for (int x = cx - 1; free && x <= cx + 1; ++x)
      for (int y = cy - 1; free && y <= cy + 1; ++y)
        for (int z = cz - 1; free && z <= cz + 1; ++z) {
          const auto found = cells.find(key(x, y, z));
          if (found == cells.end()) continue;
          for (const Vec3& other : found->second) free = free && (other - c).squaredNorm() >= 4 * r * r;
        }
    if (!free) continue;
    cells[key(cx, cy, cz)].push_back(c);
    Particle particle = model_->particle(r);
    particle.id = first_id_ + next_id_++;
    particle.x = c.x, particle.y = c.y, particle.z = c.z;
    p.add(particle);
    ++placed;
  }
}

}  // namespace clogflow
