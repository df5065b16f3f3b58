// What can be made cheaper or dearer, and what is tried to learn what matters.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"

namespace clogflow::trade {

enum class Kind {
  dose,      ///< softness, mass or step: may be chosen for its cost
  numerics,  ///< another choice of the method, compared with the base
  physics,   ///< changed to see what follows
};

/// One way to run a scene.
struct Setting {
  std::string name = {};
  std::string knob = {};     ///< what is turned, in words
  std::string against = {};  ///< name of the setting that differs in this knob alone; empty: the reference
  Kind kind = Kind::dose;
  Overrides overrides = {};  ///< of the scene
};

/// The matrix of the study, the most faithful first: E = 3 GPa at tau/50 with the true mass. All others turn one knob,
/// or few, of a base: 10 MPa, mass x 30, moment of inertia x 5 more, a step of 0.7 of what the contacts allow.
/// \throws Error as require_studied_laws()
std::vector<Setting> settings_for(const Scene& scene);

/// \throws Error, after `what`, unless the scene has the contact law whose numerics the knobs turn
void require_studied_laws(const Scene& scene, const std::string& what);

}  // namespace clogflow::trade
