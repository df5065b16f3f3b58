#include "dem/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dem/sound.hpp"

namespace clog {

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
    const int pair = list.contacts.candidate(k);
    const int i = renumbered[list.first[pair]], j = renumbered[list.second[pair]];
    if (i < 0 || j < 0) continue;
    const Springs<double> springs = list.contacts.springs(k);
    memory.contacts.push_back(i < j ? Remembered{i, j, springs}
                                    : Remembered{j, i, swapped(springs)});
  }
  std::stable_sort(memory.contacts.begin(), memory.contacts.end(),
                   [](const Remembered& a, const Remembered& b) { return a.i < b.i; });
  memory.start.assign(particles + 1, 0);
  for (const Remembered& contact : memory.contacts) ++memory.start[contact.i + 1];
  std::partial_sum(memory.start.begin(), memory.start.end(), memory.start.begin());
  return memory;
}

}  // namespace

std::vector<int> Neighbours::rebuild(Particles& p, const std::vector<std::uint8_t>& leaving,
                                     const Reach& reach) {
  std::vector<int> staying;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (leaving.empty() || !leaving[i]) staying.push_back(static_cast<int>(i));
  std::vector<int> renumbered(p.size(), -1);
  p.reorder(staying);
  const double radius = p.size() ? *std::max_element(p.radius.begin(), p.radius.end()) : 0;
  const Cells cells(p, 2 * radius + reach.lubrication + reach.skin);
  p.reorder(cells.order());
  for (std::size_t k = 0; k < staying.size(); ++k)
    renumbered[staying[cells.order()[k]]] = static_cast<int>(k);
  const Memory memory = remember(*this, renumbered, p.size());

  first.clear(), second.clear(), far_first.clear(), far_second.clear();
  cells.for_each_pair([&](int i, int j) {
    const double dx = p.x[i] - p.x[j], dy = p.y[i] - p.y[j], dz = p.z[i] - p.z[j];
    const double distance2 = dx * dx + dy * dy + dz * dz;
    const double near = p.radius[i] + p.radius[j] + reach.skin;
    const double far = near + reach.lubrication;
    if (distance2 < near * near) {
      first.push_back(i), second.push_back(j);
    } else if (reach.lubrication > 0 && distance2 < far * far) {
      far_first.push_back(i), far_second.push_back(j);
    }
  });
  count = first.size();
  far_count = far_first.size();
  for (auto* indices : {&first, &second, &far_first, &far_second})
    indices->resize(indices->size() + widest_vector, 0);
  contacts.reset(count);
  for (std::size_t k = 0; k < count; ++k)
    for (int c = memory.start[first[k]]; c < memory.start[first[k] + 1]; ++c)
      if (memory.contacts[c].j == second[k])
        contacts.add(static_cast<int>(k), first[k], second[k],
                     memory.contacts[c].springs);
  return renumbered;
}

bool Neighbours::sound(std::size_t particles) const {
  // Before they are made for the first time the lists have no padding.
  const auto fits = [&](const std::vector<int>& indices, std::size_t used) {
    return (used == 0 || (particles > 0 && indices.size() == used + widest_vector)) &&
           point_below(indices, particles);
  };
  return fits(first, count) && fits(second, count) && fits(far_first, far_count) &&
         fits(far_second, far_count) && contacts.sound(count, particles, particles);
}

}  // namespace clog
