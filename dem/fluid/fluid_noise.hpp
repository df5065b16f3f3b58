// What an unresolved model leaves out of the flow, as random factors with a memory.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "coupling/scene/scene.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// Random factors on the flow, each an Ornstein-Uhlenbeck process xi of variance 1:
///   per particle and component,  u += strength min(|u - v|, |u|) xi,  which adds to the drag
///     F = strength c min(|v - u|, |V0/eps|) xi:  bounded, so that a free particle does not run away;
///   one for all, V0 (1 + strength xi): a pulsation of the whole flow.
/// A factor is constant for a hundredth of its correlation time (a step, if that is longer) and has the exact
/// variance and correlation where it changes. Off while the channel is filled. What it is depends on the seed, the
/// particle's id and the time alone. \source form: Lattanzi, Tavanashad, Subramaniam & Capecelatro, Phys. Rev. Fluids
/// 7:014301 (2022), who
///         derive strength and time; here both are scene values
class FluidNoise {
public:
  FluidNoise() = default;
  explicit FluidNoise(const Scene& scene);

  bool on() const { return fluctuation_.strength > 0 || pulsation_.strength > 0; }
  bool fluctuates() const { return fluctuation_.strength > 0 && started_; }

  /// Goes on to the time given, and learns which particles there are. \param time  >= 0, never falling [s]
  void advance(const Particles& particles, std::uint64_t seed, double time);

  /// Factor on V0 [-]
  double pulsation() const { return started_ ? 1 + pulsation_.strength * pulse_ : 1.0; }

  /// strength xi of particle i, as it stood at the last advance() [-]
  std::array<double, 3> fluctuation(std::size_t i) const;

  /// Whether noise read from a file is one that a run can have.
  bool valid() const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(started_, fluctuation_.draws, fluctuation_.next, pulsation_.draws, pulsation_.next, pulse_, ids_, xi_);
  }

private:
  struct Process {
    double strength = 0, time = 0;
    std::uint32_t draws = 0;  // done
    double next = 0;          // change [s]

    double interval() const { return time * interval_share; }

    /// Counts a draw and sets the clock beyond `now`. \return time that it spans over the correlation time
    double draw(double now);
  };
  static constexpr double interval_share = 0.01;

  void follow(const std::vector<std::int64_t>& ids, std::uint64_t seed);

  Process fluctuation_, pulsation_;
  bool started_ = false;
  double pulse_ = 0;
  std::vector<std::int64_t> ids_;  // of the particles, in their order
  std::vector<double> xi_;         // three a particle
};

}  // namespace clogflow
