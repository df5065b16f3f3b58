#include "dem/contact_set.hpp"

namespace clog {

void ContactSet::reset(std::size_t candidates) {
  for (auto& values : spring_) values.assign(candidates + widest_vector, 0.0);
  for (auto* indices : {&first_, &second_, &candidate_, &film_first, &film_second})
    indices->assign(candidates + widest_vector, 0);
  position_.assign(candidates, -1);
  count_ = 0;
}

Springs<double> ContactSet::springs(std::size_t k) const {
  const auto& s = spring_;
  return {{s[0][k], s[1][k], s[2][k]}, {s[3][k], s[4][k], s[5][k]}, s[6][k]};
}

void ContactSet::add(int candidate, int first, int second, const Springs<double>& s) {
  first_[count_] = first;
  second_[count_] = second;
  const double values[7] = {s.sliding.x, s.sliding.y, s.sliding.z, s.rolling.x,
                            s.rolling.y, s.rolling.z, s.torsion};
  for (int c = 0; c < 7; ++c) spring_[c][count_] = values[c];
  candidate_[count_] = candidate;
  position_[candidate] = static_cast<int>(count_);
  ++count_;
}

ContactPointers ContactSet::pointers() {
  ContactPointers pointers{};
  for (int c = 0; c < 7; ++c) pointers.spring[c] = spring_[c].data();
  pointers.first = first_.data();
  pointers.second = second_.data();
  pointers.candidate = candidate_.data();
  pointers.position = position_.data();
  pointers.count = &count_;
  return pointers;
}

Springs<double> swapped(const Springs<double>& s) { return {-s.sliding, s.rolling, s.torsion}; }

}  // namespace clog
