#include "trade/knobs.hpp"

#include <fmt/format.h>

#include "coupling/base/require.hpp"

namespace clogflow::trade {

namespace {

/// The paper's particles, and softened ones.
constexpr const char* gigapascals = "contact.youngs_modulus=3 GPa";
constexpr const char* stiffer = "contact.youngs_modulus=30 MPa";
constexpr const char* stiff = "contact.youngs_modulus=10 MPa";
constexpr const char* soft = "contact.youngs_modulus=3 MPa";

Overrides full_numerics(const char* modulus, int mass_scale) {
  return {modulus, fmt::format("time.mass_scale={}", mass_scale), "time.rotational_inertia_scale=1",
          "time.step_fraction=0.02"};
}

std::string key_of(const std::string& override) { return override.substr(0, override.find('=')); }

/// The numerics that most knobs are turned on, each key once.
Overrides cheap_with(const Overrides& more) {
  Overrides overrides{soft, "time.mass_scale=10", "time.rotational_inertia_scale=5", "time.step_fraction=0.04"};
  for (const std::string& override : more) {
    std::erase_if(overrides, [&](const std::string& known) { return key_of(known) == key_of(override); });
    overrides.push_back(override);
  }
  return overrides;
}

/// A step by the limit of the contacts alone.
Overrides at_limit(const char* share, const Overrides& more = {}) {
  Overrides overrides{"time.step_fraction=1", fmt::format("time.contact_limit_share={}", share)};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

void add_numerics(std::vector<Setting>& all, const Scene& scene) {
  const auto add = [&](const char* name, const char* knob, const Overrides& more, const char* against = "cheap") {
    all.push_back({name, knob, against, Kind::numerics, cheap_with(more)});
  };
  const auto add_at_limit = [&](const char* name, const char* knob, const char* share, const Overrides& more) {
    add(name, knob, at_limit(share, more), "cheap_limit80");
  };
  add("cheap_tau50", "step", {"time.step_fraction=0.02"});
  add("cheap_tau20", "step", {"time.step_fraction=0.05"});
  add("cheap_tau15", "step", {"time.step_fraction=0.0667"});
  add("cheap_limit70", "step", at_limit("0.7"));
  add("cheap_limit80", "step", at_limit("0.8"));
  add_at_limit("i10_limit80", "moment of inertia", "0.8", {"time.rotational_inertia_scale=10"});
  add_at_limit("m30_limit80", "mass", "0.8", {"time.mass_scale=30"});
  add_at_limit("m30_i10_limit80", "mass and moment of inertia", "0.8",
               {"time.mass_scale=30", "time.rotational_inertia_scale=10"});
  add_at_limit("m50_limit80", "mass", "0.8", {"time.mass_scale=50"});
  add("10MPa_m30_limit70", "Young's modulus x 3 and mass", at_limit("0.7", {stiff, "time.mass_scale=30"}),
      "cheap_limit70");
  add_at_limit("5MPa_m30_limit80", "Young's modulus x 5/3 and mass", "0.8",
               {"contact.youngs_modulus=5 MPa", "time.mass_scale=30"});
  add_at_limit("2MPa_m30_limit80", "Young's modulus x 2/3 and mass", "0.8",
               {"contact.youngs_modulus=2 MPa", "time.mass_scale=30"});
  add_at_limit("1MPa_limit80", "Young's modulus / 3", "0.8", {"contact.youngs_modulus=1 MPa"});
  add_at_limit("1MPa_m30_limit80", "Young's modulus / 3 and mass", "0.8",
               {"contact.youngs_modulus=1 MPa", "time.mass_scale=30"});
  add("cheap_i1", "moment of inertia", {"time.rotational_inertia_scale=1"});
  add("cheap_i10", "moment of inertia", {"time.rotational_inertia_scale=10"});
  add("cheap_m100", "mass", {"time.mass_scale=100"});
  add("cheap_m1000", "mass", {"time.mass_scale=1000"});
  add("cheap_300kPa", "Young's modulus / 10", {"contact.youngs_modulus=300 kPa"});
  add("cheap_implicit_drag", "integrator", {"time.integrator=implicit_drag"});
  add("cheap_implicit_fluid", "integrator", {"time.integrator=implicit_fluid"});
  add("cheap_trilinear", "lookup", {"flow.lookup=trilinear"});
  add("cheap_strips1", "strips", {"porosity.strips=1"});
  add("cheap_strips6", "strips", {"porosity.strips=6"});
  add("cheap_rare_porosity", "update of the strips", {"porosity.update_interval=5 ms"});
  add("cheap_rarer_porosity", "update of the strips", {"porosity.update_interval=50 ms"});
  add("cheap_lubrication_short", "lubrication cut-off",
      {fmt::format("lubrication.cutoff={} m", scene.particles.diameter / 4)});
}

void add_physics(std::vector<Setting>& all) {
  const auto add = [&](const char* name, const char* knob, const Overrides& more, const char* against = "cheap") {
    all.push_back({name, knob, against, Kind::physics, cheap_with(more)});
  };
  add("cheap_lubrication_off", "lubrication off", {"lubrication.enabled=false"});
  add("cheap_lubrication_clamp", "lubrication held below 2 xi", {"lubrication.below_roughness=clamp"});
  add("restitution03_limit70", "restitution", at_limit("0.7", {"contact.restitution=0.3"}), "cheap_limit70");
  add("cheap_superficial", "drag of the superficial velocity", {"drag.velocity=superficial"});
  add("cheap_rolling0", "no rolling friction", {"contact.friction.rolling=0"});
  add("cheap_torsion0", "no torsion friction", {"contact.friction.torsion=0"});
  add("cheap_rolling12", "rolling friction doubled", {"contact.friction.rolling=1.2"});
  add("cheap_torsion12", "torsion friction doubled", {"contact.friction.torsion=1.2"});
  add("cheap_doubling", "doubling torsion spring", {"contact.torsion_update=doubling"});
  add("cheap_doubling_tau50", "doubling torsion spring, half the step",
      {"time.step_fraction=0.02", "contact.torsion_update=doubling"}, "cheap_doubling");
}

}  // namespace

void require_studied_laws(const Scene& scene, const std::string& what) {
  const auto& contact = scene.contact;
  require(contact.law == "hertz" && contact.turning == "luding",
          "{}: contact.law = \"{}\" with contact.turning = \"{}\" (the knobs are those of \"hertz\" with \"luding\", "
          "and nothing "
          "was measured with others): choose stiffness, mass and step of this law yourself",
          what, contact.law, contact.turning);
}

std::vector<Setting> settings_for(const Scene& scene) {
  require_studied_laws(scene, "clog trade");
  std::vector<Setting> all{
      {"gpa3", "the paper's particles", "", Kind::numerics, full_numerics(gigapascals, 1)},
      {"mpa30", "Young's modulus / 100", "gpa3", Kind::numerics, full_numerics(stiffer, 1)},
      {"cheap_30MPa", "mass, moment of inertia and step", "mpa30", Kind::numerics, cheap_with({stiffer})},
      {"tau50", "Young's modulus / 1000", "mpa30", Kind::numerics, full_numerics(soft, 1)},
      {"mass10", "mass", "tau50", Kind::numerics, full_numerics(soft, 10)},
      {"cheap", "step and moment of inertia", "mass10", Kind::numerics, cheap_with({})}};
  add_numerics(all, scene);
  add_physics(all);
  return all;
}

}  // namespace clogflow::trade
