// The root of vectors against long double.
#include "dem/physics/number.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace clogflow::test {
namespace {

/// Over all of single precision's range, between its powers of two too.
TEST(InverseRoot, IsWithinTwoRoundingsOfTheValue) {
  using Lanes = stdx::native_simd<double>;
  for (double x = 1.2e-38; x < 3.3e38; x *= 1.000917) {
    const double root = inverse_root(Lanes(x))[0];
    const long double right = 1 / std::sqrt(static_cast<long double>(x));
    ASSERT_LE(std::abs(static_cast<double>(root / right - 1)), 4.5e-16) << x;
  }
}

TEST(InverseRoot, OfTwoSpheresGivesTheirDistance) {
  using Lanes = stdx::native_simd<double>;
  const Lanes distance2(3e-6 * 3e-6 + 4e-6 * 4e-6);
  EXPECT_NEAR((distance2 * inverse_root(distance2))[0] / 5e-6, 1, 5e-16);
}

}  // namespace
}  // namespace clogflow::test
