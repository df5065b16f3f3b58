#include "dem/run/initial_placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/base/require.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "dem/contact/closest_point.hpp"
#include "dem/contact/size_levels.hpp"
#include "dem/contact/wall_bins.hpp"

namespace clogflow {

namespace {

std::string text_of(const Vec3& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

/// "pack.csv:7: the particle at (0, 0, 0) m"
std::string name_of(const InitialParticles& initial, std::size_t k, const Model& model) {
  return fmt::format("{}:{}: the particle at {} m", model.scene.particles.initial, initial.lines[k],
                     text_of(initial.particles[k].position()));
}

void check_extent(const InitialParticles& initial, const Model& model) {
  const Domain& d = model.domain;
  for (std::size_t k = 0; k < initial.particles.size(); ++k) {
    const Vec3 place = initial.particles[k].position();
    require(place.x <= d.outlet, "{} lies beyond the outlet at x = {:.4g} m: leave it out", name_of(initial, k, model),
            d.outlet);
    require(place.within(d.low, d.high),
            "{} lies outside the walls, which reach from {} to {} m: are the units right (\"x "
            "[um],y [um],z [um]\" in the header{})?",
            name_of(initial, k, model), text_of(d.low), text_of(d.high),
            model.scene.geometry.stl.empty() ? "" : ", geometry.stl_unit");
  }
}

/// The walls around a place, in larger and larger surroundings until something is there.
class NearestWall {
public:
  NearestWall(const Walls& walls, double reach) : walls_(walls) {
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (const Triangle& t : walls)
      for (const Vec3& corner : t.corner) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
    const double size = (high - low).norm();
    for (double r = reach; bins_.empty() || reaches_.back() < size; r *= 8) {
      reaches_.push_back(r);
      bins_.emplace_back(walls, r);
    }
  }

  struct Found {
    double distance = 1e300;  ///< [m]
    double height = 0;        ///< over the plane of the triangle that faces the place most; < 0: behind it [m]
  };

  Found find(const Vec3& place) const {
    Found found;
    for (std::size_t level = 0; level < bins_.size(); ++level) {
      for (const int t : bins_[level].near(place)) look(walls_[t], place, found);
      if (found.distance < reaches_[level]) break;
    }
    return found;
  }

private:
  static void look(const Triangle& t, const Vec3& place, Found& found) {
    const Vec3 point = closest_point(t, place).point, away = place - point;
    const double distance = away.norm(), tie = 1e-9 * distance;
    if (distance > found.distance + tie) return;
    const double height = dot(cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]).normalized(), away);
    // Triangles that meet in the nearest point are equally near; the one that is faced most knows
    // the side.
    if (distance < found.distance - tie || std::abs(height) > std::abs(found.height)) found.height = height;
    found.distance = std::min(found.distance, distance);
  }

  const Walls& walls_;
  std::vector<double> reaches_;
  std::vector<WallBins> bins_;
};

void check_walls(const InitialParticles& initial, const Model& model) {
  if (model.walls.empty()) return;
  const Scene& s = model.scene;
  // Walls of a laboratory may be plates without an inside; those of a channel face the fluid.
  const bool sided = s.geometry.present && (s.geometry.stl.empty() || is_stl_channel(s.geometry));
  double largest = 0;
  for (const Particle& p : initial.particles) largest = std::max(largest, p.radius);
  const NearestWall walls(model.walls, largest);
  for (std::size_t k = 0; k < initial.particles.size(); ++k) {
    const Particle& p = initial.particles[k];
    const auto wall = walls.find(p.position());
    require(!sided || wall.height >= 0, "{} lies in the solid, {:.3g} m behind a wall: move it into the channel",
            name_of(initial, k, model), wall.distance);
    const double overlap = p.radius - wall.distance, share = overlap / (2 * p.radius);
    require(share <= deepest_start,
            "{} overlaps a wall by {:.3g} m, {:.2g} of its diameter (no more than {} at the "
            "start): move it, or lower its radius",
            name_of(initial, k, model), overlap, share, deepest_start);
  }
}

/// Overlap over the smaller diameter.
double overlap_share(const Particle& p, const Particle& q) {
  return (p.radius + q.radius - (p.position() - q.position()).norm()) / (2 * std::min(p.radius, q.radius));
}

void check_pairs(const InitialParticles& initial, const Model& model) {
  Particles all;
  for (const Particle& p : initial.particles) all.add(p);
  const auto [least, most] = std::ranges::minmax_element(all.states, {}, &ParticleState::radius);
  // The first that overlaps one of an earlier line.
  int first = std::numeric_limits<int>::max(), other = 0;
  SizeLevels(all, {}, (*most).radius, (*least).radius).for_each_pair([&](int i, int j) {
    if (j <= first && overlap_share(initial.particles[i], initial.particles[j]) > deepest_start &&
        (j < first || i < other))
      first = j, other = i;
  });
  if (first == std::numeric_limits<int>::max()) return;
  const Particle &p = initial.particles[first], &q = initial.particles[other];
  const double share = overlap_share(p, q);
  throw Error(
      fmt::format("{} overlaps that of line {} by {:.3g} m, {:.2g} of the smaller diameter (no more than {} at the "
                  "start): move one of them, or lower its radius",
                  name_of(initial, first, model), initial.lines[other], share * 2 * std::min(p.radius, q.radius), share,
                  deepest_start));
}

}  // namespace

void check_placement(const InitialParticles& initial, const Model& model) {
  if (initial.particles.empty()) return;
  const auto& inlet = model.scene.inlet;
  require(!inlet.enabled || inlet.start == InletStart::empty,
          "particles.initial = \"{}\" (inlet.start = \"{}\" scatters its own particles over "
          "the channel, onto those): set "
          "inlet.start = \"empty\", or leave out particles.initial",
          model.scene.particles.initial, inlet.start == InletStart::filled ? "filled" : "flowing");
  check_extent(initial, model);
  check_walls(initial, model);
  check_pairs(initial, model);
}

}  // namespace clogflow
