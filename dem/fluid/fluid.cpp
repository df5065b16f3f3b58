#include "dem/fluid/fluid.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/scene/particle_sizes.hpp"
#include "dem/kernels/blocks.hpp"
#include "dem/kernels/stretch.hpp"
#include "dem/physics/dimensionless.hpp"

namespace clogflow {

const DragLaw& drag_law(const Scene& scene) { return find_drag_law(scene.drag.law); }

namespace {

bool unequal_in_pack(const Scene& scene) {
  return find_drag_law(scene.drag.law).of_packs && !ParticleSizes(scene.particles).equal();
}

}  // namespace

Fluid::Fluid(const Scene& scene, const FlowField& field, PorosityStrips strips, LocalPorosity local)
    : field_(field),
      strips_(std::move(strips)),
      local_(std::move(local)),
      noise_(scene),
      drive_(scene),
      law_(drag_law(scene)),
      viscosity_(scene.fluid.viscosity),
      density_(scene.fluid.density),
      kernels_(select_kernels()),
      reading_(scene.drag.velocity),
      per_sauter_mean_(unequal_in_pack(scene) ? 1 / ParticleSizes(scene.particles).sauter_mean() : 0),
      drag_(scene.drag.enabled),
      viscous_torque_(scene.drag.viscous_torque) {}

double Fluid::weight(double porosity) const {
  switch (reading_) {
    case DragVelocity::superficial:
      return porosity;
    case DragVelocity::mixture:
      return 1 / porosity;
    case DragVelocity::interstitial:
      break;
  }
  return 1;
}

double Fluid::porosity_at(const ParticleState& particle) const {
  if (!local_.empty()) return local_.at(particle.position());
  return strips_.empty() ? 1 : strips_.porosity()[strips_.strip_at(particle.x)];
}

void Fluid::evaluate(Particles& p) {
  Team alone;
  evaluate(p, alone);
}

void Fluid::evaluate(Particles& p, Team& team) {
  if (!drag_) return;
  for (auto* values : {&ux_, &uy_, &uz_, &coefficient_}) values->resize(p.size());
  sample(p, team);
  if (!local_.empty()) add_surroundings(p);
  if (law_.knows_slip) add_slip(p);
  if (per_sauter_mean_ > 0) add_unequal_sizes(p);
  if (noise_.fluctuates()) add_fluctuation(p);
  if (viscous_torque_) add_vorticity(p);
}

void Fluid::sample(Particles& p, Team& team) {
  const double pulse = this->pulse();
  // Per strip: the velocity over V0, pulsating, and the coefficient.
  const bool by_strip = local_.empty() && !strips_.empty();
  const std::size_t strips = by_strip ? strips_.porosity().size() : 1;
  std::vector<double> speed(strips, pulse), factor(strips, 1.0);
  for (std::size_t k = 0; by_strip && k < strips; ++k) {
    const double porosity = strips_.porosity()[k];
    speed[k] = speed_between(porosity, pulse);
    factor[k] = law_.slow_factor(porosity) * weight(porosity);
  }
  for (double& share : factor) share *= stokes_coefficient(viscosity_, 2);  // per radius
  const StripPlace strip = strip_place();
  FlowTask task{pointers(p),   nullptr,          {},         0,          {},
                strip.start,   strip.per_length, strip.last, strip.neck, speed.data(),
                factor.data(), ux_.data(),       uy_.data(), uz_.data(), coefficient_.data()};
  if (field_.set_nearest(task)) {
    const Blocks blocks(p.size());
    team.each(blocks.count(),
              [&](int k) { kernels_.sample_nearest(stretch_of(task, blocks.begin(k), blocks.end(k))); });
    return;
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    const int k = strip.strip_at(p[i].x);
    const auto u = field_.at(p[i].x, p[i].y, p[i].z);
    ux_[i] = speed[k] * u[0], uy_[i] = speed[k] * u[1], uz_[i] = speed[k] * u[2];
    coefficient_[i] = factor[k] * p[i].radius;
  }
}

void Fluid::add_surroundings(const Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double porosity = local_.at(p[i].position()), faster = speed_between(porosity, 1);
    ux_[i] *= faster, uy_[i] *= faster, uz_[i] *= faster;
    coefficient_[i] *= law_.slow_factor(porosity) * weight(porosity);
  }
}

void Fluid::add_vorticity(const Particles& p) {
  const double pulse = this->pulse();
  for (auto* values : {&turn_, &sx_, &sy_, &sz_}) values->resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto spin = field_.half_vorticity(p[i].x, p[i].y, p[i].z);
    sx_[i] = pulse * spin[0], sy_[i] = pulse * spin[1], sz_[i] = pulse * spin[2];
    turn_[i] = stokes_torque_coefficient(viscosity_, 2 * p[i].radius);
  }
}

void Fluid::add_slip(const Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double porosity = porosity_at(p[i]);
    const Vec3 slip = Vec3{ux_[i], uy_[i], uz_[i]} - p[i].velocity();
    // V0 - v is the superficial slip of a mixture already.
    const double share = reading_ == DragVelocity::mixture ? 1 : porosity;
    // A pack's law is taken at the mixture's mean size.
    const double size = per_sauter_mean_ > 0 ? 1 / per_sauter_mean_ : 2 * p[i].radius;
    const double reynolds = reynolds_number(density_, share * std::sqrt(dot(slip, slip)), size, viscosity_);
    coefficient_[i] *= law_.factor({porosity, reynolds}) / law_.slow_factor(porosity);
  }
}

void Fluid::add_unequal_sizes(const Particles& p) {
  const UnequalSpheres law{reading_ != DragVelocity::superficial};
  for (std::size_t i = 0; i < p.size(); ++i)
    coefficient_[i] *= law.factor(porosity_at(p[i]), 2 * p[i].radius * per_sauter_mean_);
}

void Fluid::add_fluctuation(const Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 u{ux_[i], uy_[i], uz_[i]};
    const Vec3 slip = u - p[i].velocity();
    const double scale = std::sqrt(std::min(dot(slip, slip), dot(u, u)));
    const auto factor = noise_.fluctuation(i);
    ux_[i] += scale * factor[0], uy_[i] += scale * factor[1], uz_[i] += scale * factor[2];
  }
}

void Fluid::balance(const AdvanceTask& step, double dt) {
  drive_.balance(resistance_of(step), noise_.pulsation(), dt);
  for (auto* values : {&ux_, &uy_, &uz_, &sx_, &sy_, &sz_})
    for (double& value : *values) value *= drive_.factor();
}

void Fluid::attach(AdvanceTask& task) const {
  if (!drag_) return;
  task.ux = ux_.data(), task.uy = uy_.data(), task.uz = uz_.data();
  task.drag = coefficient_.data();
  if (!viscous_torque_) return;
  task.turn = turn_.data();
  task.sx = sx_.data(), task.sy = sy_.data(), task.sz = sz_.data();
}

Vec3 Fluid::drag_force(int i, const Vec3& v) const {
  if (!drag_) return {0, 0, 0};
  return clogflow::drag_force(coefficient_[i], {ux_[i], uy_[i], uz_[i]}, v);
}

Vec3 Fluid::implicit_drag_force(int i, const Vec3& v, const Vec3& other, double rate) const {
  if (!drag_) return {0, 0, 0};
  const double share = implicit_drag_factor(rate * coefficient_[i]);
  return drag_force(i, v + (share * rate) * (other + drag_force(i, v)));
}

}  // namespace clogflow
