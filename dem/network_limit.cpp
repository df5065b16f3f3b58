#include "dem/network_limit.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace clog {

namespace {

/// Bisection of the step stops at this relative width: far finer than the bound itself.
constexpr double resolution = 1e-3;

/// Implicit drag can hold a film at any step [s].
constexpr double never = 1e9;

Eigen::Vector3d eigen(const Vector<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

NetworkLimit::NetworkLimit(const Particles& particles)
    : particles_(particles),
      stiffness_(particles.size(), Matrix6::Zero()),
      damping_(particles.size(), Matrix6::Zero()),
      implicit_(particles.size(), Vector6::Zero()) {}

void NetworkLimit::add(int i, const Vector6& direction, double stiffness, double dashpot) {
  // Velocities times sqrt(mass), spins times sqrt(inertia): the mass matrix becomes one.
  Vector6 scaled = direction;
  scaled.head<3>() /= std::sqrt(particles_.mass[i]);
  scaled.tail<3>() /= std::sqrt(particles_.inertia[i]);
  const Matrix6 square = scaled * scaled.transpose();
  stiffness_[i] += stiffness * square;
  damping_[i] += dashpot * square;
}

void NetworkLimit::add_contact(int i, int j, const ContactModes& modes) {
  const double ratio = j < 0 ? 0 : particles_.mass[i] / particles_.mass[j];
  for (int k = 0; k < modes.count; ++k) {
    const ContactMode& mode = modes.mode[k];
    Vector6 direction;
    direction << eigen(mode.shift), eigen(mode.turn_i);
    add(i, direction, (1 + ratio) * mode.stiffness, (1 + ratio) * mode.dashpot);
    if (j < 0) continue;
    direction << eigen(mode.shift), eigen(mode.turn_j);  // the sign does not matter
    direction.head<3>() *= -1;
    add(j, direction, (1 + 1 / ratio) * mode.stiffness, (1 + 1 / ratio) * mode.dashpot);
  }
}

void NetworkLimit::add_film(int i, int j, const Vector<double>& normal, double coefficient) {
  ContactModes film;
  film.mode[film.count++] = {0, coefficient, normal, {0, 0, 0}, {0, 0, 0}};
  add_contact(i, j, film);
}

void NetworkLimit::add_drag(int i, const Drag& drag) {
  Vector6 rates;
  rates.head<3>().setConstant(drag.translation / particles_.mass[i]);
  rates.tail<3>().setConstant(drag.rotation / particles_.inertia[i]);
  if (drag.implicit) {
    implicit_[i] += rates;
  } else {
    damping_[i].diagonal() += rates;
  }
}

bool NetworkLimit::stable(std::size_t i, double dt) const {
  Matrix6 left = -dt * dt * stiffness_[i] - 2 * dt * damping_[i];
  left.diagonal().array() += 4 + 2 * dt * implicit_[i].array();
  return left.llt().info() == Eigen::Success;
}

NetworkLimit::Bound NetworkLimit::bound() const {
  Bound least{std::numeric_limits<double>::infinity(), -1};
  for (std::size_t i = 0; i < stiffness_.size(); ++i) {
    const double k = stiffness_[i].trace(), c = damping_[i].trace();
    if (!(k > 0 || c > 0)) continue;
    if (least.particle >= 0 && stable(i, least.step)) continue;
    // The trace is no smaller than the largest eigenvalue, so this step is stable.
    double low = stable_step(k, c), high = 2 * low;
    for (; stable(i, high) && high < never; high *= 2) low = high;
    if (high >= never) continue;
    while (high > (1 + resolution) * low) {
      const double middle = std::sqrt(low * high);
      (stable(i, middle) ? low : high) = middle;
    }
    least = {low, static_cast<int>(i)};
  }
  return least;
}

}  // namespace clog
