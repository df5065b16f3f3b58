// Defaults that depend on other keys, in the order in which they depend on each other.
#include <algorithm>
#include <cmath>
#include <utility>

#include "coupling/base/require.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/scene/grid_spacing.hpp"
#include "coupling/scene/particle_sizes.hpp"
#include "coupling/scene/scene_draft.hpp"
#include "coupling/scene/scene_keys.hpp"
#include "coupling/scene/unclog_protocol.hpp"

namespace clogflow {
namespace {

void need(const SceneDraft& draft, std::string_view key, std::string_view reason = "") {
  if (draft.has(key)) return;
  const Key* known = find_key(key);
  std::string example;
  if (const auto* number = std::get_if<NumberSlot>(&known->slot)) {
    const QuantityWords words = quantity_words(number->dimension);
    example = fmt::format("{}, e.g. {}", words.name,
                          number->dimension == dimension::number ? "0.3" : "\"" + words.example + "\"");
  } else if (std::holds_alternative<AngleSlot>(known->slot)) {
    example = "an angle, e.g. \"60 deg\"";
  } else {
    example = std::string(known->doc);
  }
  throw Error(fmt::format("{}: {} is missing ({}{}{})", draft.name, key, example, reason.empty() ? "" : "; ", reason));
}

void fill_geometry(SceneDraft& draft) {
  auto& geometry = draft.scene.geometry;
  geometry.present = draft.has_section("geometry");
  draft.scene.box.present = draft.has_section("box");
  if (draft.scene.box.present) {
    need(draft, "box.min");
    need(draft, "box.max");
  }
  if (!geometry.present) return;
  if (geometry.stl.empty()) need(draft, "geometry.neck_width");
  const double width = geometry.neck_width;
  if (width == 0) return;
  if (!draft.has("geometry.neck_height")) geometry.neck_height = width;
  if (!draft.has("geometry.channel_width")) geometry.channel_width = 4 * width;
  if (!draft.has("geometry.channel_length")) geometry.channel_length = 10 * width;
  if (!draft.has("geometry.neck_length")) geometry.neck_length = width;
  if (geometry.channel_width > width && geometry.stl.empty()) need(draft, "geometry.half_angle");
  if (geometry.expansion_width > 0) {
    if (!draft.has("geometry.expansion_length")) geometry.expansion_length = geometry.expansion_width;
    if (!draft.has("geometry.expansion_angle")) {
      need(draft, "geometry.half_angle", "or give geometry.expansion_angle");
      geometry.expansion_angle = geometry.half_angle;
    }
  }
}

/// A flow rate becomes the mean velocity. An override beats the file.
void use_rate(SceneDraft& draft) {
  auto& flow = draft.scene.flow;
  const auto& geometry = draft.scene.geometry;
  if (!draft.has("flow.rate")) return;
  const auto overridden = [&](const char* key) { return draft.given.at(key).where.starts_with("--set "); };
  if (draft.has("flow.mean_velocity")) {
    require(overridden("flow.rate") != overridden("flow.mean_velocity"),
            "{} (flow.mean_velocity is given too: choose one)", draft.says("flow.rate"));
  }
  const double rate = std::exchange(flow.rate, 0);
  if (draft.has("flow.mean_velocity") && overridden("flow.mean_velocity")) return;
  require(geometry.present && geometry.channel_width > 0,
          "{} (needs a [geometry] with neck_width, whose channel has a cross-section): give flow.mean_velocity",
          draft.says("flow.rate"));
  flow.mean_velocity = rate / channel_flow_rate(geometry, 1);
  draft.given["flow.mean_velocity"] = draft.given.at("flow.rate");
}

void fill_flow(SceneDraft& draft) {
  auto& flow = draft.scene.flow;
  const auto& geometry = draft.scene.geometry;
  use_rate(draft);
  if (!draft.has("flow.source"))
    flow.source = draft.has_section("flow") && geometry.present ? FlowSource::openfoam : FlowSource::none;
  if (flow.source == FlowSource::openfoam) {
    require(geometry.present, "{} (openfoam needs a [geometry] section)", draft.says("flow.source"));
    const std::string_view reason = "flow.source is openfoam";
    need(draft, "geometry.neck_width", reason);
    need(draft, "flow.mean_velocity", reason);
    need(draft, "fluid.viscosity", reason);
    need(draft, "fluid.density", reason);
    if (!draft.has("flow.mesh_cells_per_neck")) flow.mesh_cells_per_neck = 48;
    // On very coarse meshes the error is no power of the cells' size.
    if (!draft.has("flow.extrapolate")) flow.extrapolate = flow.mesh_cells_per_neck >= 16;
    // A whole number of layers, near 50 for each neck width.
    if (!draft.has("flow.grid_spacing")) {
      const double side = std::min(geometry.neck_width, geometry.neck_height);
      const double wanted = flow.grid_tolerance > 0 ? spacing_for_error(flow.lookup, flow.grid_tolerance, side) : 0;
      const double layers = wanted > 0 ? std::ceil(geometry.neck_height / wanted)
                                       : std::round(50 * geometry.neck_height / geometry.neck_width);
      flow.grid_spacing = geometry.neck_height / std::max(1.0, layers);
    }
  }
  if (flow.source == FlowSource::uniform && !draft.has("flow.velocity")) {
    require(draft.has("flow.mean_velocity"),
            "{}: flow.velocity is missing (a velocity, e.g. \"5 mm/s\"; flow.source is uniform)", draft.name);
    flow.velocity = {flow.mean_velocity, 0, 0};
  }
}

void fill_particles(SceneDraft& draft) {
  Scene& scene = draft.scene;
  // An override of the mixture beats a diameter of the file.
  const auto overridden = [&](const char* key) {
    return draft.has(key) && draft.given.at(key).where.starts_with("--set ");
  };
  const bool mixed = !scene.particles.species.empty();
  const bool replaced = overridden("particles.species") || overridden("particles.size_file");
  if (mixed && (!draft.has("particles.diameter") || (replaced && !overridden("particles.diameter"))))
    scene.particles.diameter = mean_diameter(scene.particles.species);
  else
    need(draft, "particles.diameter");
  if (!draft.has("particles.density")) {
    require(draft.has("fluid.density"),
            "{}: particles.density is missing (a density, e.g. \"1062 kg/m3\"; there is no "
            "fluid.density to take it from)",
            draft.name);
    scene.particles.density = scene.fluid.density;
  }
  if (!draft.has("particles.roughness")) scene.particles.roughness = 0.005 * scene.particles.diameter;
}

/// A species that names a friction gets all of it: the rest of its surface's from contact.friction; with the walls
/// what the scene says of all particles, and where it says nothing the species' own, as without species.
void fill_friction_of_species(SceneDraft& draft) {
  const auto& contact = draft.scene.contact;
  const std::pair<double Friction::*, std::string_view> parts[] = {
      {&Friction::sliding, "contact.wall_friction.sliding"},
      {&Friction::rolling, "contact.wall_friction.rolling"},
      {&Friction::torsion, "contact.wall_friction.torsion"}};
  for (Species& kind : draft.scene.particles.species) {
    if (!kind.has_friction()) continue;
    for (const auto& [part, wall_key] : parts) {
      if (kind.friction.*part < 0) kind.friction.*part = contact.friction.*part;
      if (kind.wall_friction.*part < 0)
        kind.wall_friction.*part = draft.has(wall_key) ? contact.wall_friction.*part : kind.friction.*part;
    }
  }
}

void fill_contact(SceneDraft& draft) {
  auto& contact = draft.scene.contact;
  need(draft, "contact.youngs_modulus");
  need(draft, "contact.poisson_ratio");
  if (!draft.has("contact.wall_friction.sliding")) contact.wall_friction.sliding = contact.friction.sliding;
  if (!draft.has("contact.wall_friction.rolling")) contact.wall_friction.rolling = contact.friction.rolling;
  if (!draft.has("contact.wall_friction.torsion")) contact.wall_friction.torsion = contact.friction.torsion;
  fill_friction_of_species(draft);
  // Schaefer, Dippel & Wolf, J. Phys. I 6 (1996) 5: sliding and normal springs swing in step.
  if (contact.law == "hooke" && !draft.has("contact.tangential_factor")) contact.tangential_factor = 2.0 / 7.0;
  if (!draft.has("contact.wall_youngs_modulus")) contact.wall_youngs_modulus = contact.youngs_modulus;
  if (!draft.has("contact.wall_poisson_ratio")) contact.wall_poisson_ratio = contact.poisson_ratio;
}

void fill_terms(SceneDraft& draft) {
  Scene& scene = draft.scene;
  if (!draft.has("lubrication.enabled")) scene.lubrication.enabled = draft.has_section("lubrication");
  if (!draft.has("lubrication.cutoff")) scene.lubrication.cutoff = scene.particles.diameter / 2;
  if (!draft.has("drag.enabled")) scene.drag.enabled = draft.has_section("drag");
  if (!draft.has("inlet.enabled")) scene.inlet.enabled = draft.has_section("inlet");
  if (!draft.has("porosity.width") && scene.porosity.method == PorosityMethod::local)
    scene.porosity.width = 1.5 * scene.particles.diameter;
  if (!draft.has("porosity.strips")) scene.porosity.strips = draft.has_section("porosity") ? 3 : 0;
  if (scene.lubrication.enabled) need(draft, "fluid.viscosity", "lubrication is on");
  if (scene.drag.enabled) need(draft, "fluid.viscosity", "drag is on");
}

/// 1.5 ms in the paper's scene.
constexpr double release_share = 0.23;

/// Of solids that pass the neck before what is near it has forgotten how it stood.
constexpr double usual_strain = 10;

/// Where no clog has to be forgotten, so that one burst is only not to look like the one before.
constexpr double strain_of_branches = 1;

// Exactly one of step and step_fraction is in force, the other 0. An override beats the file.
void choose_step(SceneDraft& draft) {
  auto& time = draft.scene.time;
  if (!draft.has("time.step")) return;
  const auto overridden = [&](const char* key) { return draft.given.at(key).where.starts_with("--set "); };
  if (draft.has("time.step_fraction")) {
    const bool step_overridden = overridden("time.step");
    require(step_overridden != overridden("time.step_fraction"), "{} (time.step is given too: choose one)",
            draft.says("time.step_fraction"));
    if (!step_overridden) {
      time.step = 0;
      return;
    }
  }
  time.step_fraction = 0;
}

void fill_times(SceneDraft& draft) {
  Scene& scene = draft.scene;
  need(draft, "time.end");
  choose_step(draft);
  const double tau = scene.stokes_time();
  if (!draft.has("porosity.update_interval")) scene.porosity.update_interval = tau / 1000;
  if (!draft.has("output.series_interval")) scene.output.series_interval = tau > 0 ? tau / 10 : scene.time.end / 1000;
  if (!draft.has("output.checkpoint_interval")) scene.output.checkpoint_interval = 60;
  if (!draft.has("unclog.after")) {
    require(
        tau > 0 || scene.unclog.protocol == UnclogProtocol::none,
        "{}: unclog.after is missing (a time, e.g. \"10 ms\"; there is no flow, nor gravity along +x, to take it from)",
        draft.name);
    scene.unclog.after = 5 * tau;
  }
  if (!draft.has("unclog.duration")) scene.unclog.duration = tau > 0 ? release_share * tau : 1.5e-3;
  if (!draft.has("inlet.strain") && scene.inlet.enabled && scene.inlet.start == InletStart::flowing)
    scene.inlet.strain = usual_strain;
  if (!draft.has("unclog.strain") && restarts(scene.unclog.protocol))
    scene.unclog.strain = scene.unclog.protocol == UnclogProtocol::rewind ? strain_of_branches : usual_strain;
  if (!draft.has("passages.plane")) scene.passages.plane = scene.geometry.neck_length / 2;
}

}  // namespace

double Scene::flow_speed() const {
  if (flow.source == FlowSource::openfoam) return flow.mean_velocity;
  if (flow.source == FlowSource::uniform) return std::hypot(flow.velocity[0], flow.velocity[1], flow.velocity[2]);
  return 0;
}

double Scene::fall_acceleration() const {
  if (flow.source != FlowSource::none || !geometry.present || geometry.neck_width <= 0) return 0;
  return std::max(0.0, gravity[0] * (1 - fluid.density / particles.density) / time.mass_scale);
}

double Scene::speed_scale() const {
  return falls() ? std::sqrt(fall_acceleration() * geometry.neck_width) : flow_speed();
}

double Scene::stokes_time() const {
  const double speed = speed_scale();
  return speed > 0 ? particles.diameter / speed : 0;
}

void fill_defaults(SceneDraft& draft) {
  fill_geometry(draft);
  fill_flow(draft);
  fill_particles(draft);
  fill_contact(draft);
  fill_terms(draft);
  fill_times(draft);
  if (!draft.has("ensemble.seeds")) draft.scene.ensemble.seeds = {1};
}

}  // namespace clogflow
