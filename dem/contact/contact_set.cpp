#include "dem/contact/contact_set.hpp"

#include "coupling/base/expect.hpp"
#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

std::size_t blocks(std::size_t rows) { return (rows + widest_vector - 1) / widest_vector; }

}  // namespace

void ContactSet::Rows::append(int one, int other, int number) {
  if (first.size() <= count) pad(2 * count + 1);
  first[count] = one;
  second[count] = other;
  candidate[count] = number;
  ++count;
}

void ContactSet::Rows::pad(std::size_t rows) {
  for (auto* values : {&first, &second, &candidate})
    if (values->size() < rows + row_padding) values->resize(rows + row_padding, 0);
}

void ContactSet::reset() {
  for (Rows* rows : {&touching_, &watched_, &films_}) *rows = Rows();
  make_room();
}

void ContactSet::make_room() {
  const std::size_t rows = touching_.count + watched_.count, padded = rows + row_padding;
  touching_.pad(rows);
  watched_.pad(rows);
  films_.pad(films_.count);
  if (changed_.size() < padded) changed_.resize(padded);
  if (springs_.size() < blocks(rows)) springs_.resize(blocks(rows));
}

Springs<double> ContactSet::springs(std::size_t row) const {
  expect(row < touching_.count + watched_.count);
  const auto& part = springs_[row / widest_vector].part;
  const std::size_t k = row % widest_vector;
  return {{part[0][k], part[1][k], part[2][k]}, {part[3][k], part[4][k], part[5][k]}, part[6][k]};
}

void ContactSet::add(const Candidates& list, int candidate, const Springs<double>& s) {
  expect(candidate >= 0 && static_cast<std::size_t>(candidate) < list.count);
  const double values[7] = {s.sliding.x, s.sliding.y, s.sliding.z, s.rolling.x, s.rolling.y, s.rolling.z, s.torsion};
  const std::size_t row = touching_.count;
  touching_.append(list.first[candidate], list.second[candidate], candidate);
  if (springs_.size() < blocks(row + 1)) springs_.resize(2 * blocks(row + 1));
  for (int part = 0; part < 7; ++part) spring_part(springs_.data(), part, row) = values[part];
}

ContactPointers ContactSet::pointers() {
  ContactPointers pointers{};
  pointers.touching = touching_.pointers();
  pointers.watched = watched_.pointers();
  pointers.springs = springs_.data();
  pointers.changed = changed_.data();
  pointers.film_first = films_.first.data();
  pointers.film_second = films_.second.data();
  pointers.film_count = films_.count;
  pointers.watched_lubricate = watched_lubricate_;
  return pointers;
}

bool ContactSet::valid(std::size_t candidates, std::size_t firsts, std::size_t seconds) const {
  const std::size_t moving = touching_.count + watched_.count;
  if (moving < touching_.count || moving > candidates || films_.count > candidates) return false;
  if (moving + films_.count == 0) return true;
  const auto has_room = [](const auto& values, std::size_t rows) { return values.size() >= rows + row_padding; };
  const auto fit = [&](const Rows& rows, std::size_t room) {
    return has_room(rows.first, room) && has_room(rows.second, room) && has_room(rows.candidate, room) &&
           point_below(rows.first, firsts) && point_below(rows.second, seconds) &&
           point_below(rows.candidate, candidates);
  };
  return fit(touching_, moving) && fit(watched_, moving) && fit(films_, films_.count) && has_room(changed_, moving) &&
         springs_.size() >= blocks(moving);
}

Springs<double> swapped(const Springs<double>& s) { return {-s.sliding, s.rolling, s.torsion}; }

}  // namespace clogflow
