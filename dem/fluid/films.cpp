#include "dem/fluid/films.hpp"

#include <cmath>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "coupling/base/expect.hpp"
#include "coupling/base/require.hpp"

namespace clogflow {

namespace {

using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Residual at which the iteration stops: below film_accuracy, since its own estimate drifts with
/// rounding.
constexpr double stop_at = 0.01 * film_accuracy;

/// Usual are 5 to 50.
constexpr int most_iterations = 2000;

/// D^(-1/2), of each particle.
Eigen::VectorXd scales(const AdvanceTask& step) {
  Eigen::VectorXd scale(static_cast<Eigen::Index>(step.particles.count));
  for (Eigen::Index i = 0; i < scale.size(); ++i)
    scale[i] = 1 / std::sqrt(step.particles.particle[i].mass + (step.drag ? step.kick * step.drag[i] : 0));
  return scale;
}

/// G above a unit matrix.
Rows film_rows(const std::vector<Film>& films, double kick, const Eigen::VectorXd& scale) {
  const auto count = static_cast<Eigen::Index>(films.size()), unknowns = 3 * scale.size();
  Rows rows(count + unknowns, unknowns);
  rows.reserve(6 * count + unknowns);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Film& film = films[static_cast<std::size_t>(k)];
    expect(film.first < scale.size() && film.second < scale.size() && film.first != film.second);
    const double root = std::sqrt(kick * film.coefficient);
    const auto put = [&](int particle, double sign) {
      if (particle < 0) return;
      const double n[] = {film.normal.x, film.normal.y, film.normal.z};
      for (int a = 0; a < 3; ++a) rows.insertBack(k, 3 * particle + a) = sign * root * scale[particle] * n[a];
    };
    rows.startVec(k);
    const bool in_order = film.first < film.second;  // columns must rise
    put(in_order ? film.first : film.second, in_order ? 1 : -1);
    put(in_order ? film.second : film.first, in_order ? -1 : 1);
  }
  for (Eigen::Index k = 0; k < unknowns; ++k) {
    rows.startVec(count + k);
    rows.insertBack(count + k, k) = 1;
  }
  rows.finalize();
  return rows;
}

/// Zeros above b.
Eigen::VectorXd right_side(const AdvanceTask& step, Eigen::Index films, const Eigen::VectorXd& scale) {
  const ParticlePointers& p = step.particles;
  const double* u[] = {step.ux, step.uy, step.uz};
  Eigen::VectorXd right = Eigen::VectorXd::Zero(films + 3 * scale.size());
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    const ParticleState& s = p.particle[i];
    const double v[] = {s.vx, s.vy, s.vz}, f[] = {s.fx, s.fy, s.fz};
    for (int a = 0; a < 3; ++a) {
      const double drag = step.drag ? step.drag[i] * u[a][i] : 0;
      const double external =
          step.body_force[a] + s.mass * step.weight_per_mass[a] - s.radius * s.radius * s.radius * step.buoyancy[a];
      right[films + 3 * i + a] = scale[i] * (s.mass * v[a] + step.kick * (f[a] + external + drag));
    }
  }
  return right;
}

}  // namespace

void add_implicit_films(const AdvanceTask& step, const std::vector<Film>& films) {
  if (films.empty()) return;
  const ParticlePointers& p = step.particles;
  const Eigen::VectorXd scale = scales(step);
  const Rows rows = film_rows(films, step.kick, scale);
  const Eigen::VectorXd right = right_side(step, static_cast<Eigen::Index>(films.size()), scale);
  if (!right.allFinite()) return;  // the step that follows names the particle
  Eigen::VectorXd now(3 * scale.size());
  for (Eigen::Index i = 0; i < scale.size(); ++i)
    now.segment<3>(3 * i) = Eigen::Vector3d(p.particle[i].vx, p.particle[i].vy, p.particle[i].vz) / scale[i];

  Eigen::LeastSquaresConjugateGradient<Rows> solver;
  solver.setTolerance(stop_at);
  solver.setMaxIterations(most_iterations);
  solver.compute(rows);
  Eigen::VectorXd velocity = solver.solveWithGuess(right, now);
  const double error = (rows.transpose() * (right - rows * velocity)).norm(), size = right.norm();
  require(error <= film_accuracy * size,
          "the fluid films could not be solved for (error {:.2g} after {} iterations, {} is "
          "accepted): lower the time step or raise particles.roughness",
          error / size, solver.iterations(), film_accuracy);

  for (Eigen::Index i = 0; i < scale.size(); ++i) velocity.segment<3>(3 * i) *= scale[i];
  const auto velocity_of = [&](int i) { return Vec3(&velocity[3 * i]); };
  for (const Film& film : films) {
    Vec3 approach = velocity_of(film.first);
    if (film.second >= 0) approach -= velocity_of(film.second);
    const Vec3 force = (-film.coefficient * dot(film.normal, approach)) * film.normal;
    p.particle[film.first].fx += force.x, p.particle[film.first].fy += force.y, p.particle[film.first].fz += force.z;
    if (film.second < 0) continue;
    p.particle[film.second].fx -= force.x, p.particle[film.second].fy -= force.y, p.particle[film.second].fz -= force.z;
  }
}

}  // namespace clogflow
