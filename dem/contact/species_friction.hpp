// Friction where species have their own: a row of coefficients for each pair, made once.
#pragma once

#include <memory>
#include <vector>

#include "coupling/scene/scene.hpp"
#include "dem/physics/friction.hpp"

namespace clogflow {

/// Whether any species names a friction.
bool has_friction_of_species(const Scene::Particles& particles);

/// Of the surface of a species: its own, or that of contact.friction.
Friction surface_friction(const Scene& scene, const Species& kind);

/// With the walls: its own, or contact.wall_friction. What a species leaves out of it is filled in by
/// coupling/scene/scene_defaults.cpp.
Friction wall_friction(const Scene& scene, const Species& kind);

/// Copies share the rows, so that laws which point to them may be copied with their model.
class SpeciesFriction {
public:
  SpeciesFriction() = default;

  /// Each pair by mixed_friction(), coefficient by coefficient.
  static SpeciesFriction between_particles(const Scene& scene);

  /// A wall has no surface of its own to mix with: these are coefficients of the contact.
  static SpeciesFriction with_walls(const Scene& scene);

  /// The largest of each coefficient, and where the rows are; for as long as one copy of this lives.
  FrictionLaw law() const;

private:
  void add(const Friction& friction);

  std::shared_ptr<std::vector<double>> rows_;
  int partners_ = 1;
};

}  // namespace clogflow
