// Cost of a whole step, and of its parts, in particle-steps per second. Timed, never judged:
//   build/release/bin/bench_step [--benchmark_filter=...]
#include <benchmark/benchmark.h>

#include <malloc.h>

#include <map>
#include <memory>

#include "dem/contact/neighbours.hpp"
#include "tests/benchmarks/scenes.hpp"

namespace clogflow::test {
namespace {

/// What is allocated now, in pages of its own or not; freed memory that is kept does not count [bytes].
double allocated() {
  const struct mallinfo2 now = mallinfo2();
  return static_cast<double>(now.uordblks + now.hblkhd);
}

struct Pack {
  std::unique_ptr<Simulation> simulation;
  double bytes = 0;  ///< that it holds
};

/// A settled pack of 1000 times `across` times `up` spheres, made once and kept for all benchmarks.
Pack& kept_pack(int across, int up, int threads) {
  static std::map<std::array<int, 3>, Pack> packs;
  Pack& found = packs[{across, up, threads}];
  if (!found.simulation) {
    const ScratchFile file(as_csv(tiled_particles(across, up)));
    const double before = allocated();
    found.simulation = std::make_unique<Simulation>(tiled_box(across, up, file.name()), nullptr, 1, threads);
    Simulation& made = *found.simulation;
    for (int k = 0; k < 200; ++k) made.compute_forces(), made.advance();
    made.compute_forces();
    found.bytes = allocated() - before;
  }
  return found;
}

Simulation& pack(int across, int up) { return *kept_pack(across, up, 1).simulation; }

void count(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

void whole_step(benchmark::State& state) {
  const Pack& pack =
      kept_pack(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), static_cast<int>(state.range(2)));
  Simulation& simulation = *pack.simulation;
  for (auto _ : state) {
    simulation.compute_forces();
    simulation.advance();
  }
  const std::size_t particles = simulation.particles().size();
  count(state, particles);
  state.counters["held_per_particle"] = pack.bytes / static_cast<double>(particles);
  state.counters["particles"] = static_cast<double>(particles);
  state.counters["bytes_per_particle"] = static_cast<double>(simulation.save().size()) / static_cast<double>(particles);
}
BENCHMARK(whole_step)
    ->ArgNames({"across", "up", "threads"})
    ->Args({1, 1, 1})
    ->Args({2, 5, 1})
    ->Args({10, 10, 1})
    ->Args({10, 100, 1})
    ->Args({1, 1, 2})
    ->Args({2, 5, 2})
    ->Args({10, 10, 2})
    ->Args({10, 100, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

/// Lists of a pack, ready for the hot loops.
struct Lists {
  Particles particles;
  Team alone;
  Neighbours neighbours;
  ContactLaw law;
  LubricationLaw film;
  const Kernels& kernels = select_kernels();

  explicit Lists(double lubrication) {
    const Simulation& simulation = pack(1, 1);
    particles = simulation.particles();
    law = simulation.model().laws.pair;
    if (lubrication > 0) film = {1.8e-3, 0.01 * crowd_diameter, lubrication, false};
    const double skin = 0.1 * crowd_diameter;
    neighbours.rebuild(particles, {}, {skin, lubrication});
    neighbours.sort(particles, 0.01 * skin, film, alone);
  }

  PairTask task() {
    return {
        pointers(particles),  neighbours.groups.front().contacts.pointers(), law, film, 7e-8, neighbours.equal_radius,
        neighbours.equal_mass};
  }
};

void contacts(benchmark::State& state) {
  Lists lists(0);
  ContactTally tally;
  for (auto _ : state) tally = lists.kernels.collide_pairs(lists.task(), {true, true, true});
  count(state, static_cast<std::size_t>(tally.contacts));
}
BENCHMARK(contacts)->Unit(benchmark::kMicrosecond);

/// Contacts and films; what the films cost is the difference to `contacts`.
void contacts_and_films(benchmark::State& state) {
  Lists lists(0.5 * crowd_diameter);
  for (auto _ : state) lists.kernels.collide_pairs(lists.task(), {true, true, true});
  count(state, lists.task().contacts.film_count);
}
BENCHMARK(contacts_and_films)->Unit(benchmark::kMicrosecond);

void neighbour_build(benchmark::State& state) {
  Lists lists(0);
  for (auto _ : state) lists.neighbours.rebuild(lists.particles, {}, {0.1 * crowd_diameter, 0});
  count(state, lists.particles.size());
}
BENCHMARK(neighbour_build)->Unit(benchmark::kMicrosecond);

void candidate_sorting(benchmark::State& state) {
  Lists lists(0);
  for (auto _ : state) lists.neighbours.sort(lists.particles, 0.001 * crowd_diameter, lists.film, lists.alone);
  count(state, lists.neighbours.groups.front().first.size());
}
BENCHMARK(candidate_sorting)->Unit(benchmark::kMicrosecond);

void wall_contacts(benchmark::State& state) {
  const Simulation& simulation = pack(1, 1);
  Particles particles = simulation.particles();
  const Reach reach{0.1 * crowd_diameter, 0};
  WallContacts walls(simulation.model().walls, crowd_diameter / 2, reach);
  std::vector<int> same(particles.size());
  for (std::size_t k = 0; k < same.size(); ++k) same[k] = static_cast<int>(k);
  walls.rebuild(particles, same, std::vector<double>(particles.size(), reach.skin / 2));
  WallLaws laws = simulation.model().laws.wall;
  laws.dt = 7e-8;
  walls.sort(particles, 0.01 * reach.skin, laws.lubrication);
  const Kernels& kernels = select_kernels();
  ContactTally tally;
  for (auto _ : state) tally = walls.collide_planes(particles, kernels, laws);
  count(state, static_cast<std::size_t>(tally.contacts));
}
BENCHMARK(wall_contacts)->Unit(benchmark::kMicrosecond);

/// Nearest point of a grid of the paper's size.
void drag_lookup(benchmark::State& state) {
  Particles particles = pack(1, 1).particles();
  const std::vector<float> velocity(3 * 640 * 160 * 40, 1e-3f);
  const double one = 1;
  std::vector<double> ux(particles.size()), uy(ux), uz(ux), drag(ux);
  FlowTask task{pointers(particles), velocity.data(), {0, 0, 0}, 1 / 2.5e-6, {640, 160, 40}, 0, 1, 0, 1e300, &one, &one,
                ux.data(),           uy.data(),       uz.data(), drag.data()};
  for (auto _ : state) select_kernels().sample_nearest(task);
  count(state, particles.size());
}
BENCHMARK(drag_lookup)->Unit(benchmark::kMicrosecond);

/// A round of two threads that have nothing to do.
void barrier(benchmark::State& state) {
  Team team(2);
  for (auto _ : state) team.each(2, [](int) {});
}
BENCHMARK(barrier)->UseRealTime()->Unit(benchmark::kMicrosecond);

/// A look at the limit of the contacts: the bound of every particle, and the whole network where the step is near it.
void limit_bound(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(pack(1, 1).network().bound().step);
}
BENCHMARK(limit_bound)->Unit(benchmark::kMicrosecond);

void limit_exact(benchmark::State& state) {
  const NetworkLimit network = pack(1, 1).network();
  const NetworkLimit::Bound bound = network.bound();
  for (auto _ : state) benchmark::DoNotOptimize(network.exact(bound));
  state.counters["exact_over_bound"] = network.exact(bound) / bound.step;
}
BENCHMARK(limit_exact)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace clogflow::test

BENCHMARK_MAIN();
