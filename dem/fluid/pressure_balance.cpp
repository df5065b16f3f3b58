#include "dem/fluid/pressure_balance.hpp"

#include "dem/physics/drag.hpp"

namespace clogflow {

namespace {

/// One force or torque, of coefficient c, on what moves with v in a flow u.
void add(ParticleResistance& sum, double c, double rate, const Vec3& u, const Vec3& moved) {
  const double weight = c * implicit_drag_factor(rate * c);
  sum.resistance += weight * dot(u, u);
  sum.push += weight * dot(u, moved);
}

}  // namespace

ParticleResistance resistance_of(const AdvanceTask& step) {
  ParticleResistance sum;
  const ParticlePointers& p = step.particles;
  const Vec3 body{step.body_force[0], step.body_force[1], step.body_force[2]};
  const Vec3 weight{step.weight_per_mass[0], step.weight_per_mass[1], step.weight_per_mass[2]};
  const double kick = step.implicit_drag ? step.kick : 0;
  for (std::size_t i = 0; i < p.count; ++i) {
    const ParticleState& s = p.particle[i];
    const double rate = kick / s.mass;
    const Vec3 other = Vec3{s.fx, s.fy, s.fz} + body + s.mass * weight;
    add(sum, step.drag[i], rate, {step.ux[i], step.uy[i], step.uz[i]}, s.velocity() + rate * other);
    if (!step.turn) continue;
    const double turn_rate = kick / s.inertia;
    const Vec3 torque{s.tx, s.ty, s.tz};
    add(sum, step.turn[i], turn_rate, {step.sx[i], step.sy[i], step.sz[i]}, s.spin() + turn_rate * torque);
  }
  return sum;
}

}  // namespace clogflow
