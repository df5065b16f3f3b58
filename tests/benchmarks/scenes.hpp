// Scenes that the benchmarks time.
#pragma once

#include "tests/dem/kernels/clouds.hpp"

namespace clogflow::test {

/// The packed box of tests/reference, pressed against x = 1.6 mm, tiled across the flow: the same pack
/// at any size.
inline Scene tiled_box(int across, int up, const std::string& file) {
  Scene s = laboratory_scene({3e6, 0.35, 1062, crowd_diameter}, 7e-8);
  s.contact.restitution = 0.7;
  set_friction(s, {.sliding = 0.6, .rolling = 0.6, .torsion = 0.6});
  s.body_force = {1e-9, 0, 0};
  s.box.present = true;
  s.box.min = {0, 0, 0};
  s.box.max = {packed_box_size[0], across * packed_box_size[1], up * packed_box_size[2]};
  s.particles.initial = file;
  return s;
}

inline std::vector<Particle> tiled_particles(int across, int up) {
  std::vector<Particle> all;
  for (const Particle& one : packed_box(0))
    for (int a = 0; a < across; ++a)
      for (int b = 0; b < up; ++b) {
        Particle p = one;
        p.y += a * packed_box_size[1];
        p.z += b * packed_box_size[2];
        all.push_back(p);
      }
  return all;
}

}  // namespace clogflow::test
