#include "trade/step_trials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/base/require.hpp"
#include "trade/spread.hpp"

namespace clogflow {

namespace {

constexpr double first_trial = 0.5, largest_trial = 8, growth = 1.2;  ///< times the prediction
constexpr int bisections = 4;
constexpr double reference_share = 0.2;           ///< of the limit, the step taken as exact
constexpr int reference_steps = 5 * trial_steps;  ///< as long as a trial at the limit

/// Kinetic energy over the scale, which is the elastic energy, of a push, of rest, and of shaking.
constexpr double push = 1e-9, rest = 1e-12, shaking = 10 * push;
/// The same of a column that shaking has thrown apart, so that it may be at rest again at the end.
constexpr double thrown = 1000 * push;
constexpr int settling_blocks = 40, block_steps = 2000;

constexpr double shaken = 10;         ///< kinetic energy over the reference's that counts as unstable
constexpr double floor_share = 1e-6;  ///< of the elastic energy: motion that does not matter
constexpr double accurate_energy = 0.05, accurate_shift = 0.01;

void halt(Particles& p) {
  for (ParticleState& s : p.states) s.vx = s.vy = s.vz = s.wx = s.wy = s.wz = 0;
}

/// Steps on. \return the largest kinetic energy met over the column's scale; NaN counts as infinite
double walk(const Column& column, Simulation& simulation, int steps, bool relax) {
  constexpr int look = 4;
  double largest = 0, before = 0;
  for (int k = 0; k < steps; ++k) {
    simulation.compute_forces();
    if (k % look == 0) {
      const double kinetic = half_step_energy(simulation.particles()), share = kinetic / column.scale(simulation);
      largest = share <= largest ? largest : std::isfinite(share) ? share : std::numeric_limits<double>::infinity();
      if (relax && kinetic < before) halt(simulation.particles());
      before = kinetic < before ? 0 : kinetic;
    }
    simulation.advance();
  }
  return largest;
}

/// Of the present contacts; after compute_forces().
double limit_now(const Simulation& simulation, double least = std::numeric_limits<double>::infinity()) {
  const NetworkLimit network = simulation.network();
  const NetworkLimit::Bound bound = network.bound();
  return bound.step < least ? std::min(least, network.exact(bound)) : least;
}

/// Brings a column to rest by halting all whenever the kinetic energy has passed a peak.
/// \return whether it then stays at rest
/// \source Cundall's dynamic relaxation with kinetic damping
bool settle(const Column& column, Simulation& simulation) {
  for (int k = 0; k < settling_blocks; ++k) {
    walk(column, simulation, block_steps, true);
    if (walk(column, simulation, block_steps / 10, false) < rest) return true;
    simulation.compute_forces();
    if (const double limit = limit_now(simulation); std::isfinite(limit))
      simulation.change_step(std::min(reference_share * limit, column.longest_on_the_way()));
    simulation.advance();
  }
  return false;
}

/// A column at rest, to be pushed with one step after the other.
class Resting {
public:
  Resting(const Column& column, double step) : column_(column), step_(step) {
    column.load(0);
    {
      Simulation simulation = column.simulation(step);
      simulation.fill({});
      come_to_rest(simulation);
    }
    for (int k = 1; k < column.loads(); ++k) {
      column.load(k);
      Simulation simulation = column.simulation(step);
      simulation.resume(state_);
      come_to_rest(simulation);
    }
  }

  bool at_rest() const { return at_rest_; }
  double limit() const { return limit_; }

  /// Whether a small push leaves it shaking: after so many steps more energy moves than was given, or did so wildly
  /// before.
  bool shakes(double step, int steps = trial_steps) const {
    try {
      Simulation simulation = column_.simulation(step_);
      simulation.resume(state_);
      simulation.change_step(step);
      simulation.compute_forces();
      give_push(simulation.particles(), push * column_.scale(simulation));
      simulation.advance();
      if (!(walk(column_, simulation, steps - steps / 10, false) < thrown)) return true;
      return !(walk(column_, simulation, steps / 10, false) < shaking);
    } catch (const Error&) {
      return true;
    }
  }

private:
  void come_to_rest(Simulation& simulation) {
    at_rest_ = settle(column_, simulation);
    simulation.compute_forces();
    limit_ = limit_now(simulation);
    simulation.change_step(step_);
    simulation.record();
    state_ = simulation.save();
  }

