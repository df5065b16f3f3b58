// The pair list: which particles can meet before the list is rebuilt, and the springs of those that
// touch, carried over from list to list.
#pragma once

#include <vector>

#include "dem/contact/cells.hpp"
#include "dem/contact/contact_set.hpp"
#include "dem/contact/reach.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

class Neighbours {
public:
  /// Drops particles marked in `leaving`, sorts the rest in space (both the particles' arrays and
  /// the springs follow) and lists the pairs anew.
  /// \return for each old index its new one, -1 for a particle that left
  std::vector<int> rebuild(Particles& particles, const std::vector<std::uint8_t>& leaving, const Reach& reach);

  /// Sorts the pairs that do not touch by their gaps; holds until a gap may have changed by
  /// `margin`.
  void sort(const Particles& particles, double margin, const LubricationLaw& law);

  /// Pairs that may touch or lubricate, i < j: the candidates of `contacts`.
  std::vector<int> first, second;
  ContactSet contacts;

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
    archive(first, second, contacts, room);
  }
};

}  // namespace clogflow
