// The stability map: measures COUNT extreme points and prints one CSV line each.

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "trade/stability.hpp"

namespace {
constexpr const char* integrators[] = {"verlet", "implicit_drag", "implicit_fluid"};
}

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 300;
  if (argc > 2 || count < 1) {
    fmt::print(stderr, "usage: stability_map [COUNT]   (default 300 points, CSV on standard output)\n");
    return 2;
  }
  fmt::print(
      "number,diameter,viscosity,youngs_modulus,velocity,porosity,friction,restitution,particles,"
      "step_fraction,films,integrator,step,expected,predicted,at_rest,measured,capped,verdict,reason\n");
  for (const clogflow::ExtremePoint& p : clogflow::extreme_points(count)) {
    const clogflow::StabilityResult r = clogflow::measure(p);
    fmt::print(
        "{},{:.4g},{:.4g},{:.4g},{:.4g},{:.3g},{:.3g},{:.3g},{},{:.3g},{:d},{},{:.4g},{:.4g},"
        "{:.4g},{:d},{:.4g},{:d},{},\"{}\"\n",
        p.number, p.diameter, p.viscosity, p.youngs_modulus, p.velocity, p.porosity, p.friction, p.restitution,
        p.particles, p.step_fraction, p.films, integrators[static_cast<int>(p.integrator)], r.step, r.expected,
        r.predicted, r.at_rest, r.measured, r.capped, name(r.verdict), r.reason);
    std::fflush(stdout);
  }
}
