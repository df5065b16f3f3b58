// The pair list: which particles can meet before the list is rebuilt, and the springs of those that
// touch, carried over from list to list.
#pragma once

#include <vector>

#include "dem/cells.hpp"
#include "dem/contact_set.hpp"
#include "dem/particles.hpp"

namespace clog {

/// How far a pair list looks.
struct Reach {
  double skin = 0;         ///< two particles may together drift this far before a rebuild [m]
  double lubrication = 0;  ///< largest gap with a lubrication force; 0: none [m]
};

class Neighbours {
public:
  /// Drops particles marked in `leaving`, sorts the rest in space (both the particles' arrays and
  /// the springs follow) and lists the pairs anew.
  /// \return for each old index its new one, -1 for a particle that left
  std::vector<int> rebuild(Particles& particles, const std::vector<std::uint8_t>& leaving,
                           const Reach& reach);

  /// Pairs that may touch, i < j: the candidates of `contacts`.
  std::vector<int> first, second;
  std::size_t count = 0;  ///< the lists are padded beyond it, to whole vectors
  /// Pairs that can at most lubricate.
  std::vector<int> far_first, far_second;
  std::size_t far_count = 0;
  ContactSet contacts;

  /// Whether lists read from a file fit these many particles.
  bool sound(std::size_t particles) const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(first, second, far_first, far_second, contacts, count, far_count);
  }
};

}  // namespace clog
