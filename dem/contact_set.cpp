#include "dem/contact_set.hpp"

#include "dem/sound.hpp"

namespace clog {

void ContactSet::Rows::append(int one, int other, int number) {
  if (first.size() <= count) pad(2 * count + 1);
  first[count] = one;
  second[count] = other;
  candidate[count] = number;
  ++count;
}

void ContactSet::Rows::pad(std::size_t rows) {
  for (auto* values : {&first, &second, &candidate})
    if (values->size() < rows + widest_vector) values->resize(rows + widest_vector, 0);
}

void ContactSet::reset() {
  for (Rows* rows : {&touching_, &watched_, &films_}) *rows = Rows();
  make_room();
}

void ContactSet::make_room() {
  const std::size_t rows = touching_.count + watched_.count, padded = rows + widest_vector;
  touching_.pad(rows);
  watched_.pad(rows);
  films_.pad(films_.count);
  if (changed_.size() < padded) changed_.resize(padded);
  for (auto& values : spring_)
    if (values.size() < padded) values.resize(padded, 0.0);
}

Springs<double> ContactSet::springs(std::size_t k) const {
  const auto& s = spring_;
  return {{s[0][k], s[1][k], s[2][k]}, {s[3][k], s[4][k], s[5][k]}, s[6][k]};
}

void ContactSet::add(const Candidates& list, int candidate, const Springs<double>& s) {
  const double values[7] = {s.sliding.x, s.sliding.y, s.sliding.z, s.rolling.x,
                            s.rolling.y, s.rolling.z, s.torsion};
  const std::size_t row = touching_.count;
  touching_.append(list.first[candidate], list.second[candidate], candidate);
  for (int c = 0; c < 7; ++c) {
    if (spring_[c].size() <= row) spring_[c].resize(2 * row + widest_vector, 0.0);
    spring_[c][row] = values[c];
  }
}

ContactPointers ContactSet::pointers() {
  ContactPointers pointers{};
  pointers.touching = touching_.pointers();
  pointers.watched = watched_.pointers();
  for (int c = 0; c < 7; ++c) pointers.spring[c] = spring_[c].data();
  pointers.changed = changed_.data();
  pointers.film_first = films_.first.data();
  pointers.film_second = films_.second.data();
  pointers.film_count = films_.count;
  pointers.watched_lubricate = watched_lubricate_;
  return pointers;
}

bool ContactSet::sound(std::size_t candidates, std::size_t firsts, std::size_t seconds) const {
  const std::size_t moving = touching_.count + watched_.count;
  if (moving < touching_.count || moving > candidates || films_.count > candidates) return false;
  if (moving + films_.count == 0) return true;
  const auto has_room = [](const auto& values, std::size_t rows) { return values.size() >= rows + widest_vector; };
  const auto fit = [&](const Rows& rows, std::size_t room) {
    return has_room(rows.first, room) && has_room(rows.second, room) && has_room(rows.candidate, room) &&
           point_below(rows.first, firsts) && point_below(rows.second, seconds) &&
           point_below(rows.candidate, candidates);
  };
  return fit(touching_, moving) && fit(watched_, moving) && fit(films_, films_.count) && has_room(changed_, moving) &&
         std::all_of(spring_.begin(), spring_.end(), [&](const auto& values) { return has_room(values, moving); });
}

Springs<double> swapped(const Springs<double>& s) { return {-s.sliding, s.rolling, s.torsion}; }

}  // namespace clog
