// The stability map: measures points of equal spheres and of every further term, and prints one CSV line each.

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "trade/stability_terms.hpp"

namespace {

constexpr const char* integrators[] = {"verlet", "implicit_drag", "implicit_fluid"};

std::string axes(const clogflow::ExtremePoint& p) {
  return fmt::format("{},{:.4g},{:.4g},{:.4g},{:.4g},{:.3g},{:.3g},{:.3g},{},{:.3g},{:d},{}", p.number, p.diameter,
                     p.viscosity, p.youngs_modulus, p.velocity, p.porosity, p.friction, p.restitution, p.particles,
                     p.step_fraction, p.films, integrators[static_cast<int>(p.integrator)]);
}

std::string found(const clogflow::StepVerdict& r) {
  return fmt::format("{:.4g},{:.4g},{:.4g},{:d},{:.4g},{:d},{},\"{}\"", r.step, r.expected, r.predicted, r.at_rest,
                     r.measured, r.capped, name(r.verdict), r.reason);
}

std::string further_axes(const clogflow::TermPoint& p) {
  return fmt::format("{},{:.3g},{:.3g},{:.3g},{},{:.3g},{:.3g},{:d},{},{:.3g},{:.3g},{},{},{:.3g},{:.3g},{:.3g}",
                     name(p.term), p.size_ratio, p.density_ratio, p.friction_share, p.law, p.stickiness, p.spring,
                     p.mercury, p.drag, p.weight, p.amplitude, p.shape, p.periods, p.drop_ratio, p.compliance_steps,
                     p.wall_ratio);
}

void print(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace clogflow;
  const int count = argc > 1 ? std::atoi(argv[1]) : 300, each = argc > 2 ? std::atoi(argv[2]) : 0;
  const std::string only = argc > 3 ? argv[3] : "";
  if (argc > 4 || count < 0 || each < 0 || count + each < 1) {
    fmt::print(
        stderr,
        "usage: stability_map [COUNT [EACH [TERM]]]   (COUNT columns of equal spheres, default 300, EACH of every "
        "further term, default 0, or of one; CSV on standard output)\n");
    return 2;
  }
  print(
      "number,diameter,viscosity,youngs_modulus,velocity,porosity,friction,restitution,particles,"
      "step_fraction,films,integrator,step,expected,predicted,at_rest,measured,capped,verdict,reason,"
      "term,size_ratio,density_ratio,friction_share,law,stickiness,spring,mercury,drag,weight,amplitude,shape,periods,"
      "drop_ratio,compliance_steps,wall_ratio");
  for (int k = 1; k <= count; ++k) {
    const ExtremePoint p = extreme_point(k);
    print(fmt::format("{},{},equal,1,1,1,hertz,0,0,0,hoef,0,0,none,1,1,0,1", axes(p), found(measure(p))));
  }
  for (int t = 0; t < term_count; ++t) {
    if (!only.empty() && only != name(static_cast<Term>(t))) continue;
    for (int k = 1; k <= each; ++k) {
      const TermPoint p = term_point(static_cast<Term>(t), k);
      print(fmt::format("{},{},{}", axes(p.base), found(measure(p)), further_axes(p)));
    }
  }
}
