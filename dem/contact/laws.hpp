// The laws of a scene: what acts between two particles, and between a particle and a wall.
#pragma once

#include <string>

#include "coupling/scene/scene.hpp"
#include "dem/contact/species_friction.hpp"
#include "dem/physics/contact_law.hpp"
#include "dem/physics/lubrication.hpp"

namespace clogflow {

/// What acts between a particle and a wall.
struct WallLaws {
  ContactLaw contact;
  ContactTerms terms;
  LubricationLaw lubrication;
  double dt = 0;
};

struct Laws {
  ContactLaw pair;
  ContactTerms pair_terms{};
  LubricationLaw film;  ///< between particles
  WallLaws wall;
  SpeciesFriction pair_friction, wall_friction;  ///< what the friction of both laws points to
};

/// Those that the sections [contact] and [lubrication] name; the step is not known yet.
Laws make_laws(const Scene& scene);

/// Whether spheres of this law stick.
bool adheres(const Scene::Contact& contact);

/// The key of the scene to raise for stiffer contacts.
const char* stiffness_key(const Scene::Contact& contact);

/// What makes overlaps smaller: "raise contact.youngs_modulus", and less adhesion where there is some.
/// \param between  the two, if there are two
std::string overlap_remedy(const Scene::Contact& contact, const char* between = " or ");

}  // namespace clogflow
