// The paper's channel with a made-up flow, cheap: heavy particles, a large step.
#pragma once

#include "coupling/base/source_folder.hpp"
#include "tests/dem/fluid/synthetic_flow.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {

/// The shipped scene with the numerics that cost a fifth: mass x 10, moment of inertia x 5 more, twice
/// the step; filled behind a gate, with short releases.
inline Scene cheap_paper_scene(Overrides overrides = {}) {
  overrides.insert(overrides.begin(),
                   {"time.mass_scale=10", "time.rotational_inertia_scale=5", "time.step_fraction=0.04",
                    "flow.grid_spacing=5 um", "inlet.start=filled", "unclog.protocol=release"});
  return read_scene(source_folder() / "scenes" / "paper.toml", overrides);
}

/// A short channel, for tests that only need particles, walls and an outlet.
inline Scene short_channel_scene(Overrides overrides = {}) {
  overrides.insert(overrides.begin(), {"geometry.channel_length=200 um", "inlet.taps=0"});
  return cheap_paper_scene(overrides);
}

/// Largest overlap among all pairs, over the diameter; by looking at each.
inline double deepest_pair(const Particles& p) {
  double deepest = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 1; j < p.size(); ++j)
      deepest =
          std::max(deepest, p[i].radius + p[j].radius - std::hypot(p[i].x - p[j].x, p[i].y - p[j].y, p[i].z - p[j].z));
  return deepest / (2 * p[0].radius);
}

}  // namespace clogflow::test
