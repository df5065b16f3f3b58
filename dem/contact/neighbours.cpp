#include "dem/contact/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "coupling/base/expect.hpp"
#include "dem/contact/size_levels.hpp"
#include "dem/state/valid.hpp"

namespace clogflow {

namespace {

/// A contact of the last step under the new numbering, i < j.
struct Remembered {
  int i, j;
  Springs<double> springs;
};

/// The contacts to remember, those of particle i from start[i] to start[i + 1].
struct Memory {
  std::vector<Remembered> contacts;
  std::vector<int> start;
};

Memory remember(const Neighbours& list, const std::vector<int>& renumbered, std::size_t particles) {
  Memory memory;
  for (std::size_t k = 0; k < list.contacts.size(); ++k) {
    const int i = renumbered[list.contacts.first(k)], j = renumbered[list.contacts.second(k)];
    if (i < 0 || j < 0) continue;
    const Springs<double> springs = list.contacts.springs(k);
    memory.contacts.push_back(i < j ? Remembered{i, j, springs} : Remembered{j, i, swapped(springs)});
  }
  std::stable_sort(memory.contacts.begin(), memory.contacts.end(),
                   [](const Remembered& a, const Remembered& b) { return a.i < b.i; });
  memory.start.assign(particles + 1, 0);
  for (const Remembered& contact : memory.contacts) ++memory.start[contact.i + 1];
  std::partial_sum(memory.start.begin(), memory.start.end(), memory.start.begin());
  return memory;
}

/// Ratio of largest to smallest radius from which a grid for each class of sizes is the quicker, as measured.
constexpr double least_unequal = 2;

/// Edge of cells for spheres of the mean size [m]
double mean_edge(const Particles& p, const Reach& reach) {
  double sum = 0;
  for (const ParticleState& s : p.states) sum += s.radius;
  const double mean = sum / static_cast<double>(p.size());
  return reach.of(mean, mean);
}

/// Pairs in ascending order of the first, as the loops over them want to find particles in memory.
void sort_by_first(std::vector<int>& first, std::vector<int>& second, std::size_t particles) {
  std::vector<int> next(particles + 1, 0), sorted_first(first.size()), sorted_second(first.size());
  for (const int i : first) ++next[i + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t k = 0; k < first.size(); ++k) {
    const int to = next[first[k]]++;
    sorted_first[to] = first[k];
    sorted_second[to] = second[k];
  }
  first.swap(sorted_first);
  second.swap(sorted_second);
}

}  // namespace

std::vector<int> Neighbours::rebuild(Particles& p, const std::vector<std::uint8_t>& leaving, const Reach& reach) {
  expect(leaving.empty() || leaving.size() == p.size());
  std::vector<int> staying;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (leaving.empty() || !leaving[i]) staying.push_back(static_cast<int>(i));
  std::vector<int> renumbered(p.size(), -1);
  p.reorder(staying);
  const double radius = p.size() ? std::ranges::max(p.states, {}, &ParticleState::radius).radius : 0;
  const double least = p.size() ? std::ranges::min(p.states, {}, &ParticleState::radius).radius : 0;
  const bool leveled = reach.by_size && radius > least_unequal * least;
  const double far = reach.per_radius > 0 ? reach.of(radius, radius) : 2 * radius + reach.lubrication + reach.skin;
  // Only the order in memory is taken from them where sizes have grids of their own.
  const Cells cells(p, leveled ? mean_edge(p, reach) : far);
  p.reorder(cells.order());
  for (std::size_t k = 0; k < staying.size(); ++k) renumbered[staying[cells.order()[k]]] = static_cast<int>(k);
  const Memory memory = remember(*this, renumbered, p.size());

  first.clear(), second.clear();
  room.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) room[i] = reach.room(p[i]);
  const auto list = [&](int i, int j) {
    const double dx = p[i].x - p[j].x, dy = p[i].y - p[j].y, dz = p[i].z - p[j].z;
    const double within = reach.contact(p[i].radius, p[j].radius) + room[i] + room[j];
    if (dx * dx + dy * dy + dz * dz >= within * within) return;
    first.push_back(i);
    second.push_back(j);
  };
  if (leveled) {
    SizeLevels(p, reach, radius, least).for_each_pair(list);
    sort_by_first(first, second, p.size());
  } else {
    cells.for_each_pair(list);
  }
  contacts.reset();
  const Candidates listed{first.data(), second.data(), first.size()};
  for (std::size_t k = 0; k < listed.count; ++k)
    for (int c = memory.start[first[k]]; c < memory.start[first[k] + 1]; ++c)
      if (memory.contacts[c].j == second[k]) contacts.add(listed, static_cast<int>(k), memory.contacts[c].springs);
  measure(p);
  expect(first.size() == second.size() && contacts.size() <= first.size());
  return renumbered;
}

void Neighbours::sort(const Particles& p, double margin, const LubricationLaw& law) {
  contacts.sort({first.data(), second.data(), first.size()}, margin, law, [&](std::size_t k) {
    const int i = first[k], j = second[k];
    const double dx = p[i].x - p[j].x, dy = p[i].y - p[j].y, dz = p[i].z - p[j].z;
    return std::sqrt(dx * dx + dy * dy + dz * dz) - p[i].radius - p[j].radius;
  });
}

void Neighbours::measure(const Particles& p) {
  const auto all_equal = [&](double ParticleState::*part) {
    return std::ranges::adjacent_find(p.states, std::not_equal_to<>(), part) == p.states.end();
  };
  smallest_radius = p.size() > 0 ? std::ranges::min(p.states, {}, &ParticleState::radius).radius : 0;
  const bool equal = p.size() > 0 && all_equal(&ParticleState::radius) && all_equal(&ParticleState::mass) &&
                     all_equal(&ParticleState::inertia);
  equal_radius = equal ? p[0].radius : 0;
  equal_mass = equal ? p[0].mass : 0;
  equal_inertia = equal ? p[0].inertia : 0;
}

bool Neighbours::valid(std::size_t particles) const {
  return first.size() == second.size() &&
         (first.empty() || (point_below(first, particles) && point_below(second, particles))) &&
         contacts.valid(first.size(), particles, particles);
}

}  // namespace clogflow
