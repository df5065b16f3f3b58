// Initial particles of a laboratory scene: a CSV file.
#include "dem/initial_particles.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  clog::Scene scene;
  scene.particles.diameter = 1e-5;
  scene.particles.initial = clog::fuzz::as_file(data, size).string();
  return clog::fuzz::try_input([&] {
    for (const clog::Particle& particle : clog::read_initial_particles(scene)) clog::fuzz::must(particle.radius > 0, "a radius is positive");
  });
}
