#include "coupling/geometry/corner_welding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

/// Cells of the grid in tolerances: in cells much wider than the tolerance most corners are far
/// from every border, and only one cell is looked into.
constexpr double cell_width = 8;

/// Corners in one cell; more are no seam, but a shape smaller than the tolerance.
constexpr int most_in_cell = 1000;

/// What one corner may be moved by, in tolerances.
constexpr double longest_chain = 3;

using Cell = std::array<std::int64_t, 3>;

std::uint64_t mixed(std::uint64_t h, std::uint64_t bits) {
  h = (h ^ bits) * 0x9e3779b97f4a7c15u;
  return h ^ (h >> 29);
}

std::uint64_t hash_of(const Vec3& place) {
  std::uint64_t h = 0;
  // The sum turns -0 into 0, which is the same place.
  for (const double x : place.array()) h = mixed(h, std::bit_cast<std::uint64_t>(x + 0.0));
  return h;
}

std::uint64_t hash_of(const Cell& cell) {
  std::uint64_t h = 0;
  for (const std::int64_t index : cell) h = mixed(h, static_cast<std::uint64_t>(index));
  return h;
}

/// An open hash table of numbers; what a number stands for is known to the caller. Twelve bytes a
/// corner matter where a file has millions.
class NumberTable {
public:
  /// The slot of the number for which `same` holds, or an empty one (-1) that is for it.
  template <class Same>
  int& slot(std::uint64_t hash, const Same& same) {
    std::size_t at = hash & (slots_.size() - 1);
    while (slots_[at] >= 0 && !same(slots_[at])) at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
  }

  template <class Hash>
  void make_room(std::size_t used, const Hash& hash_of_number) {
    if (2 * used < slots_.size()) return;
    std::vector<int> old(2 * slots_.size(), -1);
    old.swap(slots_);
    for (const int number : old)
      if (number >= 0) slot(hash_of_number(number), [](int) { return false; }) = number;
  }

private:
  std::vector<int> slots_ = std::vector<int>(1024, -1);
};

WeldedCorners join_equal(const Walls& walls) {
  WeldedCorners welded;
  welded.corner.resize(walls.size());
  NumberTable table;
  auto& place = welded.place;
  for (std::size_t t = 0; t < walls.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3& corner = walls[t].corner[k];
      table.make_room(place.size(), [&](int number) { return hash_of(place[number]); });
      int& number = table.slot(hash_of(corner), [&](int other) { return place[other] == corner; });
      if (number < 0) {
        number = static_cast<int>(place.size());
        place.push_back(corner);
      }
      welded.corner[t][k] = number;
    }
  return welded;
}

/// Finds near corners and joins them, each under the smallest number that it is joined with.
class Joiner {
public:
  Joiner(const std::vector<Vec3>& place, double tolerance)
      : place_(place), tolerance_(tolerance), next_(place.size(), -1), joined_(place.size()) {
    std::iota(joined_.begin(), joined_.end(), 0);
    for (const Vec3& p : place) low_ = low_.cwiseMin(p);
  }

  std::vector<int> join() {
    for (int number = 0; number < static_cast<int>(place_.size()); ++number) {
      join_with_neighbours(number);
      table_.make_room(cells_, [&](int other) { return hash_of(cell_of(place_[other])); });
      const Cell own = cell_of(place_[number]);
      int& first = in_cell(own);
      if (first < 0) ++cells_;
      next_[number] = first;
      first = number;
    }
    for (std::size_t k = 0; k < joined_.size(); ++k) {
      joined_[k] = root(static_cast<int>(k));
      const double moved = (place_[k] - place_[joined_[k]]).cwiseAbs().maxCoeff();
      if (moved > longest_chain * tolerance_) refuse(place_[k]);
    }
    return joined_;
  }

private:
  Cell cell_of(const Vec3& p) const {
    Cell cell;
    for (int a = 0; a < 3; ++a)
      cell[a] = static_cast<std::int64_t>(std::floor((p[a] - low_[a]) / (cell_width * tolerance_)));
    return cell;
  }

  int& in_cell(const Cell& cell) {
    return table_.slot(hash_of(cell), [&](int other) { return cell_of(place_[other]) == cell; });
  }

  void join_with_neighbours(int number) {
    const Cell from = cell_of(place_[number] - Vec3::Constant(tolerance_));
    const Cell to = cell_of(place_[number] + Vec3::Constant(tolerance_));
    for (std::int64_t x = from[0]; x <= to[0]; ++x)
      for (std::int64_t y = from[1]; y <= to[1]; ++y)
        for (std::int64_t z = from[2]; z <= to[2]; ++z) join_near(number, in_cell({x, y, z}));
  }

  void join_near(int number, int first) {
    int count = 0;
    for (int other = first; other >= 0; other = next_[other]) {
      if (++count > most_in_cell) refuse(place_[number]);
      if ((place_[number] - place_[other]).cwiseAbs().maxCoeff() > tolerance_) continue;
      const auto [less, more] = std::minmax({root(number), root(other)});
      joined_[more] = less;
    }
  }

  int root(int number) {
    while (joined_[number] != number) number = joined_[number] = joined_[joined_[number]];
    return number;
  }

  [[noreturn]] void refuse(const Vec3& p) const {
    throw Error(
        fmt::format("at ({:.6g}, {:.6g}, {:.6g}) m corners of more than one place would be joined "
                    "by a tolerance "
                    "of {:.3g} m, which is larger than the facets there: give "
                    "geometry.stl_tolerance a smaller one",
                    p.x, p.y, p.z, tolerance_));
  }

  const std::vector<Vec3>& place_;
  double tolerance_;
  Vec3 low_ = Vec3::Constant(1e300);
  NumberTable table_;  // of the first corner in each cell
  std::size_t cells_ = 0;
  std::vector<int> next_;    // corner in the same cell, or -1
  std::vector<int> joined_;  // a smaller number that it is joined with, or its own
};

/// Leaves out the numbers that were joined to others, and keeps the order.
void renumber(WeldedCorners& welded, const std::vector<int>& joined) {
  std::vector<int> number(joined.size());
  int count = 0;
  for (std::size_t k = 0; k < joined.size(); ++k) {
    if (joined[k] == static_cast<int>(k)) {
      welded.place[count] = welded.place[k];
      number[k] = count++;
    } else {
      number[k] = number[joined[k]];
    }
  }
  welded.place.resize(count);
  for (auto& corner : welded.corner)
    for (int& k : corner) k = number[k];
}

double largest_coordinate(const std::vector<Vec3>& place) {
  double largest = 0;
  for (const Vec3& p : place) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace

WeldedCorners weld_corners(const Walls& walls, double tolerance) {
  WeldedCorners welded = join_equal(walls);
  // Doubles have 53 bits: nothing is closer than this and not equal.
  constexpr double rounding = 1e-16;
  if (tolerance > rounding * largest_coordinate(welded.place)) renumber(welded, Joiner(welded.place, tolerance).join());
  return welded;
}

double largest_extent(const Walls& walls) {
  if (walls.empty()) return 0;
  Vec3 low = walls[0].corner[0], high = low;
  for (const Triangle& t : walls)
    for (const Vec3& corner : t.corner) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  return (high - low).maxCoeff();
}

}  // namespace clogflow
