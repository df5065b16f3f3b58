#include "dem/contact_set.hpp"

#include "dem/sound.hpp"

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

bool ContactSet::sound(std::size_t candidates, std::size_t firsts, std::size_t seconds) const {
  if (position_.size() != candidates || count_ > candidates) return false;
  if (candidates == 0) return true;
  const std::size_t padded = candidates + widest_vector;
  const auto fits = [&](const auto& values) { return values.size() == padded; };
  if (!std::all_of(spring_.begin(), spring_.end(), fits)) return false;
  for (const auto* indices : {&first_, &second_, &candidate_, &film_first, &film_second})
    if (!fits(*indices)) return false;
  // Each contact knows its candidate and each candidate its contact.
  for (std::size_t k = 0; k < count_; ++k) {
    const int c = candidate_[k];
    if (c < 0 || static_cast<std::size_t>(c) >= candidates || position_[c] != static_cast<int>(k))
      return false;
  }
  const auto touching = std::count_if(position_.begin(), position_.end(), [](int at) { return at != -1; });
  return static_cast<std::size_t>(touching) == count_ && point_below(first_, firsts) &&
         point_below(film_first, firsts) && point_below(second_, seconds) &&
         point_below(film_second, seconds);
}

Springs<double> swapped(const Springs<double>& s) { return {-s.sliding, s.rolling, s.torsion}; }

}  // namespace clog
