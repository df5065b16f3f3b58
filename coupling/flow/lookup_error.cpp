#include "coupling/flow/lookup_error.hpp"

#include <array>
#include <cmath>

namespace clogflow {

LookupError lookup_error(const FlowGrid& grid, double speed) {
  const auto [nx, ny, nz] = grid.points;
  const std::span<const float> field = grid.field();
  double second = 0, slope = 0, count = 0;
  const std::array<std::size_t, 3> step{1, static_cast<std::size_t>(nx), static_cast<std::size_t>(nx) * ny};
  for (int k = 1; k + 1 < nz; ++k)
    for (int j = 1; j + 1 < ny; ++j)
      for (int i = 1; i + 1 < nx; ++i) {
        const std::size_t at = grid.index(i, j, k);
        bool fluid = !grid.solid[at];
        for (const std::size_t s : step) fluid = fluid && !grid.solid[at - s] && !grid.solid[at + s];
        if (!fluid) continue;
        ++count;
        for (std::size_t c = 0; c < 3; ++c) {
          double curvature = 0;
          for (const std::size_t s : step) {
            const double before = field[3 * (at - s) + c];
            const double here = field[3 * at + c];
            const double after = field[3 * (at + s) + c];
            curvature += before - 2 * here + after;
            slope += std::pow((after - before) / 2, 2);
          }
          second += curvature * curvature;
        }
      }
  if (count == 0) return {0, 0};
  return {.trilinear = std::sqrt(second / count) / 12 / speed, .nearest = std::sqrt(slope / count / 12) / speed};
}

}  // namespace clogflow
