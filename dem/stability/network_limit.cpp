#include "dem/stability/network_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "dem/stability/largest_eigenvalue.hpp"

namespace clogflow {

namespace {

/// The same of the exact step, and of the eigenvalue, which goes with the step's square.
constexpr double exact_resolution = 1e-2;
constexpr LanczosQuality quality{.width = 2e-2, .doubt = 1e-6};

/// Steps tried at most on the way to the exact one: with dashpots alone each halves the rest of the way.
constexpr int most_trials = 20;

/// Implicit drag can hold a film at any step [s].
constexpr double never = 1e9;

Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

NetworkLimit::NetworkLimit(const Particles& particles)
    : particles_(particles),
      stiffness_(particles.size(), Matrix6::Zero()),
      damping_(particles.size(), Matrix6::Zero()),
      implicit_(particles.size(), Vector6::Zero()),
      explicit_(particles.size(), Vector6::Zero()) {}

NetworkLimit::Vector6 NetworkLimit::scaled(int i, const Vec3& shift, const Vec3& turn) const {
  // Velocities times sqrt(mass), spins times sqrt(inertia): the mass matrix becomes one.
  Vector6 direction;
  direction << eigen(shift) / std::sqrt(particles_[i].mass), eigen(turn) / std::sqrt(particles_[i].inertia);
  return direction;
}

void NetworkLimit::add(int i, const Vector6& direction, double stiffness, double dashpot) {
  const Matrix6 square = direction * direction.transpose();
  stiffness_[i] += stiffness * square;
  damping_[i] += dashpot * square;
}

void NetworkLimit::add_contact(int i, int j, const ContactModes& modes) {
  const double ratio = j < 0 ? 0 : particles_[i].mass / particles_[j].mass;
  for (int k = 0; k < modes.count; ++k) {
    const ContactMode& mode = modes.mode[k];
    add(i, scaled(i, mode.shift, mode.turn_i), (1 + ratio) * mode.stiffness, (1 + ratio) * mode.dashpot);
    if (j < 0) continue;
    add(j, scaled(j, -mode.shift, mode.turn_j), (1 + 1 / ratio) * mode.stiffness, (1 + 1 / ratio) * mode.dashpot);
  }
  links_.push_back({i, j, modes});
}

void NetworkLimit::add_film(int i, int j, const Vec3& normal, double coefficient) {
  ContactModes film;
  film.mode[film.count++] = {0, coefficient, normal, {0, 0, 0}, {0, 0, 0}};
  add_contact(i, j, film);
}

void NetworkLimit::add_drag(int i, const Drag& drag) {
  Vector6 rates;
  rates.head<3>().setConstant(drag.translation / particles_[i].mass);
  rates.tail<3>().setConstant(drag.rotation / particles_[i].inertia);
  if (drag.implicit) {
    implicit_[i] += rates;
  } else {
    damping_[i].diagonal() += rates;
    explicit_[i] += rates;
  }
}

bool NetworkLimit::stable(std::size_t i, double dt) const {
  Matrix6 left = -dt * dt * stiffness_[i] - 2 * dt * damping_[i];
  left.diagonal().array() += 4 + 2 * dt * implicit_[i].array();
  return left.llt().info() == Eigen::Success;
}

double NetworkLimit::share(double dt) const {
  const auto particles = static_cast<Eigen::Index>(implicit_.size());
  // One block of the matrix per particle and one per pair.
  Aligned<Matrix6> own(implicit_.size());
  Eigen::VectorXd scale(6 * particles), scaled_x(6 * particles);
  for (std::size_t i = 0; i < own.size(); ++i) {
    own[i] = (2 * dt * explicit_[i]).asDiagonal();
    scale.segment<6>(6 * static_cast<Eigen::Index>(i)) = (4 + 2 * dt * implicit_[i].array()).rsqrt();
  }
  struct Between {
    int i, j;
    Matrix6 block;
  };
  Aligned<Between> pairs;
  for (const auto& [i, j, modes] : links_) {
    Matrix6 between = Matrix6::Zero();
    for (int k = 0; k < modes.count; ++k) {
      const ContactMode& mode = modes.mode[k];
      const double weight = dt * dt * mode.stiffness + 2 * dt * mode.dashpot;
      const Vector6 of_i = scaled(i, mode.shift, mode.turn_i), pull = weight * of_i;
      own[i] += pull * of_i.transpose();
      if (j < 0) continue;
      const Vector6 of_j = scaled(j, -mode.shift, mode.turn_j);
      own[j] += weight * of_j * of_j.transpose();
      between += pull * of_j.transpose();
    }
    if (j >= 0) pairs.push_back({i, j, between});
  }
  return largest_eigenvalue(6 * particles, quality, [&](const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    scaled_x = scale.cwiseProduct(x);
    for (Eigen::Index i = 0; i < particles; ++i)
      y.segment<6>(6 * i).noalias() = own[static_cast<std::size_t>(i)] * scaled_x.segment<6>(6 * i);
    for (const auto& [i, j, block] : pairs) {
      y.segment<6>(6 * i).noalias() += block * scaled_x.segment<6>(6 * j);
      y.segment<6>(6 * j).noalias() += block.transpose() * scaled_x.segment<6>(6 * i);
    }
    y = scale.cwiseProduct(y);
  });
}

double NetworkLimit::exact(const Bound& bound) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (bound.particle < 0 || !(bound.step > 0)) return bound.step;
  const bool may_be_held = std::ranges::any_of(implicit_, [](const Vector6& rates) { return rates.maxCoeff() > 0; });
  if (may_be_held && share(never) < 1) return infinite;
  double step = bound.step;
  for (int k = 0; k < most_trials; ++k) {
    const double growth = 1 / std::sqrt(share(step));
    if (!(growth > 1)) break;
    step *= growth;
    if (step > never) return infinite;
    if (growth < 1 + exact_resolution) break;
  }
  return step;
}

NetworkLimit::Bound NetworkLimit::bound() const {
  Bound least{std::numeric_limits<double>::infinity(), -1};
  for (std::size_t i = 0; i < stiffness_.size(); ++i) {
    const double k = stiffness_[i].trace(), c = damping_[i].trace();
    if (!(k > 0 || c > 0)) continue;
    if (least.particle >= 0 && stable(i, least.step)) continue;
    // The trace is no smaller than the largest eigenvalue, so this step is stable.
    double low = stable_step(k, c), high = 2 * low;
    // A stiffness beyond all numbers: no step is stable, and no search would end.
    if (!(low > 0)) return {0, static_cast<int>(i)};
    for (; stable(i, high) && high < never; high *= 2) low = high;
    if (high >= never) continue;
    while (high > (1 + resolution) * low) {
      const double middle = std::sqrt(low) * std::sqrt(high);
      (stable(i, middle) ? low : high) = middle;
    }
    least = {low, static_cast<int>(i)};
  }
  return least;
}

}  // namespace clogflow
