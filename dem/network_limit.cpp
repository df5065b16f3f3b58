#include "dem/network_limit.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

namespace clog {

namespace {

/// The same of the exact step, which costs a factorisation each time.
constexpr double exact_resolution = 1e-2;

/// Implicit drag can hold a film at any step [s].
constexpr double never = 1e9;

Eigen::Vector3d eigen(const Vector<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

NetworkLimit::NetworkLimit(const Particles& particles)
    : particles_(particles),
      stiffness_(particles.size(), Matrix6::Zero()),
      damping_(particles.size(), Matrix6::Zero()),
      implicit_(particles.size(), Vector6::Zero()),
      explicit_(particles.size(), Vector6::Zero()) {}

NetworkLimit::Vector6 NetworkLimit::scaled(int i, const Vector<double>& shift, const Vector<double>& turn) const {
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
    add(j, scaled(j, -mode.shift, mode.turn_j), (1 + 1 / ratio) * mode.stiffness,
        (1 + 1 / ratio) * mode.dashpot);
  }
  links_.push_back({i, j, modes});
}

void NetworkLimit::add_film(int i, int j, const Vector<double>& normal, double coefficient) {
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

bool NetworkLimit::stable(double dt) const {
  using Triplet = Eigen::Triplet<double>;
  std::vector<Triplet> entries;
  const auto subtract = [&](int i, int j, const Matrix6& block) {
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b) entries.emplace_back(6 * i + a, 6 * j + b, -block(a, b));
  };
  for (int i = 0; i < static_cast<int>(implicit_.size()); ++i)
    for (int a = 0; a < 6; ++a)
      entries.emplace_back(6 * i + a, 6 * i + a, 4 + 2 * dt * (implicit_[i][a] - explicit_[i][a]));
  for (const auto& [i, j, modes] : links_) {
    Matrix6 own = Matrix6::Zero(), other = own, between = own;
    for (int k = 0; k < modes.count; ++k) {
      const ContactMode& mode = modes.mode[k];
      const double weight = dt * dt * mode.stiffness + 2 * dt * mode.dashpot;
      const Vector6 of_i = scaled(i, mode.shift, mode.turn_i);
      own += weight * of_i * of_i.transpose();
      if (j < 0) continue;
      const Vector6 of_j = scaled(j, -mode.shift, mode.turn_j);
      other += weight * of_j * of_j.transpose();
      between += weight * of_i * of_j.transpose();
    }
    subtract(i, i, own);
    if (j < 0) continue;
    subtract(j, j, other);
    // Only the lower triangle is read.
    if (i > j) subtract(i, j, between);
    else subtract(j, i, between.transpose());
  }
  const auto size = 6 * static_cast<Eigen::Index>(implicit_.size());
  Eigen::SparseMatrix<double> left(size, size);
  left.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>(left).info() == Eigen::Success;
}

double NetworkLimit::exact(const Bound& bound) const {
  if (bound.particle < 0 || !(bound.step > 0)) return bound.step;
  double low = bound.step, high = 2 * low;
  for (; high < never && stable(high); high *= 2) low = high;
  if (high >= never) return std::numeric_limits<double>::infinity();
  while (high > (1 + exact_resolution) * low) {
    const double middle = std::sqrt(low) * std::sqrt(high);
    (stable(middle) ? low : high) = middle;
  }
  return low;
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

}  // namespace clog
