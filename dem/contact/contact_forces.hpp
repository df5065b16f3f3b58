// The forces of all contacts, one by one, as the hot loop summed them up.
#pragma once

#include <vector>

#include "dem/contact/laws.hpp"
#include "dem/contact/neighbours.hpp"
#include "dem/contact/wall_contacts.hpp"

namespace clogflow {

/// What one contact does to a particle.
struct ContactForce {
  int particle, other;  ///< other: -1 is a wall
  Vec3 normal;          ///< from the other to the particle [-]
  Vec3 force;           ///< on the particle, along the normal and across it; the other gets the opposite [N]
};

/// After the forces of a step, whose springs stand where that step put them: so no time passes here. Their sum is what
/// the hot loop added to each particle, but for rounding; films are no contacts.
/// \param pair, wall  laws as they are now: without friction in a release
/// \param dt          in which springs grew to where they are now [s]
std::vector<ContactForce> contact_forces(const Particles& particles, const Neighbours& pairs, const WallContacts& walls,
                                         const ContactLaw& pair, const ContactLaw& wall, double dt);

}  // namespace clogflow