  /// To all in different ways: a film between two that go the same way would never show that it is unstable.
  static void give_push(Particles& p, double energy) {
    const double each = energy / (6.0 * static_cast<double>(p.size()));
    int number = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto kick = [&](double inertia) {
        return std::copysign(std::sqrt(2 * each / inertia), root_spread(++number, 2) - 0.5);
      };
      for (double* v : {&p[i].vx, &p[i].vy, &p[i].vz}) *v += kick(p[i].mass);
      for (double* w : {&p[i].wx, &p[i].wy, &p[i].wz}) *w += kick(p[i].inertia);
    }
  }

  const Column& column_;
  double step_;
  bool at_rest_ = false;
  double limit_ = 0;
  std::string state_;
};

/// The largest step from first_trial of the limit on, up to which no trial shakes.
void measure_limit(const Resting& resting, StepVerdict& result) {
  double low = 0, high = first_trial * result.predicted;
  while (!resting.shakes(high)) {
    low = high;
    high *= growth;
    if (low >= largest_trial * result.predicted) result.capped = true;
    if (result.capped) break;
  }
  for (int k = 0; k < bisections && low > 0 && !result.capped; ++k) {
    const double middle = std::sqrt(low * high);
    (resting.shakes(middle) ? high : low) = middle;
  }
  result.measured = low;
}

struct Trial {
  bool broke = false;
  double kinetic = 0;                                      ///< mean over the second half of the time [J]
  double elastic = 0;                                      ///< at the end [J]
  double scale = 0;                                        ///< of energies, at the end [J]
  double height = 0;                                       ///< mean, at the end [m]
  double limit = std::numeric_limits<double>::infinity();  ///< least of its contacts [s]
};

Trial run_trial(const Column& column, double step, double duration) {
  Trial trial;
  try {
    Simulation simulation = column.loose(step);
    const int steps = static_cast<int>(std::llround(duration / step));
    int counted = 0;
    for (int k = 0; k < steps; ++k) {
      simulation.compute_forces();
      if (k % 20 == 0) trial.limit = limit_now(simulation, trial.limit);
      if (2 * k >= steps && k % 10 == 0) trial.kinetic += half_step_energy(simulation.particles()), ++counted;
      simulation.advance();
    }
    simulation.compute_forces();
    trial.kinetic /= std::max(counted, 1);
    trial.elastic = simulation.elastic_energy();
    trial.scale = column.scale(simulation);
    const Particles& p = simulation.particles();
    for (const ParticleState& s : p.states) trial.height += s.z / static_cast<double>(p.size());
    trial.broke = !std::isfinite(trial.kinetic + trial.elastic + trial.height);
  } catch (const Error&) {
    trial.broke = true;
  }
  return trial;
}

void judge(const Column& column, StepVerdict& result) {
  const double duration = trial_steps * result.step;
  const Trial reference = run_trial(column, std::min(result.step, result.predicted) * reference_share, duration);
  require(result.step <= reference.limit, "step above the limit that contacts have for a while");
  const Trial trial = run_trial(column, result.step, duration);
  const double energy = std::abs(trial.elastic - reference.elastic);
  const double shift = std::abs(trial.height - reference.height) / column.diameter();
  const bool unstable = trial.broke || trial.kinetic > shaken * reference.kinetic + floor_share * reference.scale;
  result.verdict = unstable ? Verdict::unstable
                   : energy <= accurate_energy * reference.scale + 1e-30 && shift <= accurate_shift
                       ? Verdict::accurate
                       : Verdict::inaccurate;
}

}  // namespace

std::string name(Verdict verdict) {
  constexpr const char* names[] = {"accurate", "inaccurate", "refused", "unstable"};
  return names[static_cast<int>(verdict)];
}

void try_steps(const Column& column, StepVerdict& result) {
  const double guess = std::isfinite(result.expected) ? result.expected : result.step;
  const Resting resting(column, reference_share * guess);
  result.predicted = resting.limit();
  // A pack that a small step shakes as well within the same time is unstable by itself, not by its step.
  result.at_rest = resting.at_rest() && std::isfinite(result.predicted) &&
                   !resting.shakes(reference_share * result.predicted, reference_steps);
  if (result.at_rest) measure_limit(resting, result);
  require(result.step <= result.predicted, "step above the limit");
  judge(column, result);
}

}  // namespace clogflow
