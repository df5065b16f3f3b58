#include "coupling/openfoam/quadratic_flow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clogflow {
namespace {

constexpr int rings = 2;            // of neighbours: 24 around a cube, for 10 terms
constexpr double nearest = 0.1;     // a neighbour's weight is 1 / (distance^2 / h^2 + this)
constexpr double dependent = 1e-9;  // a pivot below this share of its column's square is no new direction
constexpr double least = 1e-3;      // weight of the own cell's polynomial in its farthest corner

// Lists of numbers in one array: of each pair the second, by the first.
void index_pairs(const std::vector<std::pair<int, int>>& pairs, std::size_t count, std::vector<int>& first,
                 std::vector<int>& next) {
  first.assign(count + 1, 0);
  for (const auto& pair : pairs) ++first[pair.first + 1];
  for (std::size_t i = 0; i < count; ++i) first[i + 1] += first[i];
  next.resize(pairs.size());
  std::vector<int> end(first.begin(), first.end() - 1);
  for (const auto& [from, to] : pairs) next[end[from]++] = to;
}

// Normal equations of a least-squares fit of `size` terms to vectors.
template <std::size_t size>
class Fit {
public:
  void add(const std::array<double, size>& row, const Vec3& value, double weight) {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j <= i; ++j) matrix_[i][j] += weight * row[i] * row[j];
      for (int c = 0; c < 3; ++c) right_[c][i] += weight * row[i] * value[c];
    }
  }

  // By L D L^T. Terms that the points do not tell from earlier ones are left out.
  std::array<std::array<double, size>, 3> solved() {
    std::array<double, size> pivot{};
    for (std::size_t j = 0; j < size; ++j) {
      double left = matrix_[j][j];
      for (std::size_t k = 0; k < j; ++k) left -= matrix_[j][k] * matrix_[j][k] * pivot[k];
      const bool told = left > dependent * matrix_[j][j];
      pivot[j] = told ? left : 0;
      for (std::size_t i = j + 1; i < size; ++i) {
        double sum = matrix_[i][j];
        for (std::size_t k = 0; k < j; ++k) sum -= matrix_[i][k] * matrix_[j][k] * pivot[k];
        matrix_[i][j] = told ? sum / left : 0;
      }
    }
    auto x = right_;
    for (auto& of : x) {
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t k = 0; k < i; ++k) of[i] -= matrix_[i][k] * of[k];
      for (std::size_t i = 0; i < size; ++i) of[i] = pivot[i] > 0 ? of[i] / pivot[i] : 0;
      for (std::size_t i = size; i-- > 0;) {
        if (pivot[i] == 0) continue;
        for (std::size_t k = i + 1; k < size; ++k) of[i] -= matrix_[k][i] * of[k];
      }
    }
    return x;
  }

private:
  std::array<std::array<double, size>, size> matrix_{};
  std::array<std::array<double, size>, 3> right_{};
};

}  // namespace

QuadraticFlow::Terms QuadraticFlow::powers(const Vec3& d) {
  return {1, d.x, d.y, d.z, d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.x * d.z, d.y * d.z};
}

QuadraticFlow::QuadraticFlow(const FoamCells& cells) : piece_(cells.centre.size()), seen_(cells.centre.size(), -1) {
  link(cells);
  for (int c = 0; c < static_cast<int>(piece_.size()); ++c) fit(c, cells);
  seen_ = {}, ring_ = {};
}

void QuadraticFlow::link(const FoamCells& cells) {
  std::vector<std::pair<int, int>> pairs, walls;
  for (std::size_t f = 0; f < cells.neighbour.size(); ++f) {
    pairs.emplace_back(cells.owner[f], cells.neighbour[f]);
    pairs.emplace_back(cells.neighbour[f], cells.owner[f]);
  }
  for (std::size_t f = 0; f < cells.wall.size(); ++f) walls.emplace_back(cells.wall_cell[f], static_cast<int>(f));
  index_pairs(pairs, cells.centre.size(), first_, next_);
  index_pairs(walls, cells.centre.size(), first_wall_, next_wall_);
}

void QuadraticFlow::fit(int cell, const FoamCells& cells) {
  Piece& piece = piece_[cell];
  piece.centre = cells.centre[cell];
  ring_ = {cell};
  seen_[cell] = cell;
  std::size_t begin = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = ring_.size();
    for (; begin < end; ++begin)
      for (int n = first_[ring_[begin]]; n < first_[ring_[begin] + 1]; ++n)
        if (std::exchange(seen_[next_[n]], cell) != cell) ring_.push_back(next_[n]);
  }
  const int neighbours = first_[cell + 1] - first_[cell];
  double sum = 0;
  for (int n = first_[cell]; n < first_[cell + 1]; ++n) sum += (cells.centre[next_[n]] - piece.centre).norm();
  piece.size = neighbours > 0 ? sum / neighbours : 1;

  Fit<terms> fit;
  const auto add = [&](const Vec3& place, const Vec3& velocity) {
    const Vec3 d = (place - piece.centre) / piece.size;
    fit.add(powers(d), velocity, 1 / (d.squaredNorm() + nearest));
  };
  for (const int other : ring_) {
    add(cells.centre[other], cells.velocity[other]);
    for (int f = first_wall_[other]; f < first_wall_[other + 1]; ++f) add(cells.wall[next_wall_[f]], Vec3::Zero());
  }
  const auto found = fit.solved();
  for (int c = 0; c < 3; ++c)
    std::ranges::transform(found[c], piece.factor[c].begin(), [](double v) { return static_cast<float>(v); });
}

Vec3 QuadraticFlow::at(int cell, const Vec3& place) const {
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  const double size = piece_[cell].size;
  const auto add = [&](const Piece& piece, double floor) {
    const double near = 1 - (place - piece.centre).squaredNorm() / (size * size);
    const double weight = std::max(near > 0 ? near * near : 0, floor);
    if (weight == 0) return;
    const Terms power = powers((place - piece.centre) / piece.size);
    for (int c = 0; c < 3; ++c) {
      double value = 0;
      for (int i = 0; i < terms; ++i) value += double{piece.factor[c][i]} * power[i];
      sum[c] += weight * value;
    }
    weights += weight;
  };
  add(piece_[cell], least);
  for (int n = first_[cell]; n < first_[cell + 1]; ++n) add(piece_[next_[n]], 0);
  return sum / weights;
}

}  // namespace clogflow
