// What a run says when it cannot go on, and of contacts that are too deep.
#pragma once

#include <string>

#include "dem/run/run_state.hpp"

namespace clogflow {

/// Two bodies pressed into each other.
struct DeepContact {
  int particle = 0, other = -1;  ///< other < 0: a wall
  double overlap = 0;            ///< [m]
  double share = 0;              ///< of the smaller one's diameter [-]
};
/// By its share.
DeepContact deepest_contact(const RunState& state);

/// "particle 3 at (...) m overlaps a wall by ..."
std::string contact_words(const RunState& state, const DeepContact& contact);

/// The fastest particle, or the first whose velocity is no number.
int fastest_particle(const RunState& state);

/// What may be done about a run that ends with this particle, by what is known of it.
std::string remedy(const RunState& state, const ParticleState& worst);

/// \throws Error that names the step, the cause and the particle
[[noreturn]] void blow_up(const RunState& state, const char* cause, int particle);

}  // namespace clogflow
