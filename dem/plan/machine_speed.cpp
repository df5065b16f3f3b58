#include "dem/plan/machine_speed.hpp"

#include <algorithm>
#include <ctime>
#include <vector>

#include "dem/run/simulation.hpp"

namespace clogflow {

namespace {

constexpr int side = 8;                        // spheres along each edge
constexpr double diameter = 33e-6;             // [m]
constexpr double apart[3] = {1.0, 1.0, 1.16};  // spacing along x, y, z, in diameters: four touch, or nearly

/// All that a scene of the paper has. The step is so small that nothing moves.
Scene lattice_scene() {
  return parse_scene(R"(
[fluid]
viscosity = "1.8e-3 Pa s"
density = "1062 kg/m3"
[flow]
source = "uniform"
velocity = ["5 mm/s", "0 mm/s", "0 mm/s"]
[particles]
diameter = "33 um"
[contact]
youngs_modulus = "3 MPa"
poisson_ratio = 0.35
[contact.friction]
sliding = 0.6
rolling = 0.6
torsion = 0.6
[lubrication]
[drag]
[time]
end = "1 s"
step = "1e-12 s"
)",
                     "the lattice of clog plan");
}

/// Two neighbours in three overlap, the others are that much apart; the same lattice every time.
std::vector<Particle> lattice_particles() {
  std::vector<Particle> all;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k) {
        Particle p{};
        p.radius = diameter / 2;
        const double shift = 2e-3 * ((i * 7 + j * 5 + k * 3) % 3);
        p.x = (i * apart[0] + shift) * diameter;
        p.y = (j * apart[1] + shift) * diameter;
        p.z = k * apart[2] * diameter;
        all.push_back(p);
      }
  return all;
}

}  // namespace

double instructions_per_second(double duration) {
  Simulation simulation(lattice_scene(), nullptr, 1, lattice_particles());
  const auto now = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  constexpr int steps = 20;
  std::vector<double> spent;
  for (const double start = now(); spent.size() < 5 || now() < start + duration;) {
    const double began = now();
    for (int k = 0; k < steps; ++k) simulation.compute_forces(), simulation.advance();
    spent.push_back((now() - began) / steps);
  }
  std::sort(spent.begin(), spent.end());
  const double step = std::max(spent[spent.size() / 4], 1e-9);
  return lattice_instructions * static_cast<double>(simulation.particles().size()) / (step * pack_slowness);
}

}  // namespace clogflow
