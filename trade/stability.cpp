#include "trade/stability.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <unistd.h>

#include "coupling/require.hpp"
#include "dem/initial_particles.hpp"
#include "dem/physics/dimensionless.hpp"
#include "dem/simulation.hpp"
#include "dem/step_limit.hpp"

namespace clog {

namespace {

/// Steps of a trial: an unstable mode grows by a factor per step, so a few hundred would do.
constexpr int trial_steps = 2000;
constexpr int bisections = 7;
constexpr double largest_trial = 8;      ///< times the prediction
constexpr double reference_share = 0.2;  ///< of the prediction, the step taken as exact
constexpr double shaken = 10;            ///< kinetic energy over the reference's that counts as unstable
constexpr double floor_share = 1e-6;     ///< of the elastic energy: motion that does not matter
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
    text += fmt::format("{},{},{},{},{},{}\n", (k % 3 - 1) * d * 1.01 + off(2), (k / 3 % 3 - 1) * d * 1.01 + off(3),
                        d / 2 + (k / 9) * pitch - overlap * d, spin * off(5) / d, spin * off(7) / d,
                        spin * off(11) / d);
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
)", p.viscosity, p.diameter, p.youngs_modulus), "extremes");
  const double d = p.diameter, half = 1.6 * d;
  s.box.present = true;
  s.box.min = {-half, -half, 0}, s.box.max = {half, half, 8 * d};
  s.flow.source = FlowSource::uniform;
  s.flow.velocity = {0, 0, -p.velocity * voidage_function(p.porosity) / p.porosity};
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
    std::ofstream(file_) << column(point, overlap);
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

struct Trial {
  bool broke = false;
  double kinetic = 0;   ///< mean over the second half of the time [J]
  double elastic = 0;   ///< at the end [J]
  double height = 0;    ///< mean, at the end [m]
  double limit = std::numeric_limits<double>::infinity();  ///< least network limit [s]
};

Trial run_trial(const Column& column, double step, double duration, int look) {
  Trial trial;
  try {
    Simulation simulation = column.simulation(step);
    const int steps = static_cast<int>(std::llround(duration / step));
    int counted = 0;
    for (int k = 0; k < steps; ++k) {
      simulation.compute_forces();
      if (look > 0 && k % look == 0) trial.limit = std::min(trial.limit, simulation.network().bound().step);
      if (2 * k >= steps && k % 10 == 0) trial.kinetic += simulation.kinetic_energy(), ++counted;
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

bool unstable(const Trial& trial, const Trial& reference) {
  return trial.broke ||
         trial.kinetic > shaken * reference.kinetic + floor_share * reference.elastic;
}

/// The network is judged while the column moves as it does: once to find the limit roughly, then with the step
/// that belongs to it.
void find_limits(const Column& column, StabilityResult& result) {
  double guess = std::isfinite(result.expected) ? result.expected : result.step;
  for (int pass = 0; pass < 3; ++pass) {
    const Trial trial = run_trial(column, reference_share * guess, trial_steps * guess, 20);
    if (trial.broke || !std::isfinite(trial.limit)) return;
    result.predicted = trial.limit;
    if (trial.limit > 0.5 * guess && trial.limit < 2 * guess) return;
    guess = trial.limit;
  }
}

void bisect(const Column& column, StabilityResult& result) {
  const double predicted = result.predicted;
  const auto breaks = [&](double step) {
    const double duration = trial_steps * step;
    const Trial reference = run_trial(column, reference_share * predicted, duration, 0);
    return unstable(run_trial(column, step, duration, 0), reference);
  };
  double low = 0.25 * predicted, high = largest_trial * predicted;
  result.capped = !breaks(high);
  if (result.capped) low = high;
  for (int k = 0; k < bisections && !result.capped; ++k) {
    const double middle = std::sqrt(low * high);
    (breaks(middle) ? high : low) = middle;
  }
  result.measured = low;
}

void judge(const Column& column, StabilityResult& result) {
  const double duration = trial_steps * result.step;
  const Trial reference = run_trial(column, std::min(result.step, result.predicted) * reference_share,
                                    duration, 0);
  const Trial trial = run_trial(column, result.step, duration, 0);
  const double energy = std::abs(trial.elastic - reference.elastic);
  const double shift = std::abs(trial.height - reference.height) / result.point.diameter;
  result.verdict = unstable(trial, reference) ? Verdict::unstable
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
    points.push_back({k, log_between(u(2), 1e-6, 1e-3), log_between(u(3), 1e-6, 10),
                      log_between(u(5), 1e5, 1e11), log_between(u(7), 1e-6, 1), 0.36 + 0.64 * u(11),
                      k % 7 == 0 ? 0 : log_between(u(13), 0.01, 10), log_between(u(17), 0.01, 1),
                      1 + static_cast<int>(27 * u(19)), log_between(u(23), 1.0 / 200, 1.0 / 2), k % 2 == 0,
                      static_cast<Integrator>(k % 3)});
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
    find_limits(column, result);
    require(result.predicted > 0, "the reference run breaks");
    bisect(column, result);
    require(result.step <= result.predicted, "step above the limit");
    judge(column, result);
  } catch (const std::exception& error) {
    result.reason = error.what();
  }
  return result;
}

}  // namespace clog
