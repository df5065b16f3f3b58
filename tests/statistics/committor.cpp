// Is a clog foreseen in the state before it? Takes one state of each burst and follows copies of it, each centre pushed
// by at most a small share of a diameter: docs/reports/bridging.md. A line of CSV on standard output for each copy;
// number 0 is the run itself, not pushed.

#include <cstdio>
#include <cstdlib>
#include <exception>

#include <fmt/format.h>

#include "coupling/base/source_folder.hpp"
#include "coupling/files/flow_grid.hpp"
#include "tests/statistics/pushed_copies.hpp"

namespace clogflow::test {
namespace {

struct Plan {
  std::uint64_t seed;
  std::size_t age;     ///< passages of a burst before its state is taken
  std::size_t within;  ///< passages that a copy is followed for
  std::uint64_t copies;
  double push;  ///< over a diameter [-]
};

void follow(const Branching& branching, const Plan& plan, std::size_t burst) {
  const double amount = plan.push * branching.scene.particles.diameter;
  const Future own = future_of(branching, 0, 0);
  for (std::uint64_t copy = 0; copy < plan.copies; ++copy) {
    const Future future = copy == 0 ? own : future_of(branching, copy, amount);
    fmt::print("{:.4g},{},{},{},{},{:g},{},{},{},{}\n",
               branching.scene.geometry.neck_width / branching.scene.particles.diameter, plan.seed, burst, plan.age,
               copy, plan.push, plan.within, future.passed.size(), int{future.clogged}, alike(own, future));
  }
  std::fflush(stdout);
}

/// One state of each burst that lasts so long, until time.end.
void run(const Scene& scene, const FlowGrid& flow, const Plan& plan) {
  Simulation parent(scene, &flow, plan.seed);
  parent.fill({});
  for (std::size_t burst = 0, began = 0, taken = 0;;) {
    const auto passages = parent.data().passages.id.size();
    if (clogs(parent) > burst || parent.state().clog_watch.friction_off()) began = passages, burst = clogs(parent);
    if (!parent.state().clog_watch.friction_off() && taken <= burst && passages >= began + plan.age) {
      follow({scene, &flow, plan.seed, parent.save(), plan.within}, plan, burst);
      taken = burst + 1;
    }
    if (step(parent)) return;
  }
}

}  // namespace
}  // namespace clogflow::test

int main(int argc, char** argv) {
  using namespace clogflow;
  if (argc < 7) {
    fmt::print(stderr,
               "usage: committor FLOW SEED AGE WITHIN COPIES PUSH [KEY=VALUE ...]   (of scenes/campaign.toml)\n");
    return 2;
  }
  try {
    const Scene scene = read_scene(source_folder() / "scenes/campaign.toml", {argv + 7, argv + argc});
    const auto count = [&](int k) { return std::strtoull(argv[k], nullptr, 10); };
    test::run(scene, read_flow_grid(argv[1]), {count(2), count(3), count(4), count(5), std::atof(argv[6])});
  } catch (const std::exception& error) {
    fmt::print(stderr, "committor: {}\n", error.what());
    return 1;
  }
}
