#include "dem/contact/species_friction.hpp"

#include <algorithm>

namespace clogflow {

bool has_friction_of_species(const Scene::Particles& particles) {
  return std::ranges::any_of(particles.species, &Species::has_friction);
}

Friction surface_friction(const Scene& scene, const Species& kind) {
  return kind.has_friction() ? kind.friction : scene.contact.friction;
}

Friction wall_friction(const Scene& scene, const Species& kind) {
  return kind.has_friction() ? kind.wall_friction : scene.contact.wall_friction;
}

void SpeciesFriction::add(const Friction& friction) {
  if (!rows_) rows_ = std::make_shared<std::vector<double>>();
  rows_->insert(rows_->end(), {friction.sliding, friction.rolling, friction.torsion, 0});
}

SpeciesFriction SpeciesFriction::between_particles(const Scene& scene) {
  SpeciesFriction table;
  const auto& kinds = scene.particles.species;
  table.partners_ = static_cast<int>(kinds.size());
  for (const Species& first : kinds) {
    for (const Species& second : kinds) {
      const Friction a = surface_friction(scene, first), b = surface_friction(scene, second);
      table.add({mixed_friction(a.sliding, b.sliding), mixed_friction(a.rolling, b.rolling),
                 mixed_friction(a.torsion, b.torsion)});
    }
  }
  return table;
}

SpeciesFriction SpeciesFriction::with_walls(const Scene& scene) {
  SpeciesFriction table;
  for (const Species& kind : scene.particles.species) table.add(wall_friction(scene, kind));
  return table;
}

FrictionLaw SpeciesFriction::law() const {
  FrictionLaw law;
  const int rows = static_cast<int>(rows_->size()) / friction_row;
  for (int k = 0; k < rows; ++k) {
    const double* row = rows_->data() + friction_row * k;
    law.sliding = std::max(law.sliding, row[0]);
    law.rolling = std::max(law.rolling, row[1]);
    law.torsion = std::max(law.torsion, row[2]);
  }
  law.of_species = rows_->data();
  law.partners = partners_;
  return law;
}

}  // namespace clogflow
