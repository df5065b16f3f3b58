// Sums of terms whose logarithms have simple derivatives by s.
#include "postprocess/laws/hurwitz_zeta.hpp"

#include <cmath>

namespace clogflow::postprocess {
namespace {

/// B_2j / (2j)!, j = 1, 2, ...
constexpr double corrections[] = {1.0 / 12,          -1.0 / 720,
                                  1.0 / 30240,       -1.0 / 1209600,
                                  1.0 / 47900160,    -691.0 / 1307674368000,
                                  1.0 / 74724249600, -3617.0 / 10670622842880000};

/// Where the corrections start: from there on those left out are below 1e-14 of the sum.
double far_enough(double s) { return 20.0 + s; }

constexpr double negligible = 1e-18;

/// Adds a term exp(g(s)), given g' and g''.
void add(ScaledZeta& sum, double term, double first, double second) {
  sum.value += term;
  sum.slope += term * first;
  sum.curvature += term * (first * first + second);
}

void add_corrections(ScaledZeta& sum, double term, double logarithm, double s, double x) {
  double product = term;  // times s (s + 1) ... (s + 2j - 2) / x^(2j - 1)
  double first = -logarithm, second = 0;
  double next = s;
  const auto multiply = [&] {
    product *= next / x;
    first += 1.0 / next;
    second -= 1.0 / (next * next);
    next += 1.0;
  };
  multiply();
  for (const double coefficient : corrections) {
    add(sum, coefficient * product, first, second);
    multiply();
    multiply();
  }
}

}  // namespace

ScaledZeta scaled_zeta(double s, double q) {
  ScaledZeta sum;
  double x = q, logarithm = 0, term = 1;
  for (double k = 1; x < far_enough(s); ++k) {
    add(sum, term, -logarithm, 0);
    x = q + k;
    logarithm = std::log1p(k / q);
    term = std::exp(-s * logarithm);
    // The whole rest is about the next term and the integral beyond it. Its share is largest in the
    // curvature.
    const double rest = term * (1.0 + x / (s - 1.0));
    if (sum.curvature > 0 && rest * logarithm * logarithm < negligible * sum.curvature) return sum;
  }
  add(sum, term * x / (s - 1.0), -logarithm - 1.0 / (s - 1.0), 1.0 / ((s - 1.0) * (s - 1.0)));
  add(sum, 0.5 * term, -logarithm, 0);
  add_corrections(sum, term, logarithm, s, x);
  return sum;
}

double hurwitz_zeta(double s, double q) { return scaled_zeta(s, q).value * std::pow(q, -s); }

}  // namespace clogflow::postprocess
