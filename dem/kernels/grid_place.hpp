// Where a place falls on a regular grid or among equal strips.
#pragma once

#include "dem/physics/number.hpp"

namespace clogflow {

/// A place counted in cells from the first edge, kept inside; 0 for NaN. Truncated, it is the number
/// of the cell.
/// \param place  (x - start) / length [-]
/// \param last   number of the last cell [-]
template <class Real>
[[gnu::always_inline]] inline Real place_within(Real place, double last) {
  return max(Real(0.0), min(place, Real(last)));
}

/// The same for the grid point that is nearest: the place rounded, the grid's faces outside of it.
/// \param place  (x - origin) / spacing [-]
/// \param last   number of the last point [-]
template <class Real>
[[gnu::always_inline]] inline Real nearest_point(Real place, double last) {
  return place_within(place + Real(0.5), last);
}

/// Number of the strip that x is in: of strips of equal length the one of `place`, and one more from `neck` on.
/// \param place  as above, of x [-];  \param last  number of the last strip of equal length [-]
/// \param neck   infinite where there is no such strip [m]
template <class Real>
[[gnu::always_inline]] inline Real strip_number(Real place, double last, Real x, double neck) {
  return place_within(place, last) + select(x >= Real(neck), Real(1.0), Real(0.0));
}

/// Number of the cell, of `count`, that a place is in. A conversion alone is undefined for what no int
/// can hold, and a particle in free flight may be anywhere.
inline int cell_number(double place, int count) { return static_cast<int>(place_within(place, count - 1.0)); }

}  // namespace clogflow
