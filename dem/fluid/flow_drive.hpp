// How fast the flow goes: the factor on V0, what decides it, and what of the flow has gone by.
#pragma once

#include <cmath>
#include <limits>

#include "coupling/scene/scene.hpp"
#include "dem/fluid/oscillation.hpp"
#include "dem/fluid/pressure_balance.hpp"
#include "dem/state/valid.hpp"

namespace clogflow {

/// The factor q on V0, and two clocks that follow it: waits and durations of starts, clogs and inlet are shares of the
/// time in which the flow carries a particle its diameter, so they count integral |q| dt; what comes in with the flow
/// counts integral q dt. While the channel is filled the flow is the mean one, q = 1. Then an oscillation k(t) is
///   of the rate      q = k
///   of the pressure  Delta p = k flow.pressure_drop, and q follows from the balance
///   of the pump      that fills a compliance; at time 0 its pressure is the one that keeps up k
class FlowDrive {
public:
  FlowDrive() = default;
  explicit FlowDrive(const Scene& scene) : oscillation_(scene) {}

  /// \param channel  used where the scene balances pressures
  FlowDrive(const Scene& scene, const ChannelResistance& channel)
      : oscillation_(scene),
        balance_(channel, scene.flow.compliance),
        balances_(scene.flow.balances()),
        given_drop_(scene.flow.pressure_drop) {}

  /// Whether q may be anything but 1; if not, no clock runs beside the run's own.
  bool on() const { return balances_ || oscillation_.on(); }

  /// Whether particles decide on q.
  bool balances() const { return balances_; }

  double factor() const { return factor_; }       ///< q [-]
  double pressure_drop() const { return drop_; }  ///< where pressures are balanced [Pa]

  /// q as prescribed. \param filled  false: the mean flow
  void prescribe(double time, bool filled) {
    is_filled_ = filled;
    prescribed_ = filled ? oscillation_.factor(time) : 1;
    factor_ = balances_ ? 1 : prescribed_;
  }

  /// q from the balance, where there is one and the channel is filled.
  /// \param particles  for q = 1;  \param pulse  random factor on what is given [-]
  void balance(const ParticleResistance& particles, double pulse, double dt);
  bool is_balancing() const { return balances_ && is_filled_; }

  /// The step that was done.
  void advance(double dt) {
    flow_time_ += std::abs(factor_) * dt, carried_ += factor_ * dt;
    drop_ = next_drop_;
  }

  /// The clocks count from 0 again.
  void restart() { flow_time_ = carried_ = 0; }

  /// Time in which the mean flow would have gone as far, there and back [s]. \param time  the run's
  double flow_time(double time) const { return on() ? flow_time_ : time; }

  /// Volume that has come in over the flow rate of V0 [s]. \param time  the run's
  double carried(double time) const { return on() ? carried_ : time; }

  /// A speed as it would be in the mean flow, if all were as much faster or slower [m/s]
  double in_mean_flow(double speed) const {
    if (!on()) return speed;
    return factor_ == 0 ? std::numeric_limits<double>::infinity() : speed / std::abs(factor_);
  }

  /// Whether nothing but the particles changes q.
  bool is_steady(double time) const { return oscillation_.is_steady(time) && !balance_.is_compliant() && factor_ != 0; }

  bool reverses() const { return oscillation_.on() && oscillation_.reverses(); }

  /// Whether clocks read from a file are ones that a run can have.
  bool valid() const { return all_finite({factor_, carried_, drop_, next_drop_}) && finite_from_zero(flow_time_); }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(factor_, flow_time_, carried_, drop_, next_drop_, has_drop_);
  }

private:
  Oscillation oscillation_;
  PressureBalance balance_;
  bool balances_ = false, is_filled_ = false, has_drop_ = false;
  double given_drop_ = 0;  // [Pa]
  double prescribed_ = 1, factor_ = 1;
  double flow_time_ = 0, carried_ = 0;  // [s]
  double drop_ = 0, next_drop_ = 0;     // now, and after the step [Pa]
};

}  // namespace clogflow
