// Crowds of particles for tests: a settled pack and a loose cloud of many sizes.
#pragma once

#include <algorithm>
#include <random>
#include <sstream>

#include "tests/dem/laboratory.hpp"
#include "tests/test_data.hpp"

namespace clogflow::test {

/// Diameter of the pack's spheres, and of the cloud's largest [m].
inline constexpr double crowd_diameter = 33e-6;

/// Gives everything a random velocity and spin, so that every term acts: of the order of `speed`.
inline void stir(std::vector<Particle>& particles, double speed, std::mt19937& random) {
  std::normal_distribution<double> velocity(0, speed), spin(0, speed / (crowd_diameter / 2));
  for (Particle& p : particles) {
    p.vx = velocity(random), p.vy = velocity(random), p.vz = velocity(random);
    p.wx = spin(random), p.wy = spin(random), p.wz = spin(random);
  }
}

/// 1000 spheres, settled against x = 1.6 mm in the box below, stirred.
inline std::vector<Particle> packed_box(double speed) {
  std::ifstream file(test_data("packed_box_1000.txt"));
  std::vector<Particle> particles;
  for (std::string line; std::getline(file, line);) {
    if (line[0] == '#') continue;
    Particle p{.radius = crowd_diameter / 2};
    std::istringstream(line) >> p.x >> p.y >> p.z;
    particles.push_back(p);
  }
  std::mt19937 random(11);
  stir(particles, speed, random);
  return particles;
}

inline constexpr std::array<double, 3> packed_box_size{1.6e-3, 4e-4, 1e-4};

/// 400 spheres of sizes 1 to 4, many of them overlapping a little, stirred.
inline std::vector<Particle> polydisperse_cloud(double speed) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Particle> cloud;
  while (cloud.size() < 400) {
    Particle p{.radius = crowd_diameter / 2 * (0.25 + 0.75 * share(random))};
    const double size = 8 * crowd_diameter;
    p.x = size * share(random), p.y = size * share(random), p.z = size * share(random);
    const bool deep = std::ranges::any_of(cloud, [&](const Particle& q) {
      return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) < p.radius + q.radius - 0.02 * std::min(p.radius, q.radius);
    });
    if (!deep) cloud.push_back(p);
  }
  stir(cloud, speed, random);
  return cloud;
}

/// Every term of the contact law and the film between spheres.
inline Scene crowd_scene(double step) {
  Scene s = laboratory_scene({3e6, 0.35, 1062, crowd_diameter}, step);
  s.contact.restitution = 0.6;
  s.fluid.viscosity = 1.8e-3;
  s.lubrication.enabled = true;
  s.lubrication.cutoff = crowd_diameter / 2;
  set_friction(s, {.sliding = 0.5, .rolling = 0.3, .torsion = 0.2});
  s.contact.wall_friction.sliding = 0.4;
  return s;
}

}  // namespace clogflow::test
