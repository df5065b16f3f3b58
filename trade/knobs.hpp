// What can be made cheaper or dearer, and what is tried to learn what matters.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"

namespace clogflow::trade {

/// Numerics may be chosen for their cost; physics never is: it is changed to see what follows.
enum class Kind { numerics, physics };

/// One way to run a scene.
struct Setting {
  std::string name = {};
  std::string knob = {};     ///< what is turned, in words
  std::string against = {};  ///< name of the setting that differs in this knob alone; empty: the reference
  Kind kind = Kind::numerics;
  Overrides overrides = {};  ///< of the scene
};

/// The matrix of the study, the most faithful first, each after the one that it is compared with. The first
/// is E = 3 GPa at tau/50 with the true mass; most knobs are turned on `cheap`, which a chain of
/// refinements ties to it: gpa3, mpa30, tau50, mass10, cheap. At 30 MPa the true mass and step change nothing
/// that was seen, at 3 MPa particles have more contacts: so cheap_30MPa stands before tau50.
/// \throws Error as require_studied_laws()
std::vector<Setting> settings_for(const Scene& scene);

/// \throws Error, after `what`, unless the scene has the contact law whose numerics the knobs turn
void require_studied_laws(const Scene& scene, const std::string& what);

}  // namespace clogflow::trade
