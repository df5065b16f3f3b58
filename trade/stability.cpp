#include "trade/stability.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <fmt/format.h>
#include <unistd.h>

#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "dem/physics/dimensionless.hpp"
#include "dem/run/simulation.hpp"
#include "dem/stability/step_limit.hpp"
#include "dem/state/initial_particles.hpp"

namespace clogflow {

namespace {

/// Steps of a trial: an unstable mode grows by a factor per step, so a few hundred would do.
constexpr int trial_steps = 2000;
constexpr double first_trial = 0.5, largest_trial = 8, growth = 1.2;  ///< times the prediction
constexpr int bisections = 4;
constexpr double reference_share = 0.2;           ///< of the limit, the step taken as exact
constexpr int reference_steps = 5 * trial_steps;  ///< as long as a trial at the limit

/// Kinetic over elastic energy of a push, of rest, and of shaking.
constexpr double push = 1e-9, rest = 1e-12, shaking = 10 * push;
constexpr int settling_blocks = 40, block_steps = 2000;

constexpr double shaken = 10;         ///< kinetic energy over the reference's that counts as unstable
constexpr double floor_share = 1e-6;  ///< of the elastic energy: motion that does not matter
constexpr double accurate_energy = 0.05, accurate_shift = 0.01;

double halton(int index, int base) {
  double value = 0, share = 1;
  for (; index > 0; index /= base) value += (share /= base) * (index % base);
  return value;
}

double log_between(double u, double low, double high) { return low * std::pow(high / low, u); }

/// A loose simple cubic column of 3 x 3, shifted sideways and spinning a little: a mode at exact rest would
/// never show that it is unstable.
std::string column(const ExtremePoint& point, double overlap) {
  std::string text = "x,y,z,wx,wy,wz\n";
  const double d = point.diameter, pitch = d * (1 - overlap);
  const double spin = 10 * overlap * std::sqrt(point.youngs_modulus / 1062) / d;
  for (int k = 0; k < point.particles; ++k) {
    const auto off = [&](int base) { return 0.02 * d * (halton(k + 1, base) - 0.5); };
    const int row = k / 3 % 3 - 1, layer = k / 9;
    text += fmt::format("{},{},{},{},{},{}\n", (k % 3 - 1) * d * 1.01 + off(2), row * d * 1.01 + off(3),
                        d / 2 + layer * pitch - overlap * d, spin * off(5) / d, spin * off(7) / d, spin * off(11) / d);
  }
  return text;
}

Scene scene_of(const ExtremePoint& p, double step) {
  Scene s = parse_scene(fmt::format(R"(
[fluid]
viscosity = "{} Pa s"
density = "1062 kg/m3"
[particles]
diameter = "{} m"
[contact]
youngs_modulus = "{} Pa"
poisson_ratio = 0.35
[time]
end = "1 s"
)",
                                    p.viscosity, p.diameter, p.youngs_modulus),
                        "extremes");
  const double d = p.diameter, half = 1.6 * d;
  s.box.present = true;
  s.box.min = {-half, -half, 0}, s.box.max = {half, half, 8 * d};
  s.flow.source = FlowSource::uniform;
  s.flow.velocity = {0, 0, -p.velocity * drag_law(s).slow_factor(p.porosity) / p.porosity};
  s.drag.enabled = true;
  s.contact.restitution = p.restitution;
  s.contact.friction = s.contact.wall_friction = {p.friction, p.friction, p.friction};
  s.lubrication.enabled = p.films;
  s.lubrication.cutoff = d / 2;
  s.time.step = step;
  s.time.step_fraction = p.step_fraction;
  s.time.integrator = p.integrator;
  s.time.end = step > 0 ? trial_steps * step : 1;
  return s;
}

/// Particles of one point in a file of their own, gone with it.
class Column {
public:
  Column(const ExtremePoint& point, double overlap)
      : point_(point),
        file_(std::filesystem::temp_directory_path() /
              fmt::format("clogflow_extreme_{}_{}.csv", getpid(), point.number)) {
    // Never through a link that lies under this name.
    publish_file(column(point, overlap), file_);
  }
  ~Column() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  Column(const Column&) = delete;
  Column& operator=(const Column&) = delete;

