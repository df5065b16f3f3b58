#include "dem/fluid/flow_drive.hpp"

namespace clogflow {

void FlowDrive::balance(const ParticleResistance& particles, double pulse, double dt) {
  const double given = prescribed_ * pulse;
  if (!balance_.is_compliant()) {
    drop_ = next_drop_ = given * given_drop_;
    factor_ = balance_.factor(particles, drop_);
    return;
  }
  if (!has_drop_) {
    drop_ = balance_.drop(particles, given);
    has_drop_ = true;
  }
  next_drop_ = drop_;
  factor_ = balance_.relax(particles, given, dt, next_drop_);
}

}  // namespace clogflow
