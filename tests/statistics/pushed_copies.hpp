// Copies of a run that differ by a push too small to be seen, and what becomes of each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/base/random_stream.hpp"
#include "dem/run/simulation.hpp"

namespace clogflow::test {

/// Moves each centre by at most `amount` along x, y and z each [m]. Contacts keep their springs: a push far below
/// the overlaps changes no force that could be measured, one as large as they are begins with other forces.
void push(Particles& particles, double amount, RandomStream random);

/// A state and the run that it is of.
struct Branching {
  const Scene& scene;  ///< unclog.protocol = "rewind", which says when a clog is proved and goes on
  const FlowGrid* flow;
  std::uint64_t seed;
  std::string state;   ///< of Simulation::save(), friction on
  std::size_t within;  ///< passages after which a copy that has not clogged is left
};

struct Future {
  std::vector<std::int64_t> passed;  ///< numbers of the particles, in order, at most `within`
  bool clogged = false;              ///< before `within` had passed
};

/// What becomes of the state after a push. Copy 0 is not pushed: it is the run itself.
/// \param copy  names the random numbers of the push \param amount as in push()
Future future_of(const Branching& branching, std::uint64_t copy, double amount);

/// A step of the loop of Simulation::run(). \return whether it was the last one
bool step(Simulation& simulation);

/// Clogs until now.
inline std::size_t clogs(const Simulation& simulation) { return simulation.data().releases.off.size(); }

/// How many passages two futures have in common before the first that differs.
std::size_t alike(const Future& a, const Future& b);

}  // namespace clogflow::test
