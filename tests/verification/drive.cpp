// Flows that are not steady: a sphere in a pulsating flow, and the balance of pressures that drives a flow through
// particles.
#include <cmath>
#include <numbers>

#include "coupling/geometry/duct_flow.hpp"
#include "dem/fluid/fluid.hpp"
#include "dem/physics/drag.hpp"
#include "dem/physics/porosity.hpp"
#include "tests/dem/laboratory.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;
using test::laboratory_scene;

namespace {

constexpr double eta = 1.8e-3, rho = 1062, d = 33e-6;
constexpr double response = rho * d * d / (18 * eta);

Scene wet_scene(double step) {
  Scene s = laboratory_scene({3e6, 0.35, rho, d}, step);
  s.fluid.viscosity = eta, s.fluid.density = rho;
  s.drag.enabled = true;
  s.drag.velocity = DragVelocity::mixture;
  s.time.integrator = Integrator::implicit_drag;
  s.flow.source = FlowSource::uniform;
  s.flow.velocity = {5e-3, 0, 0};
  return s;
}

/// Amplitude and lag of a lone sphere in 1 + A sin(w t), by Fourier's sum over a period that comes late.
void add_pulsating(Group& group, double angle) {
  constexpr double amplitude = 0.5, v = 5e-3;
  constexpr int steps = 4000;  // a period
  const double period = 2 * std::numbers::pi * response / angle, dt = period / steps;
  Scene s = wet_scene(dt);
  s.flow.oscillation = {
      .amplitude = amplitude, .frequency = 1 / period, .phase = 0, .shape = OscillationShape::sine, .table = {}};
  Laboratory lab(s, {{.radius = d / 2}});
  const int before = steps * static_cast<int>(std::ceil(20 * response / period));
  for (int k = 0; k < before; ++k) lab.step();
  double sine = 0, cosine = 0, mean = 0;
  for (int k = 0; k < steps; ++k) {
    lab.step();
    // The velocity is half a step before the place.
    const double phase = 2 * std::numbers::pi * (k + 0.5) / steps, u = lab.velocity(0).x / v;
    sine += u * std::sin(phase), cosine += u * std::cos(phase), mean += u;
  }
  const double times = 2.0 / steps;
  const std::string name = fmt::format("w m/c = {}", angle);
  group.checks.push_back({name + ", mean velocity over the flow's", 1, mean / steps, 1e-6});
  group.checks.push_back({name + ", amplitude over the flow's", 1 / std::hypot(1, angle),
                          times * std::hypot(sine, cosine) / amplitude, 2e-3});
  group.checks.push_back({name + ", lag [rad]", std::atan(angle), std::atan2(-cosine, sine), 1e-3, false});
}

/// Spheres in a uniform V0 that a pressure drives, without contacts.
class Tube {
public:
  Tube(int count, double dt, const ChannelResistance& channel)
      : scene_(wet_scene(dt)),
        dt_(dt),
        fluid_(scene_, FlowField(scene_.flow.velocity), {}),
        kernels_(select_kernels()) {
    scene_.flow.drive = DrivenBy::pressure, scene_.flow.pressure_drop = 2 * channel.pressure_drop;
    fluid_.drive() = FlowDrive(scene_, channel);
    Particle sphere;
    sphere.radius = d / 2, sphere.mass = rho * sphere_volume(d / 2), sphere.inertia = 1;
    for (int k = 0; k < count; ++k) particles_.add(sphere);
  }

  void step() {
    fluid_.drive().prescribe(0, true);
    fluid_.evaluate(particles_);
    AdvanceTask task{};
    task.particles = pointers(particles_);
    fluid_.attach(task);
    task.kick = task.drift = dt_;
    task.implicit_drag = true;
    task.passage = 1e300, task.too_fast = 1e300;
    fluid_.balance(task, dt_);
    kernels_.advance(task);
    fluid_.drive().advance(dt_);
  }

