// Spheres that stand where they were put, and whether one more finds room among them.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "coupling/base/vector.hpp"

namespace clogflow {

/// Spheres are sorted by size, each class into cells as wide as its largest: what a question costs does not depend on
/// how unequal they are.
class PlacedSpheres {
public:
  /// \param smallest  radius of any that will come [m];  \param largest the same
  PlacedSpheres(double smallest, double largest);

  /// Whether a sphere there would overlap none.
  bool has_room(const Vec3& place, double radius) const;

  void add(const Vec3& place, double radius);

private:
  struct Sphere {
    Vec3 place;
    double radius;
  };
  /// Spheres of up to `radius`.
  struct Level {
    double radius;
    std::unordered_map<std::int64_t, std::vector<Sphere>> cells;
  };

  std::vector<Level> levels_;
};

}  // namespace clogflow
