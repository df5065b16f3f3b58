// How much of the core's arithmetic the contact loop uses, as two lines of Markdown:
//   build/release/bin/roofline
// Operations are counted by running the formulas on a number type that counts; the core's peak is
// measured with multiply-adds that depend on nothing.
#include <chrono>
#include <cstdio>

#include <fmt/format.h>

#include "dem/contact/neighbours.hpp"
#include "dem/physics/laws/hertz.hpp"
#include "tests/benchmarks/scenes.hpp"

namespace clogflow::test {

/// A double that counts what is done with it; a root or a division counts as one.
struct Counted {
  double value = 0;
  static inline int done = 0;

  Counted() = default;
  Counted(double v) : value(v) {}  // NOLINT: as any number type
  friend Counted operator+(Counted a, Counted b) { return ++done, a.value + b.value; }
  friend Counted operator-(Counted a, Counted b) { return ++done, a.value - b.value; }
  friend Counted operator*(Counted a, Counted b) { return ++done, a.value * b.value; }
  friend Counted operator/(Counted a, Counted b) { return ++done, a.value / b.value; }
  friend Counted operator-(Counted a) { return -a.value; }
  friend bool operator>(Counted a, Counted b) { return ++done, a.value > b.value; }
  friend Counted sqrt(Counted a) { return ++done, std::sqrt(a.value); }
  friend Counted max(Counted a, Counted b) { return ++done, a.value > b.value ? a : b; }
  friend Counted min(Counted a, Counted b) { return ++done, a.value < b.value ? a : b; }
  friend Counted select(bool which, Counted yes, Counted no) { return which ? yes : no; }
};

namespace {

/// Operations of one contact of equal spheres that sticks, with the sums into both particles.
int operations_of_a_contact(const ContactLaw& law) {
  const auto hertz = law.constants.as<Hertz>();
  Counted::done = 0;
  const Vector<Counted> apart{0.999, 0.01, 0.02}, velocity{1e-3, 2e-3, 0.0};
  const Counted distance = sqrt(dot(apart, apart));
  ContactGeometry<Counted> contact;
  contact.normal = (Counted(1.0) / distance) * apart;
  contact.overlap = max(Counted(1.0) - distance, Counted(0.0));
  contact.radius = Counted(0.25), contact.mass = Counted(1.0);
  contact.arm_i = contact.arm_j = Counted(0.5) - Counted(0.5) * contact.overlap;
  Springs<Counted> springs{};
  contact_loads<LudingTurning, ContactTerms{true, true, true}>(hertz, law.friction, contact, {velocity, {}, {}}, 1e-12,
                                                               springs);
  constexpr int differences = 6, sums = 12;
  return Counted::done + differences + sums;
}

/// Bytes of one contact: two indices, springs in and out, two particles' states in, loads in and out.
constexpr int bytes_of_a_contact = 2 * 4 + 2 * 7 * 8 + 2 * (96 + 2 * 64);

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

#if defined(__x86_64__)
/// Multiplications and additions in a second, in vectors of four.
__attribute__((target("avx2,fma"))) double peak() {
  typedef double Four __attribute__((vector_size(32)));
  Four sum[10];
  for (int k = 0; k < 10; ++k) sum[k] = Four{1.0, 1.1, 1.2, 1.3} * (k + 1.0);
  const Four factor{0.999, 0.998, 0.997, 0.996}, more{1e-3, 2e-3, 3e-3, 4e-3};
  constexpr int rounds = 50'000'000;
  const double begun = seconds();
  for (int n = 0; n < rounds; ++n)
#pragma GCC unroll 10
    for (Four& s : sum) s = s * factor + more;
  const double taken = seconds() - begun;
  double kept = 0;
  for (const Four& s : sum) kept += s[0] + s[1] + s[2] + s[3];
  return kept == 0 ? 0 : 2.0 * 4 * 10 * rounds / taken;
}
#endif

}  // namespace
}  // namespace clogflow::test

int main() {
#if defined(__x86_64__)
  using namespace clogflow;
  using namespace clogflow::test;
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    fmt::print("skipped: the peak is measured with AVX2\n");
    return 0;
  }
  const ScratchFile file(as_csv(tiled_particles(1, 1)));
  Simulation simulation(tiled_box(1, 1, file.name()), nullptr, 1);
  for (int k = 0; k < 200; ++k) simulation.compute_forces(), simulation.advance();
  Particles particles = simulation.particles();
  Neighbours lists;
  lists.rebuild(particles, {}, {0.1 * crowd_diameter, 0});
  Team alone;
  lists.sort(particles, 1e-3 * crowd_diameter, {}, alone);
  const Kernels& kernels = select_kernels();
  double contacts = 0;
  const double begun = seconds();
  while (seconds() < begun + 2)
    for (int k = 0; k < 100; ++k) {
      particles.clear_loads();
      contacts += static_cast<double>(kernels
                                          .collide_pairs({pointers(particles),
                                                          lists.groups.front().contacts.pointers(),
                                                          simulation.model().laws.pair,
                                                          {},
                                                          0,
                                                          lists.equal_radius,
                                                          lists.equal_mass},
                                                         {true, true, true})
                                          .contacts);
    }
  const double rate = contacts / (seconds() - begun);
  const int operations = operations_of_a_contact(simulation.model().laws.pair);
  const double most = peak();
  fmt::print(
      "One contact with sliding, rolling and torsion: {} operations, {} bytes to and from the caches, {:.2f} "
      "operations a byte.\n",
      operations, bytes_of_a_contact, operations / static_cast<double>(bytes_of_a_contact));
  fmt::print(
      "{:.3g} contacts/s (1000 spheres, {}) are {:.1f} Gflop/s, {:.0f} % of the {:.1f} Gflop/s that multiply-adds in "
      "vectors of four reach on this core, and {:.0f} GB/s.\n",
      rate, kernels.name, 1e-9 * rate * operations, 100 * rate * operations / most, 1e-9 * most,
      1e-9 * rate * bytes_of_a_contact);
#endif
}
