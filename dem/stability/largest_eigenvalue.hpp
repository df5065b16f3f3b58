// The largest eigenvalue of a large matrix that is only known by what it does to a vector.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Eigenvalues>

#include "coupling/base/random_stream.hpp"

namespace clogflow {

/// How good an answer of Lanczos' method from a random start is.
struct LanczosQuality {
  double width;  ///< relative: the answer is at most this much too large
  double doubt;  ///< probability that it is too small
};

/// Steps after which the probability of xi < (1 - e) lambda is no more than the doubt, whatever the matrix:
///   1.648 sqrt(n) exp(-sqrt(e) (2 k - 1)) <= doubt
/// \source Kuczynski & Wozniakowski, SIAM J. Matrix Anal. Appl. 13 (1992) 1094, Theorem 4.2
inline int lanczos_steps(Eigen::Index size, const LanczosQuality& q) {
  const double most = 1.648 * std::sqrt(static_cast<double>(size)) / q.doubt;
  return static_cast<int>(std::ceil((1 + std::log(most) / std::sqrt(q.width)) / 2));
}

/// \param apply  (x, y): y = A x for a symmetric A without negative eigenvalues
/// \return the largest eigenvalue of A or more, see `quality`; infinite if A is not finite. The same for the same A.
template <class Apply>
double largest_eigenvalue(Eigen::Index size, const LanczosQuality& quality, Apply&& apply) {
  // Below this share of the matrix's size a rest is rounding: the start's components are all found.
  constexpr double nothing = 1e-12;
  RandomStream random(1);
  Eigen::VectorXd now(size), before = Eigen::VectorXd::Zero(size), next(size);
  // Normal in each component, by Box and Muller, so that no direction is preferred.
  for (Eigen::Index k = 0; k < size; ++k)
    now[k] = std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * M_PI * random.uniform());
  now.normalize();
  std::vector<double> diagonal, beside;
  bool all_found = false;
  double largest = 0, rest = 0;
  for (int k = lanczos_steps(size, quality); k > 0 && !all_found; --k) {
    if (!diagonal.empty()) beside.push_back(rest);
    apply(now, next);
    next -= rest * before;
    diagonal.push_back(now.dot(next));
    next -= diagonal.back() * now;
    rest = next.norm();
    if (!std::isfinite(diagonal.back()) || !std::isfinite(rest)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, diagonal.back());
    all_found = !(rest > nothing * largest);
    before.swap(now);
    now = next / rest;
  }
  using Map = Eigen::Map<const Eigen::VectorXd>;
  const auto count = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Map(diagonal.data(), count), Map(beside.data(), count - 1), Eigen::EigenvaluesOnly);
  const double found = solver.eigenvalues().maxCoeff();
  return all_found ? found : found / (1 - quality.width);
}

}  // namespace clogflow
