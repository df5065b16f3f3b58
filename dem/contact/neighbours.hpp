// The pair list: which particles can meet before the list is rebuilt, and the springs of those that
// touch, carried over from list to list.
#pragma once

#include <vector>

#include "coupling/base/team.hpp"
#include "dem/contact/cells.hpp"
#include "dem/contact/pair_group.hpp"
#include "dem/contact/reach.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

class Neighbours {
public:
  /// Drops particles marked in `leaving`, sorts the rest in space (both the particles' arrays and
  /// the springs follow) and lists the pairs anew.
  /// \return for each old index its new one, -1 for a particle that left
  std::vector<int> rebuild(Particles& particles, const std::vector<std::uint8_t>& leaving, const Reach& reach,
                           Team& team);
  std::vector<int> rebuild(Particles& particles, const std::vector<std::uint8_t>& leaving, const Reach& reach);

  /// Sorts the pairs that do not touch by their gaps; holds until a gap may have changed by
  /// `margin`.
  void sort(const Particles& particles, double margin, const LubricationLaw& law, Team& team);

  /// Pairs that may touch or lubricate, i < j; in the order of their rounds.
  std::vector<PairGroup> groups;

  /// Calls visit(group, its place in `groups`) for each, those of a round at once where there are threads.
  template <class Visit>
  void for_each_group(Team& team, const Visit& visit) {
    for (std::size_t from = 0, to = 0; from < groups.size(); from = to) {
      while (to < groups.size() && groups[to].round == groups[from].round) ++to;
      team.each(static_cast<int>(to - from),
                [&](int k) { visit(groups[from + static_cast<std::size_t>(k)], from + static_cast<std::size_t>(k)); });
    }
  }

  /// Calls visit(i, j, springs) for each contact.
  template <class Visit>
  void for_each_contact(const Visit& visit) const {
    for (const PairGroup& group : groups)
      for (std::size_t k = 0; k < group.contacts.size(); ++k)
        visit(group.contacts.first(k), group.contacts.second(k), group.contacts.springs(k));
  }

  /// Calls visit(i, j) for each listed pair.
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (const PairGroup& group : groups)
      for (std::size_t k = 0; k < group.first.size(); ++k) visit(group.first[k], group.second[k]);
  }

  /// How far each particle may go until the list may miss a pair [m].
  std::vector<double> room;

  /// Radius, mass and moment of inertia of every particle if all are equal, else 0.
  double equal_radius = 0, equal_mass = 0, equal_inertia = 0;
  double smallest_radius = 0;

  /// Finds these anew.
  void measure(const Particles& particles);

  /// Whether lists read from a file fit these many particles.
  bool valid(std::size_t particles) const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(groups, room);
  }

private:
  void list_pairs(const Particles& particles, const Cells& cells, const Reach& reach, Team& team);
  void list_by_size(const Particles& particles, const Reach& reach, double largest, double smallest);
};

}  // namespace clogflow
