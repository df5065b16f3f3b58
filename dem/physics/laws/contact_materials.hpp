// What a scene gives to a contact law, the two materials and what is common to them; and what a law says of itself.
#pragma once

#include "dem/physics/material_pair.hpp"

namespace clogflow {

/// What messages and plans ask of a law.
struct ContactTraits {
  bool knows_modulus = true;  ///< its stiffness is that of contact.youngs_modulus, not of contact.stiffness
  bool sticks = false;        ///< by contact.surface_energy
};

struct ContactMaterials {
  Material own, other;
  double restitution = 1;         ///< e of a dry head-on impact [-]
  double tangential_factor = 1;   ///< on the sliding stiffness [-]
  double tangential_damping = 1;  ///< damping ratio of the other springs over the normal one [-]
  double stiffness = 0;           ///< of a linear spring [N/m]; 0: not given
  double surface_energy = 0;      ///< work of adhesion w, both surfaces together [J/m2]; 0: none
};

}  // namespace clogflow
