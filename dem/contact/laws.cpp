#include "dem/contact/laws.hpp"

#include <string_view>

#include "coupling/scene/particle_sizes.hpp"
#include "dem/physics/contact_laws.hpp"

namespace clogflow {

namespace {

struct Other {
  Material material;
  double restitution;
  Friction friction;
};

/// Of a particle and what it meets.
ContactLaw contact_law(const Scene& scene, const Other& other) {
  const auto& c = scene.contact;
  const std::string_view turning =
      c.torsion_update == TorsionUpdate::doubling ? "doubling" : std::string_view(c.turning);
  return make_contact_law(c.law, turning,
                          {.own = {c.youngs_modulus, c.poisson_ratio},
                           .other = other.material,
                           .restitution = other.restitution,
                           .tangential_factor = c.tangential_factor,
                           .tangential_damping = c.tangential_damping,
                           .stiffness = c.stiffness,
                           .surface_energy = c.surface_energy},
                          {other.friction.sliding, other.friction.rolling, other.friction.torsion});
}

template <class Coefficients>
ContactTerms contact_terms(const Coefficients& friction) {
  return {friction.sliding > 0, friction.rolling > 0, friction.torsion > 0};
}

LubricationLaw lubrication_law(const Scene& scene) {
  if (!scene.lubrication.enabled) return {};
  LubricationLaw law{scene.fluid.viscosity, 2 * scene.particles.roughness, scene.lubrication.cutoff,
                     scene.lubrication.below_roughness == BelowRoughness::clamp};
  const ParticleSizes sizes(scene.particles);
  if (sizes.equal()) return law;
  // The cut-off is that of two particles of the mean size.
  law.per_radius = 4 * law.farthest / scene.particles.diameter;
  law.farthest *= sizes.largest() / scene.particles.diameter;
  return law;
}

}  // namespace

Laws make_laws(const Scene& scene) {
  const Scene::Contact& c = scene.contact;
  Laws laws;
  laws.pair = contact_law(scene, {{c.youngs_modulus, c.poisson_ratio}, c.restitution, c.friction});
  laws.pair_terms = contact_terms(c.friction);
  laws.film = lubrication_law(scene);
  const double wall_restitution = c.wall_restitution > 0 ? c.wall_restitution : c.restitution;
  laws.wall.contact =
      contact_law(scene, {{c.wall_youngs_modulus, c.wall_poisson_ratio}, wall_restitution, c.wall_friction});
  laws.wall.terms = contact_terms(c.wall_friction);
  if (has_friction_of_species(scene.particles)) {
    laws.pair_friction = SpeciesFriction::between_particles(scene);
    laws.wall_friction = SpeciesFriction::with_walls(scene);
    laws.pair.friction = laws.pair_friction.law();
    laws.wall.contact.friction = laws.wall_friction.law();
    laws.pair_terms = contact_terms(laws.pair.friction);
    laws.wall.terms = contact_terms(laws.wall.contact.friction);
  }
  if (scene.lubrication.walls) laws.wall.lubrication = laws.film;
  laws.wall.lubrication.per_radius /= 2;  // R* at a wall is twice that of two equal spheres
  return laws;
}

bool adheres(const Scene::Contact& contact) { return contact_traits(contact.law).sticks; }

const char* stiffness_key(const Scene::Contact& contact) {
  return contact_traits(contact.law).knows_modulus ? "contact.youngs_modulus" : "contact.stiffness";
}

std::string overlap_remedy(const Scene::Contact& contact, const char* between) {
  const std::string stiffer = std::string("raise ") + stiffness_key(contact);
  return adheres(contact) ? stiffer + between + "lower contact.surface_energy" : stiffer;
}

}  // namespace clogflow
