// Initial particles of a laboratory scene: a CSV file.
#include "dem/state/initial_particles.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  clogflow::Scene scene;
  scene.particles.diameter = 1e-5;
  scene.particles.initial = clogflow::fuzz::as_file(data, size).string();
  return clogflow::fuzz::try_input([&] {
    for (const clogflow::Particle& particle : clogflow::read_initial_particles(scene))
      clogflow::fuzz::must(particle.radius > 0, "a radius is positive");
  });
}
