#include "tests/statistics/pushed_copies.hpp"

#include <algorithm>

namespace clogflow::test {

namespace {

/// Streams of the pushes, apart from those of seeds and resamplings.
constexpr std::uint64_t pushes = 0x70757368;

}  // namespace

void push(Particles& particles, double amount, RandomStream random) {
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (double* place : {&particles[i].x, &particles[i].y, &particles[i].z}) *place += random.uniform(-amount, amount);
}

bool step(Simulation& simulation) {
  const auto is_over = [&] {
    const RunState& state = simulation.state();
    return state.ended() || state.clock.step() >= simulation.model().steps;
  };
  if (is_over()) return true;
  simulation.compute_forces();
  simulation.record();
  if (is_over()) return true;
  simulation.advance();
  return false;
}

Future future_of(const Branching& branching, std::uint64_t copy, double amount) {
  Simulation run(branching.scene, branching.flow, branching.seed);
  run.resume(branching.state);
  if (copy > 0) push(run.particles(), amount, RandomStream(pushes, copy));
  const std::size_t clogs_before = clogs(run), passed_before = run.data().passages.id.size();
  Future future;
  const auto passed = [&] { return run.data().passages.id.size() - passed_before; };
  while (passed() < branching.within && clogs(run) == clogs_before)
    if (step(run)) break;
  future.clogged = clogs(run) > clogs_before;
  const auto first = run.data().passages.id.begin() + static_cast<std::ptrdiff_t>(passed_before);
  future.passed.assign(first, first + static_cast<std::ptrdiff_t>(std::min(passed(), branching.within)));
  return future;
}

std::size_t alike(const Future& a, const Future& b) {
  const auto differs = std::ranges::mismatch(a.passed, b.passed);
  return static_cast<std::size_t>(differs.in1 - a.passed.begin());
}

}  // namespace clogflow::test
