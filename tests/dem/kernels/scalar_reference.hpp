// The slowest solver there is: every pair looked at, every contact in double, springs in a map. What
// the fast one must agree with.
#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "dem/physics/lubrication.hpp"
#include "dem/run/simulation.hpp"

namespace clogflow::test {

struct Loads {
  std::vector<Vec3> force, torque;  ///< in order of id
  std::int64_t contacts = 0, wall_contacts = 0, films = 0;
};

/// Pairs and the six planes of a box (closed form); takes the state from a simulation at each call
/// and keeps only the springs.
class ScalarReference {
public:
  Loads loads(const Simulation& simulation, double dt) {
    const Model& model = simulation.model();
    const Particles& p = simulation.particles();
    Loads sum;
    const Vec3 zero{0, 0, 0};
    sum.force.assign(p.size(), zero), sum.torque.assign(p.size(), zero);
    std::map<std::pair<int, int>, Springs<double>> touching;
    std::vector<int> index(p.size());
    for (std::size_t k = 0; k < p.size(); ++k) index[p.id[k]] = static_cast<int>(k);
    for (int a = 0; a < static_cast<int>(p.size()); ++a)
      for (int b = a + 1; b < static_cast<int>(p.size()); ++b)
        pair(model, p, {a, b}, {index[a], index[b]}, dt, touching, sum);
    if (model.scene.box.present)
      for (int a = 0; a < static_cast<int>(p.size()); ++a) box(model, p, a, index[a], dt, touching, sum);
    springs_ = std::move(touching);
    return sum;
  }

private:
  static constexpr ContactTerms all{true, true, true};
  using Touching = std::map<std::pair<int, int>, Springs<double>>;

  Springs<double> remembered(const std::pair<int, int>& key) const {
    const auto found = springs_.find(key);
    return found == springs_.end() ? Springs<double>{} : found->second;
  }

  static Vec3 place(const Particles& p, int i) { return p[i].position(); }
  static Vec3 velocity(const Particles& p, int i) { return p[i].velocity(); }
  static Vec3 spin(const Particles& p, int i) { return p[i].spin(); }

  /// Spheres of one size have a loop of their own, with one thing less.
  static bool are_equal(const Particles& p) {
    return std::ranges::adjacent_find(p.states, std::not_equal_to<>(), &ParticleState::radius) == p.states.end();
  }

  void pair(const Model& model, const Particles& p, const std::pair<int, int>& id, const std::pair<int, int>& at,
            double dt, Touching& touching, Loads& sum) {
    const auto [i, j] = at;
    const Vec3 apart = place(p, i) - place(p, j);
    const double distance = std::sqrt(dot(apart, apart));
    const double gap = distance - p[i].radius - p[j].radius;
    const double radius = p[i].radius * p[j].radius / (p[i].radius + p[j].radius);
    const Vec3 normal = (1 / distance) * apart;
    const Vec3 moves = velocity(p, i) - velocity(p, j);
    Vec3 force{0, 0, 0};
    if (gap < 0) {
      ++sum.contacts;
      Springs<double> springs = remembered(id);
      const ContactGeometry<double> g{normal,
                                      -gap,
                                      radius,
                                      p[i].mass * p[j].mass / (p[i].mass + p[j].mass),
                                      p[i].radius + gap / 2,
                                      p[j].radius + gap / 2,
                                      are_equal(p) ? 0 : 1 / distance};
      const auto loads =
          model.laws.pair.at(0, p.species[i], p.species[j]).loads(g, {moves, spin(p, i), spin(p, j)}, dt, springs);
      touching[id] = springs;
      force = loads.force;
      sum.torque[id.first] = sum.torque[id.first] + loads.torque_i;
      sum.torque[id.second] = sum.torque[id.second] + loads.torque_j;
    } else if (const auto& film = model.laws.film;
               film.viscosity > 0 && gap <= film.farthest && (film.clamp || gap >= film.nearest)) {
      ++sum.films;
      const double c = lubrication_coefficient(film.viscosity, radius, std::max(gap, film.nearest));
      force = (-c * dot(moves, normal)) * normal;
    }
    sum.force[id.first] = sum.force[id.first] + force;
    sum.force[id.second] = sum.force[id.second] - force;
  }

  void box(const Model& model, const Particles& p, int id, int i, double dt, Touching& touching, Loads& sum) {
    const double centre[3] = {p[i].x, p[i].y, p[i].z};
    for (int wall = 0; wall < 6; ++wall) {
      const int axis = wall / 2;
      const bool upper = wall % 2;
      const double height = upper ? model.scene.box.max[axis] - centre[axis] : centre[axis] - model.scene.box.min[axis];
      const double overlap = p[i].radius - height;
      if (overlap <= 0) continue;
      ++sum.wall_contacts;
      double n[3] = {0, 0, 0};
      n[axis] = upper ? -1 : 1;
      Springs<double> springs = remembered({-1 - wall, id});
      const ContactGeometry<double> g{{n[0], n[1], n[2]},        overlap, p[i].radius, p[i].mass,
                                      p[i].radius - overlap / 2, 0};
      const ContactLaw law = model.laws.wall.contact.at(0, p.species[i], 0);
      const auto loads = law.loads(g, {velocity(p, i), spin(p, i), {0, 0, 0}}, dt, springs);
      touching[{-1 - wall, id}] = springs;
      sum.force[id] = sum.force[id] + loads.force;
      sum.torque[id] = sum.torque[id] + loads.torque_i;
    }
  }

  Touching springs_;
};

}  // namespace clogflow::test
