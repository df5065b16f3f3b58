// Checks that concern more than one key: each says the value, and what it must agree with.
#include <algorithm>
#include <cmath>

#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/stl_channel.hpp"
#include "coupling/scene/particle_sizes.hpp"
#include "coupling/scene/scene_draft.hpp"
#include "coupling/scene/scene_keys.hpp"
#include "coupling/scene/sweep.hpp"
#include "coupling/scene/unclog_protocol.hpp"

namespace clogflow {
namespace {

std::string metres(double value) { return format_quantity(value, dimension::length); }

/// A default is computed from other values, and extreme ones make it infinite.
void check_defaults(const SceneDraft& draft) {
  Scene scene = draft.scene;
  for (const Key& key : scene_keys())
    if (const auto* number = std::get_if<NumberSlot>(&key.slot))
      require(std::isfinite(number->at(scene)), "{} (must be a finite number: give it, or less extreme values)",
              draft.says(key.path));
}

void check_walls(const SceneDraft& draft) {
  const auto& geometry = draft.scene.geometry;
  const auto& box = draft.scene.box;
  require(!(geometry.present && box.present),
          "{}: [geometry] and [box] are both present (each gives walls: choose one)", draft.name);
  if (geometry.present && geometry.neck_width > 0)
    require(geometry.channel_width >= geometry.neck_width, "{} (must not be wider than geometry.channel_width = {})",
            draft.says("geometry.neck_width"), metres(geometry.channel_width));
  for (const char* key : {"geometry.stl_unit", "geometry.stl_tolerance"})
    require(!draft.has(key) || !geometry.stl.empty(), "{} (needs geometry.stl too)", draft.says(key));
  for (const char* key : {"geometry.inlet_diameter", "geometry.inlet_area", "geometry.neck_area"})
    require(!draft.has(key) || is_stl_channel(geometry), "{} (is of a channel from geometry.stl: leave it out)",
            draft.says(key));
  if (geometry.present && geometry.neck_width > 0 && geometry.stl.empty()) {
    for (const char* key : {"geometry.expansion_length", "geometry.expansion_angle"})
      require(!draft.has(key) || geometry.expansion_width > 0, "{} (needs geometry.expansion_width too)",
              draft.says(key));
    const std::string fault = shape_fault(draft.scene.geometry);
    require(fault.empty(), "{}: {}", draft.name, fault);
  }
  for (int axis = 0; box.present && axis < 3; ++axis)
    require(box.max[axis] > box.min[axis], "{} (must be larger than box.min in each component)", draft.says("box.max"));
}

/// The key that decides the largest particle.
const char* size_key(const Scene& scene) {
  const auto& particles = scene.particles;
  return !particles.size_file.empty() ? "particles.size_file"
         : particles.size_spread > 0  ? "particles.size_spread"
         : particles.species.empty()  ? "particles.diameter"
                                      : "particles.species";
}

/// Of what must be where sizes differ.
void check_sizes(const SceneDraft& draft) {
  const auto& particles = draft.scene.particles;
  const bool from_file = particles.size_distribution == SizeDistribution::file;
  require(from_file == !particles.size_file.empty(), "{} ({})",
          draft.says(from_file ? "particles.size_distribution" : "particles.size_file"),
          from_file ? "needs particles.size_file too" : "is for particles.size_distribution = \"file\"");
  require(!from_file || particles.size_spread == 0, "{} (the file says how sizes spread: leave it out)",
          draft.says("particles.size_spread"));
  if (!particles.species.empty()) {
    const double mean = mean_diameter(particles.species);
    require(std::abs(particles.diameter - mean) <= 1e-9 * mean,
            "{} (the mean over the number of particles.species is {}): leave it out", draft.says("particles.diameter"),
            short_length(mean));
  }
  const std::string fault = spread_fault(particles);
  require(fault.empty(), "{} ({})", draft.says(size_key(draft.scene)), fault);
}

void check_particles(const SceneDraft& draft) {
  const Scene& scene = draft.scene;
  check_sizes(draft);
  const ParticleSizes sizes(scene.particles);
  const double diameter = sizes.smallest();
  const auto fits = [&](double opening, std::string_view name) {
    require(opening == 0 || sizes.largest() < opening,
            "{} ({}must be smaller than {} = {}, or no particle fits through)", draft.says(size_key(scene)),
            sizes.equal() ? std::string() : fmt::format("the largest has {} and ", short_length(sizes.largest())), name,
            metres(opening));
  };
  if (scene.geometry.present) {
    fits(scene.geometry.neck_width, "geometry.neck_width");
    fits(scene.geometry.neck_height, "geometry.neck_height");
    fits(scene.geometry.channel_length, "geometry.channel_length");
  }
  for (int axis = 0; scene.box.present && axis < 3; ++axis)
    fits(scene.box.max[axis] - scene.box.min[axis], fmt::format("the box along {}", "xyz"[axis]));
  require(scene.particles.roughness < diameter / 4, "{} (must be smaller than a quarter of {} = {})",
          draft.says("particles.roughness"), sizes.equal() ? "particles.diameter" : "the smallest diameter",
          sizes.equal() ? metres(diameter) : short_length(diameter));
  // Where sizes differ, films reach in proportion to them.
  const double smallest_share = diameter / scene.particles.diameter;
  if (scene.lubrication.enabled && !sizes.equal())
    require(smallest_share * scene.lubrication.cutoff > 2 * scene.particles.roughness,
            "{} (between the smallest particles {}, which must be larger than 2 particles.roughness = {})",
            draft.says("lubrication.cutoff"), short_length(smallest_share * scene.lubrication.cutoff),
            metres(2 * scene.particles.roughness));
  if (scene.lubrication.enabled)
    require(scene.lubrication.cutoff > 2 * scene.particles.roughness,
            "{} (must be larger than 2 particles.roughness = {})", draft.says("lubrication.cutoff"),
            metres(2 * scene.particles.roughness));
}

void check_flow(const SceneDraft& draft) {
  const auto& flow = draft.scene.flow;
  const auto& geometry = draft.scene.geometry;
  if (draft.has("flow.velocity"))
    require(flow.source == FlowSource::uniform || draft.scene.flow.velocity == std::array<double, 3>{},
            "{} (is only for flow.source = \"uniform\")", draft.says("flow.velocity"));
  if (flow.source == FlowSource::openfoam)
    require(flow.grid_spacing <= geometry.neck_width / 4, "{} (must be at most a quarter of geometry.neck_width = {})",
            draft.says("flow.grid_spacing"), metres(geometry.neck_width));
  require(!flow.extrapolate || flow.source == FlowSource::openfoam, "{} (is only for flow.source = \"openfoam\")",
          draft.says("flow.extrapolate"));
  require(!flow.rescale || flow.source == FlowSource::openfoam, "{} (is only for flow.source = \"openfoam\")",
          draft.says("flow.rescale"));
  if (flow.pulsation.strength > 0) {
    require(flow.pulsation.time > 0, "{} (needs flow.pulsation.time, e.g. \"6.6 ms\")",
            draft.says("flow.pulsation.strength"));
    require(flow.source != FlowSource::none, "{} (there is no flow to pulsate)", draft.says("flow.pulsation.strength"));
  }
}

void check_oscillation(const SceneDraft& draft) {
  const auto& oscillation = draft.scene.flow.oscillation;
  const auto path = [](const char* name) { return fmt::format("flow.oscillation.{}", name); };
  const auto goes_with_amplitude = [&](const char* name, bool given) {
    require(!given || oscillation.amplitude > 0, "{} (needs flow.oscillation.amplitude, e.g. 0.5)",
            draft.says(path(name)));
  };
  goes_with_amplitude("frequency", oscillation.frequency > 0);
  goes_with_amplitude("phase", oscillation.phase > 0);
  goes_with_amplitude("shape", oscillation.shape != OscillationShape::sine);
  require(oscillation.table.empty() || oscillation.amplitude == 0,
          "{} (stands in the place of flow.oscillation.amplitude: leave one out)",
          draft.says("flow.oscillation.table"));
  if (!oscillation.on()) return;
  const std::string key = path(oscillation.amplitude > 0 ? "amplitude" : "table");
  require(oscillation.amplitude == 0 || oscillation.frequency > 0,
          "{} (needs flow.oscillation.frequency, e.g. \"10 Hz\")", draft.says(key));
  require(draft.scene.flow.source != FlowSource::none, "{} (there is no flow to oscillate)", draft.says(key));
}

/// The pressure that the particles resist is of the drag of a mixture, linear in the flow.
void check_drive(const SceneDraft& draft) {
  const Scene& s = draft.scene;
  const bool pressure = s.flow.drive == DrivenBy::pressure;
  require(!pressure || draft.has("flow.pressure_drop"),
          "{}: flow.pressure_drop is missing (a pressure, e.g. \"100 Pa\"; flow.drive is \"pressure\")", draft.name);
  require(pressure || !draft.has("flow.pressure_drop"), "{} (is only for flow.drive = \"pressure\")",
          draft.says("flow.pressure_drop"));
  require(
      !pressure || !draft.has("flow.compliance"),
      "{} (lies behind a pump of constant rate: a pressure that is held loads it once and for all): set flow.drive = "
      "\"rate\" or leave it out",
      draft.says("flow.compliance"));
  if (!s.flow.balances()) return;
  const char* key = pressure ? "flow.drive" : "flow.compliance";
  require(s.flow.source == FlowSource::openfoam, "{} (needs flow.source = \"openfoam\", whose channel resists)",
          draft.says(key));
  require(s.drag.enabled && s.drag.velocity == DragVelocity::mixture,
          "{} (a pressure balance keeps the mixture's rate: set drag.velocity = \"mixture\")", draft.says(key));
  require(s.drag.law != "beetstra", "{} (is solved with a drag that is linear in the slip: set drag.law = \"hoef\")",
          draft.says(key));
  require(s.drag.fluctuation.strength == 0,
          "{} (is solved with a drag that is linear in the slip): leave out "
          "drag.fluctuation",
          draft.says(key));
  require(s.time.integrator != Integrator::implicit_fluid,
          "{} (is not solved together with implicit films: set time.integrator = \"implicit_drag\")", draft.says(key));
}

/// A constant that only some laws have is given with one of them, and with no other.
void check_constant_of_laws(const SceneDraft& draft, std::initializer_list<std::string_view> laws, const char* key,
                            const char* example) {
  const std::string& law = draft.scene.contact.law;
  const bool chosen = std::ranges::find(laws, law) != laws.end();
  require(!chosen || draft.has(key), "{}: {} is missing (contact.law = \"{}\" needs it): give it, e.g. \"{}\"",
          draft.name, key, law, example);
  require(chosen || !draft.has(key), "{} (is only for contact.law = \"{}\")", draft.says(key),
          fmt::join(laws, "\" or \""));
}

void check_contact(const SceneDraft& draft) {
  check_constant_of_laws(draft, {"hooke"}, "contact.stiffness", "10 N/m");
  check_constant_of_laws(draft, {"jkr", "dmt"}, "contact.surface_energy", "1 mJ/m2");
  const auto& contact = draft.scene.contact;
  const bool plain = contact.torsion_update == TorsionUpdate::objective && contact.turning == "luding";
  require(contact.torsion_update == TorsionUpdate::objective || contact.turning == "luding",
          "{} (is an experiment with contact.turning = \"luding\")", draft.says("contact.torsion_update"));
  require(contact.law == "hertz" || plain,
          "{} (has neither contact.turning = \"mercury\" nor contact.torsion_update = \"doubling\")",
          draft.says("contact.law"));
}

void check_terms(const SceneDraft& draft) {
  const Scene& scene = draft.scene;
  const bool shape = scene.geometry.present && scene.geometry.neck_width > 0;
  if (scene.drag.fluctuation.strength > 0) {
    require(scene.drag.fluctuation.time > 0, "{} (needs drag.fluctuation.time, e.g. \"6.6 ms\")",
            draft.says("drag.fluctuation.strength"));
    require(scene.drag.enabled, "{} (needs drag)", draft.says("drag.fluctuation.strength"));
  }
  require(scene.porosity.strips == 0 || shape, "{} (strips need a [geometry] with neck_width)",
          draft.says("porosity.strips"));
  require(!scene.inlet.enabled || shape, "{}: [inlet] is on (an inlet needs a [geometry] with neck_width)", draft.name);
  const bool driven = scene.flow.source != FlowSource::none || scene.body_force != std::array<double, 3>{} ||
                      scene.gravity != std::array<double, 3>{};
  require(!scene.inlet.enabled || driven,
          "{}: [inlet] is on (nothing carries particles away from it: give flow.source, body_force or gravity)",
          draft.name);
  require(scene.unclog.protocol == UnclogProtocol::none || shape, "{} (needs a [geometry] with neck_width)",
          draft.says("unclog.protocol"));
  // What counts as rest is a share of the flow's speed, or of that of a fall.
  constexpr const char* silo = "or gravity along +x in its place";
  require(scene.unclog.protocol == UnclogProtocol::none || scene.speed_scale() > 0,
          "{} (needs a flow, {}, which tells when a clog is at rest)", draft.says("unclog.protocol"), silo);
  require(!draft.has("output.burst_snapshots") || scene.speed_scale() > 0,
          "{} (needs a flow, {}: a burst is over when nothing has passed for d / v)",
          draft.says("output.burst_snapshots"), silo);
  require(!scene.inlet.enabled || scene.inlet.start == InletStart::empty || scene.speed_scale() > 0,
          "{} (a flow must fill the channel, {}: set flow.source or gravity, or inlet.start = \"empty\")",
          draft.says("inlet.start"), silo);
  require(scene.porosity.method == PorosityMethod::strips || shape, "{} (needs a [geometry] with neck_width)",
          draft.says("porosity.method"));
}

/// A key that only one word of another gives a meaning.
void check_goes_with(const SceneDraft& draft, const char* key, bool chosen, std::string_view other) {
  require(chosen || !draft.has(key), "{} (is only for {})", draft.says(key), other);
}

void check_starts_and_clogs(const SceneDraft& draft) {
  const Scene& s = draft.scene;
  const auto protocol = s.unclog.protocol;
  const bool releases = protocol == UnclogProtocol::release, flows = restarts(protocol);
  if (s.inlet.concentration > 0) {
    require(s.inlet.start == InletStart::empty, "{} (is for inlet.start = \"empty\": other starts are dense)",
            draft.says("inlet.concentration"));
    require(s.inlet.rate == 0, "{} (says how many come in, as inlet.rate does): leave one out",
            draft.says("inlet.concentration"));
    require(s.geometry.present && s.geometry.stl.empty() && s.flow.mean_velocity > 0,
            "{} (needs a channel, and flow.mean_velocity in it)", draft.says("inlet.concentration"));
  }
  check_goes_with(draft, "inlet.strain", s.inlet.start == InletStart::flowing, "inlet.start = \"flowing\"");
  check_goes_with(draft, "unclog.strain", flows, "unclog.protocol = \"restart\" or \"rewind\"");
  require(protocol != UnclogProtocol::rewind || s.inlet.start == InletStart::flowing,
          "{} (needs inlet.start = \"flowing\": friction must have begun in a flow)", draft.says("unclog.protocol"));
  check_goes_with(draft, "unclog.region", releases || flows || s.unclog.region == 0,
                  "unclog.protocol = \"release\", \"restart\" or \"rewind\"");
  const bool local = s.porosity.method == PorosityMethod::local;
  check_goes_with(draft, "porosity.width", local, "porosity.method = \"local\"");
  // A sphere alone would fill more than its own place: pi/6 d^3 / (2 pi s^2)^(3/2) = 0.27 at s = d/2, 0.99 at 0.32 d.
  const ParticleSizes sizes(s.particles);
  require(!local || s.porosity.width >= sizes.largest() / 2,
          "{} (must be at least half of {} = {}, or a sphere sees little but itself)", draft.says("porosity.width"),
          sizes.equal() ? "particles.diameter" : "the largest diameter",
          sizes.equal() ? metres(sizes.largest()) : short_length(sizes.largest()));
  require(!s.porosity.neck || (!local && s.porosity.strips > 0),
          "{} (is one more strip: needs porosity.method = \"strips\" and porosity.strips > 0)",
          draft.says("porosity.neck"));
  const bool moved = s.drag.fluctuation.strength > 0 || s.flow.pulsation.strength > 0;
  require(protocol != UnclogProtocol::stop || !moved,
          "{} (no clog is permanent under drag.fluctuation or flow.pulsation: choose \"none\")",
          draft.says("unclog.protocol"));
}

/// Nothing is ever counted at a plane that no particle reaches, or before which none begins.
void check_plane(const SceneDraft& draft) {
  const Scene& s = draft.scene;
  const auto lies_between = [&](double start, double end, const char* where) {
    require(s.passages.plane > start && s.passages.plane < end, "{} (must be in the {}, from {} to {})",
            draft.says("passages.plane"), where, metres(start), metres(end));
  };
  // A laboratory counts nothing unless a plane is given.
  if (s.box.present && s.passages.plane != 0) lies_between(s.box.min[0], s.box.max[0], "box");
  const bool by_keys = s.geometry.stl.empty() && s.geometry.neck_width > 0;
  if (s.geometry.present && (by_keys || is_stl_channel(s.geometry)))
    lies_between(channel_start(s.geometry), channel_end(s.geometry), "channel");
}

void check_times(const SceneDraft& draft) {
  const auto& time = draft.scene.time;
  require(time.step <= time.end, "{} (must not exceed time.end = {} s)", draft.says("time.step"), time.end);
}

}  // namespace

void check_scene(const SceneDraft& draft) {
  try {
    sweep_points(draft.scene.ensemble.sweep);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", draft.says("ensemble.sweep"), error.what()));
  }
  check_defaults(draft);
  check_walls(draft);
  check_particles(draft);
  check_flow(draft);
  check_oscillation(draft);
  check_drive(draft);
  check_contact(draft);
  check_terms(draft);
  check_starts_and_clogs(draft);
  check_plane(draft);
  check_times(draft);
}

}  // namespace clogflow