  Simulation simulation(double step) const {
    Scene scene = scene_of(point_, step);
    scene.particles.initial = file_.string();
    return Simulation(scene, nullptr, 1);
  }

private:
  const ExtremePoint& point_;
  std::filesystem::path file_;
};

void halt(Particles& p) {
  for (ParticleState& s : p.states) s.vx = s.vy = s.vz = s.wx = s.wy = s.wz = 0;
}

/// Steps on. \return the largest kinetic over elastic energy met; NaN counts as infinite
double walk(Simulation& simulation, int steps, bool relax) {
  constexpr int look = 4;
  double largest = 0, before = 0;
  for (int k = 0; k < steps; ++k) {
    simulation.compute_forces();
    if (k % look == 0) {
      const double kinetic = half_step_energy(simulation.particles()), share = kinetic / simulation.elastic_energy();
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
bool settle(Simulation& simulation) {
  for (int k = 0; k < settling_blocks; ++k) {
    walk(simulation, block_steps, true);
    if (walk(simulation, block_steps / 10, false) < rest) return true;
    simulation.compute_forces();
    if (const double limit = limit_now(simulation); std::isfinite(limit))
      simulation.change_step(reference_share * limit);
    simulation.advance();
  }
  return false;
}

/// A column at rest, to be pushed with one step after the other.
class Resting {
public:
  Resting(const Column& column, double step) : column_(column), step_(step), simulation_(column.simulation(step)) {
    simulation_.fill({});
    at_rest_ = settle(simulation_);
    simulation_.compute_forces();
    limit_ = limit_now(simulation_);
    simulation_.change_step(step);
    simulation_.record();
    state_ = simulation_.save();
  }

  bool at_rest() const { return at_rest_; }
  double limit() const { return limit_; }

  /// Whether a small push leaves it shaking: after so many steps more energy moves than was given.
  bool shakes(double step, int steps = trial_steps) const {
    try {
      Simulation simulation = column_.simulation(step_);
      simulation.resume(state_);
      simulation.change_step(step);
      simulation.compute_forces();
      give_push(simulation.particles(), push * simulation.elastic_energy());
      simulation.advance();
      walk(simulation, steps - steps / 10, false);
      return !(walk(simulation, steps / 10, false) < shaking);
    } catch (const Error&) {
      return true;
    }
  }

private:
  static void give_push(Particles& p, double energy) {
    const double each = energy / (6.0 * static_cast<double>(p.size()));
    int number = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto kick = [&](double inertia) {
        return std::copysign(std::sqrt(2 * each / inertia), halton(++number, 2) - 0.5);
      };
      for (double* v : {&p[i].vx, &p[i].vy, &p[i].vz}) *v += kick(p[i].mass);
      for (double* w : {&p[i].wx, &p[i].wy, &p[i].wz}) *w += kick(p[i].inertia);
    }
  }

  const Column& column_;
  double step_;
  Simulation simulation_;
  bool at_rest_;
  double limit_;
  std::string state_;
};

/// The largest step from first_trial of the limit on, up to which no trial shakes.
void measure_limit(const Resting& resting, StabilityResult& result) {
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
  double height = 0;                                       ///< mean, at the end [m]
  double limit = std::numeric_limits<double>::infinity();  ///< least of its contacts [s]
};

Trial run_trial(const Column& column, double step, double duration) {
  Trial trial;
  try {
    Simulation simulation = column.simulation(step);
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
    const Particles& p = simulation.particles();
    for (const ParticleState& s : p.states) trial.height += s.z / static_cast<double>(p.size());
    trial.broke = !std::isfinite(trial.kinetic + trial.elastic + trial.height);
  } catch (const Error&) {
    trial.broke = true;
  }
  return trial;
}

void judge(const Column& column, StabilityResult& result) {
  const double duration = trial_steps * result.step;
  const Trial reference = run_trial(column, std::min(result.step, result.predicted) * reference_share, duration);
  require(result.step <= reference.limit, "step above the limit that contacts have for a while");
  const Trial trial = run_trial(column, result.step, duration);
  const double energy = std::abs(trial.elastic - reference.elastic);
  const double shift = std::abs(trial.height - reference.height) / result.point.diameter;
  const bool unstable = trial.broke || trial.kinetic > shaken * reference.kinetic + floor_share * reference.elastic;
  result.verdict = unstable ? Verdict::unstable
                   : energy <= accurate_energy * reference.elastic + 1e-30 && shift <= accurate_shift
                       ? Verdict::accurate
                       : Verdict::inaccurate;
}

}  // namespace

std::string name(Verdict verdict) {
  constexpr const char* names[] = {"accurate", "inaccurate", "refused", "unstable"};
  return names[static_cast<int>(verdict)];
}

std::vector<ExtremePoint> extreme_points(int count) {
  std::vector<ExtremePoint> points;
  for (int k = 1; k <= count; ++k) {
    const auto u = [&](int prime) { return std::fmod(k * std::sqrt(prime), 1.0); };
    points.push_back({k, log_between(u(2), 1e-6, 1e-3), log_between(u(3), 1e-6, 10), log_between(u(5), 1e5, 1e11),
                      log_between(u(7), 1e-6, 1), 0.36 + 0.64 * u(11), k % 7 == 0 ? 0 : log_between(u(13), 0.01, 10),
                      log_between(u(17), 0.01, 1), 1 + static_cast<int>(27 * u(19)),
                      log_between(u(23), 1.0 / 200, 1.0 / 2), k % 2 == 0, static_cast<Integrator>(k % 3)});
  }
  return points;
}

StabilityResult measure(const ExtremePoint& point) {
  StabilityResult result{point, Verdict::refused, {}};
  try {
    const Scene scene = scene_of(point, 0);
    const Model model = make_model(scene, nullptr, {});
    const StepLimits limits = expected_limits(model, {});
    result.step = model.contact_time * point.step_fraction;
    result.expected = limits.smallest();
    require(limits.expected_overlap <= deepest_overlap, "overlaps of {:.2g} diameters are to be expected",
            limits.expected_overlap);
    // Close to rest: the lowest layer's share of the load that the limit expects.
    const double layers = std::ceil(point.particles / 9.0);
    const Column column(point, limits.expected_overlap * std::pow(layers / 20, 2.0 / 3));
    const double guess = std::isfinite(result.expected) ? result.expected : result.step;
    const Resting resting(column, reference_share * guess);
    result.predicted = resting.limit();
    // A pack that a small step shakes as well within the same time is unstable by itself, not by its step.
    result.at_rest = resting.at_rest() && std::isfinite(result.predicted) &&
                     !resting.shakes(reference_share * result.predicted, reference_steps);
    if (result.at_rest) measure_limit(resting, result);
    require(result.step <= result.predicted, "step above the limit");
    judge(column, result);
  } catch (const std::exception& error) {
    result.reason = error.what();
  }
  return result;
}

}  // namespace clogflow
