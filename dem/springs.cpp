#include "dem/springs.hpp"

namespace clog {

void SpringTable::reset(std::size_t count) {
  touching_.assign(count, 0);
  for (auto& values : component_) values.assign(count, 0.0);
}

Springs<double> SpringTable::get(std::size_t k) const {
  const auto& c = component_;
  return {{c[0][k], c[1][k], c[2][k]}, {c[3][k], c[4][k], c[5][k]}, c[6][k]};
}

void SpringTable::set(std::size_t k, const Springs<double>& s) {
  touching_[k] = 1;
  const double values[7] = {s.sliding.x, s.sliding.y, s.sliding.z, s.rolling.x,
                            s.rolling.y, s.rolling.z, s.torsion};
  for (int c = 0; c < 7; ++c) component_[c][k] = values[c];
}

SpringPointers SpringTable::pointers() {
  SpringPointers pointers{};
  for (int c = 0; c < 7; ++c) pointers.component[c] = component_[c].data();
  pointers.touching = touching_.data();
  return pointers;
}

Springs<double> swapped(const Springs<double>& s) { return {-s.sliding, -s.rolling, s.torsion}; }

}  // namespace clog
