#include "trade/stability.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "dem/physics/dimensionless.hpp"
#include "dem/run/model.hpp"
#include "trade/spread.hpp"

namespace clogflow {

namespace {

/// A loose simple cubic column of 3 x 3, shifted sideways and spinning a little: a mode at exact rest would
/// never show that it is unstable.
std::string column_file(const ExtremePoint& point, double overlap) {
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

/// Particles of one point in a file of their own, gone with it.
class EqualColumn : public Column {
public:
  EqualColumn(const ExtremePoint& point, double overlap)
      : point_(point),
        file_(std::filesystem::temp_directory_path() /
              fmt::format("clogflow_extreme_{}_{}.csv", getpid(), point.number)) {
    // Never through a link that lies under this name.
    publish_file(column_file(point, overlap), file_);
  }
  ~EqualColumn() override {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  EqualColumn(const EqualColumn&) = delete;
  EqualColumn& operator=(const EqualColumn&) = delete;

  double diameter() const override { return point_.diameter; }

  Simulation simulation(double step) const override {
    Scene scene = extreme_scene(point_, step);
    scene.particles.initial = file_.string();
    return Simulation(scene, nullptr, 1);
  }

private:
  const ExtremePoint& point_;
  std::filesystem::path file_;
};

}  // namespace

std::string spheres_in_liquid(const ExtremePoint& p, double diameter) {
  return fmt::format(R"(
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
                     p.viscosity, diameter, p.youngs_modulus);
}

Scene extreme_scene(const ExtremePoint& p, double step) {
  Scene s = parse_scene(spheres_in_liquid(p, p.diameter), "extremes");
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

ExtremePoint extreme_point(int k) {
  const auto u = [&](int prime) { return root_spread(k, prime); };
  return {.number = k,
          .diameter = log_between(u(2), 1e-6, 1e-3),
          .viscosity = log_between(u(3), 1e-6, 10),
          .youngs_modulus = log_between(u(5), 1e5, 1e11),
          .velocity = log_between(u(7), 1e-6, 1),
          .porosity = 0.36 + 0.64 * u(11),
          .friction = k % 7 == 0 ? 0 : log_between(u(13), 0.01, 10),
          .restitution = log_between(u(17), 0.01, 1),
          .particles = 1 + static_cast<int>(27 * u(19)),
          .step_fraction = log_between(u(23), 1.0 / 200, 1.0 / 2),
          .films = k % 2 == 0,
          .integrator = static_cast<Integrator>(k % 3)};
}

StepVerdict measure(const ExtremePoint& point) {
  StepVerdict result;
  try {
    const Model model = make_model(extreme_scene(point, 0), nullptr, {});
    const StepLimits limits = expected_limits(model, {});
    result.step = model.contact_time * point.step_fraction;
    result.expected = limits.smallest();
    require(limits.expected_overlap <= deepest_overlap, "overlaps of {:.2g} diameters are to be expected",
            limits.expected_overlap);
    // Close to rest: the lowest layer's share of the load that the limit expects.
    const double layers = std::ceil(point.particles / 9.0);
    try_steps(EqualColumn(point, limits.expected_overlap * std::pow(layers / 20, 2.0 / 3)), result);
  } catch (const std::exception& error) {
    result.reason = error.what();
  }
  return result;
}

}  // namespace clogflow
