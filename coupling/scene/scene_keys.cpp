// The key table. Names, dimensions, limits and one line of explanation; defaults that depend on
// other keys are computed in scene_defaults.cpp.
#include "coupling/scene/scene_keys.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "coupling/base/nearest_word.hpp"

namespace clogflow {
namespace {

constexpr Range any{};
constexpr Range positive{.low = 0, .low_allowed = false};
constexpr Range non_negative{.low = 0};
// Random insertion finds no room for more.
constexpr Range dilute{.low = 0, .high = 0.3};
// Beyond, the sizes of every distribution differ more than tenfold.
constexpr Range spread{.low = 0, .high = 0.5};
constexpr Range fraction{.low = 0, .high = 1, .low_allowed = false};
// Its dashpot grows like e^(-1/2) and limits the step; 0.001 is as good as none.
constexpr Range restitution{.low = 1e-3, .high = 1};

int place_of(std::string_view word, std::initializer_list<const char*> words) {
  return static_cast<int>(std::ranges::find(words, word) - words.begin());
}

// A member of Scene is named as its key, so one spelling serves as both.
#define AT(member) \
  [](Scene & scene) -> auto& { return scene.member; }
#define NUMBER(member, dimension, range, doc) \
  Key { #member, NumberSlot{AT(member), dimension, range }, doc }
#define ANGLE(member, doc) \
  Key { #member, AngleSlot{AT(member) }, doc }
#define VECTOR(member, dimension, doc) \
  Key { #member, VectorSlot{AT(member), dimension }, doc }
#define COUNT(member, range, doc) \
  Key { #member, CountSlot{AT(member), range }, doc }
#define SWITCH(member, doc) \
  Key { #member, SwitchSlot{AT(member) }, doc }
#define TEXT(member, doc) \
  Key { #member, TextSlot{AT(member) }, doc }
#define WORD(member, doc, ...)                                                            \
  Key {                                                                                   \
#member, WordSlot{{__VA_ARGS__},                                                        \
                      [](const Scene& scene) { return static_cast<int>(scene.member); },    \
                      [](Scene& scene, int word) {                                          \
                        scene.member = static_cast<decltype(scene.member)>(word);           \
                      }},                                                                   \
        doc \
  }

// A word of a registry of laws, which the scene holds as it is.
#define LAW(member, doc, ...)                                                                            \
  Key {                                                                                                  \
#member,                                                                                               \
        WordSlot{{__VA_ARGS__},                                                                            \
                 [](const Scene& scene) { return place_of(scene.member, {__VA_ARGS__}); },                 \
                 [](Scene& scene, int word) { scene.member = std::initializer_list<const char*>{__VA_ARGS__}.begin()[word]; }}, \
        doc \
  }

// clang-format off
std::vector<Key> make_keys() {
  using namespace dimension;
  return {
      VECTOR(body_force, force, "on every particle; stands before the first section"),
      VECTOR(gravity, acceleration, "of gravity, which gets buoyancy from fluid.density; stands before the first section"),

      NUMBER(geometry.neck_width, length, positive, "y extent of the neck, D; required without an STL file"),
      NUMBER(geometry.neck_height, length, positive, "z extent of neck and channel; default neck_width"),
      NUMBER(geometry.channel_width, length, positive, "y extent of the wide channel; default 4 neck_width"),
      NUMBER(geometry.channel_length, length, positive, "straight part upstream of the narrowing; default 10 neck_width"),
      NUMBER(geometry.neck_length, length, positive, "straight part of the neck; default neck_width"),
      ANGLE(geometry.half_angle, "of the narrowing, from the flow axis; 90 deg is a step; required where the channel is wider than the neck"),
      ANGLE(geometry.half_angle_below, "of the narrowing at y < 0, where it is asymmetric; default half_angle"),
      NUMBER(geometry.neck_rounding, length, positive, "radius of the rounded entrance of the neck; default: a sharp edge"),
      NUMBER(geometry.step_width, length, positive, "y extent of a straight part between two narrowings; default: one narrowing"),
      NUMBER(geometry.step_length, length, positive, "length of that part; required with step_width"),
      NUMBER(geometry.expansion_width, length, positive, "y extent of the channel that follows the neck; default: the neck is the end"),
      NUMBER(geometry.expansion_length, length, positive, "its straight part; default expansion_width"),
      ANGLE(geometry.expansion_angle, "of its walls, from the flow axis; default half_angle"),
      TEXT(geometry.stl, "walls from this STL file instead of the shape above; with neck_width a channel whose inlet and outlet are named"),
      NUMBER(geometry.stl_unit, length, positive, "length that the STL file counts in; default 1 m"),
      NUMBER(geometry.stl_tolerance, length, non_negative, "corners of the STL file that differ by less along x, y and z are one; default 1e-6 of its largest extent"),
      TEXT(geometry.stl_content, "content hash of the STL file of a channel; default: computed"),
      NUMBER(geometry.inlet_position, length, (Range{.high = 0, .high_allowed = false}), "x of the inlet of an STL channel; default: measured"),
      NUMBER(geometry.outlet_position, length, positive, "x of the outlet of an STL channel; default: measured"),
      NUMBER(geometry.inlet_diameter, length, positive, "largest circle in a round inlet of an STL channel; default: measured, none in a rectangle"),
      NUMBER(geometry.inlet_area, area, positive, "of a round inlet of an STL channel; default: measured, none of a rectangle"),
      NUMBER(geometry.neck_area, area, positive, "of all necks together just behind x = 0, of an STL channel with a round inlet or several necks; default: measured"),

      VECTOR(box.min, length, "lower corner of plain walls around a laboratory scene; required in a [box]"),
      VECTOR(box.max, length, "upper corner of these walls; required in a [box]"),

      NUMBER(fluid.viscosity, viscosity, positive, "dynamic viscosity of the fluid; required for drag, lubrication or an OpenFOAM flow"),
      NUMBER(fluid.density, density, positive, "density of the fluid; required for an OpenFOAM flow, or where particles.density is missing"),

      WORD(flow.source, "where the flow comes from; default openfoam with a [geometry], none without", "openfoam", "uniform", "none"),
      NUMBER(flow.mean_velocity, velocity, positive, "mean over the wide channel; required for an OpenFOAM flow without flow.rate"),
      NUMBER(flow.rate, flow_rate, positive, "volume per time, in the place of mean_velocity: over channel_width times neck_height"),
      VECTOR(flow.velocity, velocity, "of a uniform flow, one velocity being along x; default mean_velocity along x"),
      NUMBER(flow.mesh_cells_per_neck, number, (Range{.low = 4, .high = 400}), "mesh cells across the full neck width; default 48"),
      SWITCH(flow.extrapolate, "solve on half as many cells along each edge too, and extrapolate to cells of no size; default true from 16 cells on"),
      NUMBER(flow.grid_spacing, length, positive, "of the regular grid, a whole fraction of the neck height; default near neck_width / 50, or as grid_tolerance asks"),
      NUMBER(flow.grid_tolerance, number, (Range{.low = 0, .high = 1, .low_allowed = false}), "rms error of reading the grid in the neck, over the mean velocity there, that grid_spacing is chosen for where it is not given"),
      WORD(flow.lookup, "how the grid is read: at the nearest point, or between its points", "nearest", "trilinear"),
      SWITCH(flow.rescale, "scale the field to mean_velocity, so that one solution serves several velocities"),
      NUMBER(flow.pulsation.strength, number, non_negative, "standard deviation of a random factor on the whole flow; default 0: off"),
      NUMBER(flow.pulsation.time, time, positive, "correlation time of that factor; required with its strength"),
      WORD(flow.drive, "what is given: the rate of the flow, or the pressure drop over the channel, whose flow then depends on what the particles resist; default rate", "rate", "pressure"),
      NUMBER(flow.pressure_drop, pressure, positive, "over the channel, from inlet to outlet, for drive = \"pressure\"; required there"),
      NUMBER(flow.compliance, compliance, positive, "of a tube or syringe between a pump of constant rate and the channel, volume over pressure; default: none"),
      NUMBER(flow.oscillation.amplitude, number, positive, "of a prescribed factor on the whole flow, 1 + amplitude sin(2 pi (frequency t + phase)); default: steady"),
      NUMBER(flow.oscillation.frequency, rate, positive, "of that factor; required with its amplitude"),
      NUMBER(flow.oscillation.phase, number, (Range{.low = 0, .high = 1, .low_allowed = false, .high_allowed = false}), "of that factor at time 0, as a share of a period; default 0"),
      WORD(flow.oscillation.shape, "of that factor: the sine, or its sign", "sine", "square"),
      TEXT(flow.oscillation.table, "CSV file in the place of all that, with the header time,factor or time [ms],factor: ramps and reversals"),

      NUMBER(particles.diameter, length, positive, "of a particle; of unequal ones the mean over their number; required without particles.species"),
      WORD(particles.size_distribution, "distribution of the diameters, each species about its own mean; default normal", "uniform", "normal", "lognormal", "file"),
      NUMBER(particles.size_spread, number, spread, "standard deviation of the diameters over their mean; default 0: equal"),
      TEXT(particles.size_file, "CSV file of size_distribution file: columns diameter, with its unit, and share; required there"),
      Key{"particles.species", SpeciesSlot{AT(particles.species)}, "a mixture: [{diameter = \"33 um\", share = 0.5, density = \"1062 kg/m3\"}, ...], shares of the number of particles; density by default that of all; also friction = {sliding = 0.3, rolling = 0.1, torsion = 0.1} of its surface and wall_friction = {...} with the walls: docs/sizes.md"},
      NUMBER(particles.density, density, positive, "of the particles; default fluid.density"),
      NUMBER(particles.roughness, length, positive, "height of surface roughness, xi, below which films end; default 0.005 diameter"),
      TEXT(particles.initial, "CSV file of initial particles: x,y,z,radius,vx,vy,vz,wx,wy,wz in SI units"),

      LAW(contact.law, "normal force of a contact: Hertz, a linear spring, or Hertz that sticks: soft spheres (Johnson, Kendall, Roberts), hard ones (Derjaguin, Muller, Toporov); default hertz", "hertz", "hooke", "jkr", "dmt"),
      NUMBER(contact.youngs_modulus, pressure, positive, "Young's modulus of the particles; required"),
      NUMBER(contact.poisson_ratio, number, (Range{.low = 0, .high = 0.5, .high_allowed = false}), "Poisson's ratio of the particles; required"),
      NUMBER(contact.stiffness, stiffness, positive, "of the linear spring of law hooke; required there"),
      NUMBER(contact.surface_energy, stiffness, positive, "work of adhesion of laws jkr and dmt: to part both surfaces, per area; required there"),
      NUMBER(contact.restitution, number, restitution, "speed after over before a dry head-on impact; default 0.7"),
      NUMBER(contact.tangential_factor, number, positive, "factor on the tangential stiffness; default 2/3, for law hooke 2/7 of its spring"),
      NUMBER(contact.tangential_damping, number, non_negative, "sliding, rolling and torsion damping over the normal one; default 1"),
      LAW(contact.turning, "how rolling and torsion turn: lever R* and stiffness of Luding, or 2 R* and full stiffness of MercuryDPM; default luding", "luding", "mercury"),
      WORD(contact.torsion_update, "how the torsion spring is advanced; doubling is an experiment", "objective", "doubling"),
      NUMBER(contact.friction.sliding, number, non_negative, "Coulomb coefficient of sliding between particles; default 0"),
      NUMBER(contact.friction.rolling, number, non_negative, "coefficient of rolling between particles; default 0"),
      NUMBER(contact.friction.torsion, number, non_negative, "coefficient of torsion between particles; default 0"),
      NUMBER(contact.wall_friction.sliding, number, non_negative, "coefficient of sliding at walls; default: as between particles"),
      NUMBER(contact.wall_friction.rolling, number, non_negative, "coefficient of rolling at walls; default: as between particles"),
      NUMBER(contact.wall_friction.torsion, number, non_negative, "coefficient of torsion at walls; default: as between particles"),
      NUMBER(contact.wall_youngs_modulus, pressure, positive, "Young's modulus of the walls; default: as the particles"),
      NUMBER(contact.wall_poisson_ratio, number, (Range{.low = 0, .high = 0.5, .high_allowed = false}), "Poisson's ratio of the walls; default: as the particles"),
      NUMBER(contact.wall_restitution, number, restitution, "restitution of a particle on a wall; default: as between particles"),

      SWITCH(lubrication.enabled, "normal lubrication between particles; default true when the section is present"),
      WORD(lubrication.below_roughness, "for gaps below 2 roughness: no force, or the force at 2 roughness; default off", "off", "clamp"),
      SWITCH(lubrication.walls, "lubrication between particles and walls too; default false"),
      NUMBER(lubrication.cutoff, length, positive, "largest gap with lubrication; default diameter / 2"),

      SWITCH(drag.enabled, "drag of the flow on particles; default true when the section is present"),
      LAW(drag.law, "drag in a pack over that of a lone sphere: van der Hoef et al. at Re = 0, none, or Beetstra et al. with the slip's Reynolds number; default hoef", "hoef", "stokes", "beetstra"),
      WORD(drag.velocity, "whose rate the flow keeps: the liquid's (f multiplies V0/porosity - u, as in the paper), the same without the pressure gradient's share (1 - porosity of the force on a pack at rest), or the mixture's ((V0 - u)/porosity)", "interstitial", "superficial", "mixture"),
      SWITCH(drag.viscous_torque, "torque of the fluid on a particle that spins; default false"),
      NUMBER(drag.fluctuation.strength, number, non_negative, "standard deviation over mean of a random factor on the drag of each particle; default 0: off"),
      NUMBER(drag.fluctuation.time, time, positive, "correlation time of that factor; required with its strength"),

      WORD(porosity.method, "mean over strips along the upstream channel, or around each particle", "strips", "local"),
      COUNT(porosity.strips, (Range{.low = 0, .high = 1000}), "strips along the upstream channel; default 3 when the section is present, else 0: porosity 1"),
      SWITCH(porosity.neck, "the neck is a strip of its own, else it has the porosity of the last one; default false"),
      NUMBER(porosity.width, length, positive, "standard deviation of the kernel of method local; default 1.5 diameters"),
      NUMBER(porosity.update_interval, time, non_negative, "time between computations of the porosity, 0: every step; default a thousandth of the Stokes time"),

      SWITCH(inlet.enabled, "particles enter at the inlet; default true when the section is present"),
      WORD(inlet.start, "at time 0 the channel is filled and jammed behind a gate, or empty, or flows densely without friction until then", "filled", "empty", "flowing"),
      NUMBER(inlet.rate, rate, non_negative, "largest number of insertions per time; default 0: as many as fit"),
      NUMBER(inlet.concentration, number, dilute, "share of particles in the volume that flows in; default 0: as many as fit"),
      COUNT(inlet.taps, (Range{.low = 0, .high = 100}), "moments without friction that consolidate a filled start; default 2"),
      NUMBER(inlet.strain, number, positive, "volume of particles that passes without friction before a flowing start counts, in neck widths times the neck's cross-section; default 10"),

      WORD(unclog.protocol, "at a clog: nothing, a moment without friction, the run ends, the column flows without friction as at a flowing start, does so from where friction began, or its arch is taken out", "none", "release", "stop", "restart", "rewind", "poke"),
      NUMBER(unclog.after, time, positive, "nothing passed for this long, where rest is not proved sooner, counted in what an unsteady flow carries; default 5 Stokes times"),
      NUMBER(unclog.duration, time, positive, "of a release: friction is off for this long; default 0.23 Stokes times"),
      NUMBER(unclog.region, number, non_negative, "friction is off from this many neck widths upstream of the neck on; default 0: everywhere"),
      NUMBER(unclog.strain, number, positive, "of a restart: as inlet.strain; default 10, of a rewind 1"),
      SWITCH(unclog.shortcut, "go on as soon as the clog is proved to be at rest for good; default true"),

      NUMBER(time.end, time, positive, "simulated time; required"),
      NUMBER(time.step, time, positive, "fixed step instead of step_fraction; default: chosen by step_fraction"),
      NUMBER(time.step_fraction, number, fraction, "step over the Hertz contact time; default 0.02"),
      NUMBER(time.contact_limit_share, number, fraction, "a step from step_fraction is no longer than this share of the limit expected of the contacts; default: not looked at"),
      NUMBER(time.mass_scale, number, positive, "numerical mass over true mass; default 1"),
      NUMBER(time.rotational_inertia_scale, number, positive, "numerical moment of inertia over true one; default 1"),
      WORD(time.integrator, "drag explicit, or implicit so that it never limits the step, or drag and lubrication both", "verlet", "implicit_drag", "implicit_fluid"),
      SWITCH(time.allow_unstable, "run with a step above its limit, for studies of what that does; default false"),

      NUMBER(passages.plane, length, any, "x that a particle must cross to have passed; default the middle of the neck; without a neck 0: nothing is counted"),

      NUMBER(output.snapshot_interval, time, non_negative, "time between snapshots of all particles; default 0: none"),
      NUMBER(output.burst_snapshots, time, positive, "between the first 50 snapshots of each burst, then ever rarer; default: none beside those of snapshot_interval"),
      SWITCH(output.contacts, "whether snapshots hold the force of each contact too; default false"),
      NUMBER(output.series_interval, time, positive, "time between rows of the time series; default a tenth of the Stokes time"),
      NUMBER(output.checkpoint_interval, time, positive, "wall-clock time between saved states; default 60 s"),

      TEXT(fidelity.preset, "stiffness, mass and step by name: \"standard\" (within 5 % of the paper's particles), \"fast\" (within 10 %) or \"reference\" (those particles); default none"),
      NUMBER(fidelity.tolerance, number, (Range{.low = 0, .high = 1, .high_allowed = false}), "take the cheapest stiffness, mass and step whose <s>, flow rate and packing are within this share of the paper's particles; default 0: none"),

      Key{"ensemble.seeds", SeedsSlot{AT(ensemble.seeds)}, "random seeds, one run each: \"1-40\" or [1, 2, 3]; default 1"},
      Key{"ensemble.sweep", TextsSlot{AT(ensemble.sweep)}, "keys and their values, a folder for each point: [\"particles.diameter = 25 um, 33 um\"]; default none"},
  };
}
// clang-format on

std::string_view last_name(std::string_view path) { return path.substr(path.rfind('.') + 1); }

}  // namespace

std::string Range::words() const {
  if (std::isinf(high) && std::isinf(low)) return "must be a finite number";
  if (std::isinf(high)) return fmt::format("must be {} {}", low_allowed ? ">=" : ">", low);
  return fmt::format("must be in {}{}, {}{}", low_allowed ? '[' : '(', low, high, high_allowed ? ']' : ')');
}

const std::vector<Key>& scene_keys() {
  static const std::vector<Key> keys = make_keys();
  return keys;
}

const Key* find_key(std::string_view path) {
  for (const Key& key : scene_keys())
    if (key.path == path) return &key;
  return nullptr;
}

std::string_view section_of(std::string_view path) {
  const std::size_t dot = path.find('.');
  return dot == std::string_view::npos ? std::string_view{} : path.substr(0, dot);
}

bool is_section(std::string_view path) {
  return std::ranges::any_of(scene_keys(), [path](const Key& key) {
    return key.path.size() > path.size() && key.path.starts_with(path) && key.path[path.size()] == '.';
  });
}

std::string_view nearest_key(std::string_view path) {
  // Twice as long as any of ours: what comes after makes no difference to which is nearest.
  path = path.substr(0, 80);
  // A right name in a wrong section must win over a similar path, hence the second measure.
  const auto distance = [path](const Key& key) {
    const std::size_t leaf = edit_distance(last_name(path), last_name(key.path));
    return std::min(edit_distance(path, key.path), 2 + leaf + leaf);
  };
  const auto nearest = std::ranges::min_element(scene_keys(), {}, distance);
  return is_near(distance(*nearest), path) ? nearest->path : std::string_view{};
}

std::string unknown_key(std::string_view path) {
  const std::string_view nearest = nearest_key(path);
  return nearest.empty() ? "unknown key" : fmt::format("unknown key; the nearest known key is {}", nearest);
}

}  // namespace clogflow
