// The fluid films between spheres and with walls, and their forces when a step takes them
// implicitly.
#pragma once

#include <vector>

#include "dem/kernels/kernels.hpp"

namespace clogflow {

/// One film; its force on `first` is -c (n . (u_first - u_second)) n.
struct Film {
  int first, second;   ///< particles; second < 0: a wall
  Vec3 normal;         ///< n, towards `first` [-]
  double coefficient;  ///< c [N s/m]
};

/// Adds to fx ... fz the forces of the films at the velocities v' that the step leads to, together
/// with the implicit drag (backward Euler: stable at any step, first order):
///   (M + dt (C_films + C_drag)) v' = M v + dt (F + C_drag u)
/// Divided by the roots of D = M + dt C_drag this is (I + G^T G) y = b, y = D^(1/2) v', with a row
/// sqrt(dt c) n^T D^(-1/2) of G per film: the normal equations of a sparse least-squares problem,
/// for Eigen's conjugate gradients with Jacobi's preconditioner. Every force acts on both
/// particles, so momentum is kept exactly however well the system is solved; the kick that follows
/// finds v' again.
/// \param step  what advance() is given, with implicit drag; its forces still without the films
/// \throws Error if v' cannot be had to `film_accuracy`
void add_implicit_films(const AdvanceTask& step, const std::vector<Film>& films);

/// Error of v' that is accepted, root mean square over that of all velocities. [-]
inline constexpr double film_accuracy = 1e-8;

}  // namespace clogflow
