// What the fluid does to the particles: velocity and drag coefficient for each of them.
#pragma once

#include <vector>

#include "coupling/base/team.hpp"
#include "coupling/scene/scene.hpp"
#include "dem/fluid/flow_drive.hpp"
#include "dem/fluid/flow_field.hpp"
#include "dem/fluid/fluid_noise.hpp"
#include "dem/fluid/local_porosity.hpp"
#include "dem/fluid/porosity_strips.hpp"
#include "dem/kernels/kernels.hpp"
#include "dem/physics/drag_law.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// The drag law that a scene names.
const DragLaw& drag_law(const Scene& scene);

/// Drag in the flow corrected for porosity, paper Eq. (4):
///   F_i = c_i (u - v_i),  c_i = f 3 pi eta d_i,  u = V0(x_i) / eps,  f of the scene's drag law.
/// Three readings of V0, for as much as the neck passes liquid or mixture:
///   interstitial  the liquid keeps its rate, u = V0 / eps: the paper's
///   superficial   c eps in the place of c: only the share that the flow between the particles drags, without that
///                 of the mean pressure gradient (1 - eps of the force on a bed at rest)
///   mixture       liquid and particles together keep it, V0 = eps u + (1 - eps) v_i: F_i = (c_i / eps) (V0 - v_i);
///                 at rest the paper's force
/// Published as the total fluid force: no separate pressure gradient force.
/// eps is that of the particle's strip or, if there is a local porosity, that of its place; the strips are then
/// recorded only. Where sizes differ, f is that of the mixture's Sauter mean, times a factor of the sphere's own size
/// (UnequalSpheres); a law of lone spheres has none.
class Fluid {
public:
  Fluid(const Scene& scene, const FlowField& field, PorosityStrips strips, LocalPorosity local = {});

  /// Measures the porosity anew.
  void update_porosity(const Particles& particles) {
    if (!strips_.empty()) strips_.update(particles);
    if (!local_.empty()) local_.update(particles);
  }

  /// Takes the random factors on the flow to the time given; costs nothing without any.
  void fluctuate(const Particles& particles, std::uint64_t seed, double time) {
    if (noise_.on()) noise_.advance(particles, seed, time);
  }

  /// Fills velocity and drag of every particle. Does nothing when the scene has no drag.
  void evaluate(Particles& particles, Team& team);
  void evaluate(Particles& particles);

  /// Takes what evaluate() filled for q = 1 to the q that pressures balance at. \param step  what advance() is given
  void balance(const AdvanceTask& step, double dt);

  /// Points a task to what evaluate() filled.
  void attach(AdvanceTask& task) const;

  /// Drag force on particle i if it moves with the velocity given [N]; after evaluate().
  Vec3 drag_force(int i, const Vec3& velocity) const;

  /// The same in a step that takes drag implicitly: at the velocity that the step leads to.
  /// \param other  all other forces [N];  \param rate  dt / m [s/kg]
  Vec3 implicit_drag_force(int i, const Vec3& velocity, const Vec3& other, double rate) const;

  const FlowField& field() const { return field_; }
  const PorosityStrips& strips() const { return strips_; }
  const LocalPorosity& local() const { return local_; }
  const FluidNoise& noise() const { return noise_; }
  const FlowDrive& drive() const { return drive_; }
  FlowDrive& drive() { return drive_; }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(strips_, noise_);
    if (!local_.empty()) archive(local_);
    if (drive_.on()) archive(drive_);
  }

private:
  /// Factor on V0 [-]
  double pulse() const { return drive_.is_balancing() ? 1 : noise_.pulsation() * drive_.factor(); }

  /// Velocity and drag as they are in the particle's strip.
  void sample(Particles& particles, Team& team);

  /// Velocity and drag from those of a lone sphere to those of the particle's surroundings.
  void add_surroundings(const Particles& particles);

  /// Coefficients in a mixture of sizes.
  void add_unequal_sizes(const Particles& particles);

  void add_fluctuation(const Particles& particles);
  void add_vorticity(const Particles& particles);

  /// Coefficients anew, by each particle's slip.
  void add_slip(const Particles& particles);

  /// `speed` where nothing stands in the way, at a porosity.
  double speed_between(double porosity, double speed) const {
    return reading_ == DragVelocity::mixture ? speed : speed / porosity;
  }

  /// Factor on the drag coefficient at a porosity.
  double weight(double porosity) const;

  StripPlace strip_place() const { return local_.empty() ? strips_.place() : StripPlace{}; }
  double porosity_at(const ParticleState& particle) const;

  FlowField field_;
  PorosityStrips strips_;
  LocalPorosity local_;
  FluidNoise noise_;
  FlowDrive drive_;
  const DragLaw& law_;
  double viscosity_, density_;
  const Kernels& kernels_;
  DragVelocity reading_;
  double per_sauter_mean_;  // 1 / <d> where sizes differ and the drag law is that of a pack, else 0 [1/m]
  bool drag_, viscous_torque_;
  std::vector<double> ux_, uy_, uz_, coefficient_;
  std::vector<double> turn_, sx_, sy_, sz_;
};

}  // namespace clogflow
