#include "coupling/scene/grid_spacing.hpp"

#include <cmath>

namespace clogflow {
namespace {

struct Law {
  double factor, power;
};

Law law(Lookup lookup) { return lookup == Lookup::nearest ? Law{1.54, 1} : Law{2.4, 1.5}; }

}  // namespace

double neck_lookup_error(Lookup lookup, double spacing, double side) {
  const Law l = law(lookup);
  return l.factor * std::pow(spacing / side, l.power);
}

double spacing_for_error(Lookup lookup, double error, double side) {
  const Law l = law(lookup);
  return side * std::pow(error / l.factor, 1 / l.power);
}

}  // namespace clogflow
