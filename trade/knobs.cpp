#include "trade/knobs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "coupling/base/require.hpp"

namespace clogflow::trade {

namespace {

constexpr const char* base_name = "10MPa_m30_limit70";

/// Keys of `base` with some of them turned, each key once.
Overrides base_with(const Overrides& more) {
  const auto key_of = [](const std::string& override) { return override.substr(0, override.find('=')); };
  Overrides overrides{"contact.youngs_modulus=10 MPa", "time.mass_scale=30", "time.rotational_inertia_scale=5",
                      "time.step_fraction=1", "time.contact_limit_share=0.7"};
  for (const std::string& override : more) {
    std::erase_if(overrides, [&](const std::string& known) { return key_of(known) == key_of(override); });
    overrides.push_back(override);
  }
  return overrides;
}

/// Softness, mass and step: what the response is fitted to and a preset may choose.
void add_doses(std::vector<Setting>& all) {
  const auto add = [&](const char* name, const char* knob, const Overrides& more, const char* against = base_name) {
    all.push_back({name, knob, against, Kind::dose, base_with(more)});
  };
  constexpr const char *share35 = "time.contact_limit_share=0.35", *share50 = "time.contact_limit_share=0.5",
                       *share80 = "time.contact_limit_share=0.8", *tau50 = "time.step_fraction=0.02";
  add("gpa3", "the paper's particles",
      {"contact.youngs_modulus=3 GPa", "time.mass_scale=1", "time.rotational_inertia_scale=1", tau50}, "");
  add("3GPa_m30_limit70", "Young's modulus x 300", {"contact.youngs_modulus=3 GPa"});
  // Half the step, whose share of the Hertz time is that of softer particles.
  add("3GPa_m30_limit35", "Young's modulus x 300 and step", {"contact.youngs_modulus=3 GPa", share35});
  add("100MPa_m30_limit50", "Young's modulus x 10 and step", {"contact.youngs_modulus=100 MPa", share50});
  add("100MPa_m3_limit50", "Young's modulus x 10, mass / 10 and step",
      {"contact.youngs_modulus=100 MPa", "time.mass_scale=3", share50});
  add("30MPa_m30_limit50", "Young's modulus x 3 and step", {"contact.youngs_modulus=30 MPa", share50});
  add("30MPa_m30_limit70", "Young's modulus x 3", {"contact.youngs_modulus=30 MPa"});
  add("30MPa_m3_limit50", "Young's modulus x 3, mass / 10 and step",
      {"contact.youngs_modulus=30 MPa", "time.mass_scale=3", share50});
  add("30MPa_m10_limit70", "Young's modulus x 3 and mass / 3", {"contact.youngs_modulus=30 MPa", "time.mass_scale=10"});
  add("10MPa_m1_limit70", "mass", {"time.mass_scale=1"});
  add("10MPa_m3_limit70", "mass", {"time.mass_scale=3"});
  add("10MPa_m10_limit70", "mass", {"time.mass_scale=10"});
  add("base_tau50", "step", {tau50});
  add(base_name, "Young's modulus, mass, moment of inertia and step", {}, "gpa3");
  add("10MPa_m30_limit50", "step", {share50});
  add("base_limit80", "step", {share80});
  add("10MPa_m100_limit70", "mass", {"time.mass_scale=100"});
  add("10MPa_m300_limit70", "mass", {"time.mass_scale=300"});
  add("5MPa_m30_limit80", "Young's modulus / 2 and step", {"contact.youngs_modulus=5 MPa", share80});
  add("3MPa_m30_limit80", "Young's modulus / 3 and step", {"contact.youngs_modulus=3 MPa", share80});
  add("3MPa_m100_limit80", "Young's modulus / 3, mass and step",
      {"contact.youngs_modulus=3 MPa", "time.mass_scale=100", share80});
  add("1MPa_m30_limit70", "Young's modulus / 10", {"contact.youngs_modulus=1 MPa"});
}

/// What turns one thing on the base.
struct Turn {
  const char *name, *knob;
  std::string override;
};

std::vector<Turn> other_methods(const Scene& scene) {
  return {{"base_i1", "moment of inertia", "time.rotational_inertia_scale=1"},
          {"base_i10", "moment of inertia", "time.rotational_inertia_scale=10"},
          {"base_implicit_drag", "integrator", "time.integrator=implicit_drag"},
          {"base_implicit_fluid", "integrator", "time.integrator=implicit_fluid"},
          {"base_trilinear", "lookup", "flow.lookup=trilinear"},
          {"base_strips1", "strips", "porosity.strips=1"},
          {"base_strips6", "strips", "porosity.strips=6"},
          {"base_rare_porosity", "update of the strips", "porosity.update_interval=5 ms"},
          {"base_rarer_porosity", "update of the strips", "porosity.update_interval=50 ms"},
          {"base_lubrication_short", "lubrication cut-off",
           fmt::format("lubrication.cutoff={} m", scene.particles.diameter / 4)}};
}

std::vector<Turn> other_physics(const Scene& scene) {
  const auto roughness = [&](double diameters) {
    return fmt::format("particles.roughness={} m", diameters * scene.particles.diameter);
  };
  return {{"base_lubrication_off", "lubrication off", "lubrication.enabled=false"},
          {"base_lubrication_clamp", "lubrication held below 2 xi", "lubrication.below_roughness=clamp"},
          {"base_smooth", "roughness / 10", roughness(0.0005)},
          {"base_rough", "roughness x 4", roughness(0.02)},
          {"base_restitution03", "restitution", "contact.restitution=0.3"},
          {"base_superficial", "drag of the superficial velocity", "drag.velocity=superficial"},
          {"base_rolling0", "no rolling friction", "contact.friction.rolling=0"},
          {"base_torsion0", "no torsion friction", "contact.friction.torsion=0"},
          {"base_rolling12", "rolling friction doubled", "contact.friction.rolling=1.2"},
          {"base_torsion12", "torsion friction doubled", "contact.friction.torsion=1.2"},
          {"base_doubling", "doubling torsion spring", "contact.torsion_update=doubling"}};
}

void add_turns(std::vector<Setting>& all, Kind kind, const std::vector<Turn>& turns) {
  for (const Turn& turn : turns) all.push_back({turn.name, turn.knob, base_name, kind, base_with({turn.override})});
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
  std::vector<Setting> all;
  add_doses(all);
  add_turns(all, Kind::numerics, other_methods(scene));
  add_turns(all, Kind::physics, other_physics(scene));
  return all;
}

}  // namespace clogflow::trade
