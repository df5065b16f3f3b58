#include "dem/contact/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include "coupling/base/expect.hpp"
#include "dem/contact/size_levels.hpp"
#include "dem/kernels/blocks.hpp"
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
  std::vector<Remembered> known;
  list.for_each_contact([&](int before, int other, const Springs<double>& springs) {
    const int i = renumbered[before], j = renumbered[other];
    if (i < 0 || j < 0) return;
    known.push_back(i < j ? Remembered{i, j, springs} : Remembered{j, i, swapped(springs)});
  });
  memory.start.assign(particles + 1, 0);
  for (const Remembered& contact : known) ++memory.start[contact.i + 1];
  std::partial_sum(memory.start.begin(), memory.start.end(), memory.start.begin());
  std::vector<int> next(memory.start.begin(), memory.start.end() - 1);
  memory.contacts.resize(known.size());
  for (const Remembered& contact : known) memory.contacts[next[contact.i]++] = contact;
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
void sort_by_first(PairGroup& group, std::size_t particles) {
  std::vector<int> next(particles + 1, 0), first(group.first.size()), second(group.first.size());
  for (const int i : group.first) ++next[i + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t k = 0; k < first.size(); ++k) {
    const int to = next[group.first[k]]++;
    first[to] = group.first[k];
    second[to] = group.second[k];
  }
  group.first.swap(first);
  group.second.swap(second);
}

/// Whether two particles can meet before the list is made anew.
struct MayMeet {
  const Particles& p;
  const std::vector<double>& room;
  const Reach& reach;

  bool operator()(int i, int j) const {
    const double dx = p[i].x - p[j].x, dy = p[i].y - p[j].y, dz = p[i].z - p[j].z;
    const double within = reach.contact(p[i].radius, p[j].radius) + room[i] + room[j];
    return dx * dx + dy * dy + dz * dz < within * within;
  }
};

/// The group of two blocks among those of the first; made where there is none.
PairGroup& group_of(std::vector<PairGroup>& groups, int block, int other) {
  for (PairGroup& group : groups)
    if (group.other == other) return group;
  return groups.emplace_back(block, other);
}

/// Lets those touch that touched before.
void recall(PairGroup& group, const Memory& memory) {
  group.contacts.reset();
  const Candidates listed = group.candidates();
  for (std::size_t k = 0; k < listed.count; ++k)
    for (int c = memory.start[listed.first[k]]; c < memory.start[listed.first[k] + 1]; ++c)
      if (memory.contacts[c].j == listed.second[k])
        group.contacts.add(listed, static_cast<int>(k), memory.contacts[c].springs);
}

}  // namespace

std::vector<int> Neighbours::rebuild(Particles& p, const std::vector<std::uint8_t>& leaving, const Reach& reach) {
  Team alone;
  return rebuild(p, leaving, reach, alone);
}

std::vector<int> Neighbours::rebuild(Particles& p, const std::vector<std::uint8_t>& leaving, const Reach& reach,
                                     Team& team) {
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
  room.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) room[i] = reach.room(p[i]);
  if (leveled)
    list_by_size(p, reach, radius, least);
  else
    list_pairs(p, cells, reach, team);
  put_in_rounds(groups, Blocks(p.size()).count());
  team.each(static_cast<int>(groups.size()), [&](int k) { recall(groups[static_cast<std::size_t>(k)], memory); });
  measure(p);
  return renumbered;
}

void Neighbours::list_pairs(const Particles& p, const Cells& cells, const Reach& reach, Team& team) {
  const MayMeet may_meet{p, room, reach};
  const Blocks blocks(p.size());
  std::vector<std::vector<PairGroup>> found(static_cast<std::size_t>(blocks.count()));
  team.each(blocks.count(), [&](int block) {
    auto& own = found[static_cast<std::size_t>(block)];
    own.emplace_back(block, block);
    cells.for_each_pair(blocks.begin(block), blocks.end(block), [&](int i, int j) {
      if (!may_meet(i, j)) return;
      const int other = blocks.of(j);
      PairGroup& group = other == block ? own.front() : group_of(own, block, other);
      group.first.push_back(i);
      group.second.push_back(j);
    });
  });
  groups.clear();
  for (auto& own : found) std::ranges::move(own, std::back_inserter(groups));
}

void Neighbours::list_by_size(const Particles& p, const Reach& reach, double largest, double smallest) {
  const MayMeet may_meet{p, room, reach};
  const Blocks blocks(p.size());
  std::vector<std::vector<PairGroup>> found(static_cast<std::size_t>(blocks.count()));
  SizeLevels(p, reach, largest, smallest).for_each_pair([&](int i, int j) {
    if (!may_meet(i, j)) return;
    const int block = blocks.of(i);
    PairGroup& group = group_of(found[static_cast<std::size_t>(block)], block, blocks.of(j));
    group.first.push_back(i);
    group.second.push_back(j);
  });
  groups.clear();
  for (auto& own : found) std::ranges::move(own, std::back_inserter(groups));
  for (PairGroup& group : groups) sort_by_first(group, p.size());
}

void Neighbours::sort(const Particles& p, double margin, const LubricationLaw& law, Team& team) {
  team.each(static_cast<int>(groups.size()), [&](int number) {
    PairGroup& group = groups[static_cast<std::size_t>(number)];
    group.contacts.sort(group.candidates(), margin, law, [&](std::size_t k) {
      const int i = group.first[k], j = group.second[k];
      const double dx = p[i].x - p[j].x, dy = p[i].y - p[j].y, dz = p[i].z - p[j].z;
      return std::sqrt(dx * dx + dy * dy + dz * dz) - p[i].radius - p[j].radius;
    });
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
  const Blocks blocks(particles);
  const auto is_block = [&](int block) { return block >= 0 && block < blocks.count(); };
  const auto within = [&](const std::vector<int>& list, int block) {
    return std::ranges::all_of(list, [&](int i) { return i >= 0 && blocks.of(i) == block; });
  };
  for (const PairGroup& g : groups) {
    if (g.first.size() != g.second.size() || !is_block(g.block) || !is_block(g.other)) return false;
    if (!within(g.first, g.block) || !within(g.second, g.other)) return false;
    if (!g.first.empty() && !(point_below(g.first, particles) && point_below(g.second, particles))) return false;
    if (!g.contacts.valid(g.first.size(), particles, particles)) return false;
  }
  // Threads rely on the rounds.
  std::vector<PairGroup> rounds;
  for (const PairGroup& g : groups) rounds.emplace_back(g.block, g.other);
  put_in_rounds(rounds, blocks.count());
  return std::ranges::equal(rounds, groups, [](const PairGroup& a, const PairGroup& b) {
    return a.block == b.block && a.other == b.other && a.round == b.round;
  });
}

}  // namespace clogflow
