#include "dem/run/run_state.hpp"

#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

/// The end of a filling is a bound on the steps; without one it would never end.
constexpr std::int64_t most_filling_steps = std::int64_t{1} << 53;

}  // namespace

RunState::RunState(const Model& constant, Fluid surrounding, std::uint64_t seed_number,
                   const std::vector<Particle>& initial, int threads)
    : model(constant),
      seed(seed_number),
      team(threads),
      clock(model.dt),
      random(seed_number),
      inlet(model),
      filling(model.scene),
      clog_watch(model.scene),
      supply_watch(model.scene),
      lists(model),
      fluid(std::move(surrounding)) {
  std::int64_t id = 0;
  for (const Particle& given : initial) {
    Particle particle = given;
    const Particle at_rest = model.particle({2 * given.radius, given.species});
    particle.id = id++;
    particle.mass = at_rest.mass, particle.inertia = at_rest.inertia;
    particles.add(particle);
  }
  inlet.number_from(id);
}

void RunState::place_walls() {
  Walls walls = model.walls;
  if (filling.gate_is_closed()) walls.insert(walls.end(), model.gate.begin(), model.gate.end());
  lists.change_walls(walls, particles);
}

const char* RunState::damaged_part() const {
  const auto known = [&](std::uint8_t kind) { return kind < model.sizes.species(); };
  if (!particles.valid(model.largest_radius) || !std::ranges::all_of(particles.species, known)) return "particles";
  if (!lists.valid(count())) return "contacts";
  if (!fluid.strips().valid() || !fluid.local().valid()) return "porosity";
  if (!fluid.noise().valid()) return "random factors on the flow";
  if (!fluid.drive().valid()) return "flow";
  if (!column.valid()) return "kept column";
  if (!inlet.valid()) return "inlet";
  if (!finite_from_zero(next_insertion, next_porosity, particle_steps) || !energy.valid() || !computing_time.valid())
    return "clocks or energies";
  if (!filling.valid(time())) return "filling";
  const std::int64_t most = filling.is_done() ? model.steps : most_filling_steps - 1;
  return clock.step() >= 0 && clock.step() <= most ? nullptr : "step";
}

}  // namespace clogflow