  double velocity() const { return particles_[0].vx; }
  double factor() const { return fluid_.drive().factor(); }

private:
  Scene scene_;
  double dt_;
  Fluid fluid_;
  const Kernels& kernels_;
  Particles particles_;
};

/// v of spheres from rest, and the factor, when the pack's own response time has gone by.
void add_response(Group& group, double dt_share, double limit) {
  constexpr double v0 = 5e-3, resistance = 100;  // of the pack over the channel's
  constexpr int count = 50;
  const double c = stokes_coefficient(eta, d), flow_rate = 4e-8 * v0;
  const ChannelResistance channel{count * c * v0 * v0 / flow_rate / resistance, flow_rate};
  const double time = response * (1 + resistance);
  const int steps = static_cast<int>(std::lround(1 / dt_share));
  Tube tube(count, time * dt_share, channel);
  for (int k = 0; k < steps; ++k) tube.step();
  group.checks.push_back({fmt::format("pack of 100 channels' resistance from rest, in {} steps, v / V0", steps),
                          2 * (1 - std::exp(-1)), tube.velocity() / v0, limit});
}

/// Sum over spheres that stand at random in a duct, over that of as many in its mean flow.
double profile_share(double width, double height) {
  const DuctFlow duct(width, height);
  constexpr int across = 200;
  double sum = 0;
  for (int i = 0; i < across; ++i)
    for (int k = 0; k < across; ++k) {
      const double u = duct(((i + 0.5) / across - 0.5) * width, (k + 0.5) / across * height);
      sum += u * u;
    }
  return sum / (across * across);
}

/// Pressure gradient of spheres that stand in a uniform flow, as resistance_of sums it, over Carman and Kozeny's.
double over_carman_kozeny(double porosity) {
  constexpr double v0 = 5e-3, area = 4e-8, length = 1e-3;
  const double volume = sphere_volume(d / 2);
  const int count = static_cast<int>(std::lround((1 - porosity) * area * length / volume));
  Particles p;
  Particle sphere;
  sphere.radius = d / 2, sphere.mass = 1, sphere.inertia = 1;
  for (int k = 0; k < count; ++k) p.add(sphere);
  const std::vector<double> u(count, v0), none(count, 0.0),
      c(count, find_drag_law("hoef").slow_factor(porosity) * stokes_coefficient(eta, d) / porosity);
  AdvanceTask task{};
  task.particles = pointers(p);
  task.ux = u.data(), task.uy = task.uz = none.data(), task.drag = c.data();
  const double drop = PressureBalance({0, area * v0}, 0).drop(resistance_of(task), 1);
  const double solid = count * volume / (area * length), eps = 1 - solid;
  return drop / length / (180 * eta * solid * solid * v0 / (eps * eps * eps * d * d));
}

}  // namespace

Group pulsating_flow() {
  Group group{"A sphere in a pulsating flow",
              "flow.oscillation in a uniform flow V0 (1 + A sin(w t)): a lone sphere of response time m/c follows with "
              "the amplitude A / sqrt(1 + (w m/c)^2) and the lag atan(w m/c). Limits of 2e-3 on the amplitude and of "
              "1e-3 rad on the lag: a period has 4000 steps, and implicit drag is late by half of one, 7.9e-4 rad.",
              {}};
  for (const double angle : {0.1, 1.0, 3.0}) add_pulsating(group, angle);
  return group;
}

Group pressure_drive() {
  Group group{
      "Flow driven by a pressure",
      "The balance of pressures of flow.drive = \"pressure\" and flow.compliance. Without particles q = Delta p / "
      "Delta "
      "p0. A bed at rest in a uniform flow against Carman and Kozeny's 180 eta (1-eps)^2 V0 / (eps^3 d^2): the law of "
      "van der Hoef et al. lies 1.6 to 6.3 % above it at porosities of 0.45 to 0.6. In a duct the sum is larger by "
      "<V0^2>/<V0>^2, the momentum factor of Shah and London (1978): 1.378 for a square. Spheres that a pressure sets "
      "in motion respond in m/c times (1 + pack's over channel's resistance), whatever the step: of first order in it. "
      "A compliance C relaxes like exp(-t Q0 / (C Delta p0)), exactly at any step.",
      {}};
  const ChannelResistance channel{12, 2e-10};
  group.checks.push_back({"no particles, 30 Pa over 12 Pa", 2.5, PressureBalance(channel, 0).factor({}, 30), 1e-15});
  for (const double porosity : {0.45, 0.6})
    group.checks.push_back({fmt::format("bed of porosity {} over Carman and Kozeny", porosity), 1,
                            over_carman_kozeny(porosity), porosity < 0.5 ? 0.02 : 0.065});
  group.checks.push_back({"<V0^2>/<V0>^2, square duct", 1.378, profile_share(1, 1), 2e-3});
  group.checks.push_back({"the same, duct of 4 by 1", 1.29, profile_share(4, 1), 5e-3});
  // 1 - (1 + h)^(-1/h) is off by h / (2 (e - 1)) = 0.29 h.
  for (const double share : {1e-1, 1e-2, 1e-3}) add_response(group, share, 0.3 * share);
  const PressureBalance tube(channel, 1e-13);
  double drop = 60, carried = 0;
  const double time = 1e-13 * 12 / 2e-10;
  for (int k = 0; k < 8; ++k) carried += tube.relax({}, 1, time / 4, drop) * time / 4;
  group.checks.push_back({"compliance, after two relaxation times [Pa]", 12 + 48 * std::exp(-2.0), drop, 1e-12});
  group.checks.push_back(
      {"liquid that it gave, over that of the pump", 1 + 4 * (1 - std::exp(-2.0)) / 2, carried / (2 * time), 1e-12});
  return group;
}

}  // namespace clogflow::verification
