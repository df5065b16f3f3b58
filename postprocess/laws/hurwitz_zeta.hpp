// The Hurwitz zeta function: the normalisation of power laws on whole numbers.
#pragma once

namespace clogflow::postprocess {

/// Z(s) = q^s zeta(s, q) = sum_{k>=0} (1 + k/q)^-s with its derivatives by s. The factor q^s keeps
/// it within the range of numbers for any s and q; relative error about 1e-14.
struct ScaledZeta {
  double value = 0;      ///< Z, >= 1
  double slope = 0;      ///< dZ/ds, < 0
  double curvature = 0;  ///< d2Z/ds2, > 0
};

/// Euler-Maclaurin summation: the first terms one by one, the rest as an integral with corrections.
/// \param s > 1 \param q > 0
/// \source NIST Digital Library of Mathematical Functions, 25.11.5 and 2.10.1
ScaledZeta scaled_zeta(double s, double q);

/// zeta(s, q) = sum_{k>=0} (q + k)^-s
double hurwitz_zeta(double s, double q);

}  // namespace clogflow::postprocess
