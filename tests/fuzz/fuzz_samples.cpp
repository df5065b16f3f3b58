// Velocities sampled by OpenFOAM, on a lattice of a few points.
#include <cmath>

#include "coupling/openfoam/foam_samples.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const clogflow::FlowLattice lattice{
      .spacing = 1e-5, .x_begin = -6, .x_end = 3, .x_sampled = -4, .y_sampled = 0, .half_width = 3, .height = 5};
  return clogflow::fuzz::try_input([&] {
    const clogflow::FoamSamples samples = clogflow::read_foam_samples(clogflow::fuzz::as_file(data, size), lattice);
    for (const auto& velocity : samples.velocity)
      for (const float component : velocity) clogflow::fuzz::must(std::isfinite(component), "a velocity is finite");
  });
}
