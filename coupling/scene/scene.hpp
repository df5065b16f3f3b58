// The scene: everything a user decides, in SI units, complete (every default filled in).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "coupling/geometry/geometry.hpp"

namespace clogflow {

enum class FlowSource { openfoam, uniform, none };
enum class OscillationShape { sine, square };
enum class DrivenBy { rate, pressure };
enum class Lookup { nearest, trilinear };
enum class TorsionUpdate { objective, doubling };
enum class BelowRoughness { off, clamp };
enum class DragVelocity { interstitial, superficial, mixture };
enum class PorosityMethod { strips, local };
enum class InletStart { filled, empty, flowing };
enum class UnclogProtocol { none, release, stop, restart, rewind, poke };
enum class SizeDistribution { uniform, normal, lognormal, file };
enum class Integrator { verlet, implicit_drag, implicit_fluid };

struct Friction {
  double sliding = 0;  ///< [-]
  double rolling = 0;  ///< [-]
  double torsion = 0;  ///< [-]

  bool operator==(const Friction&) const = default;
};

/// Of a species that leaves friction to what is common to all.
inline constexpr Friction common_friction{-1, -1, -1};

/// Particles of one kind in a mixture.
struct Species {
  double diameter = 0;                       ///< mean over their number [m]
  double share = 0;                          ///< of the number of all particles [-]
  double density = 0;                        ///< [kg/m3]; default particles.density
  Friction friction = common_friction;       ///< of its surface; what is left out is that of contact.friction
  Friction wall_friction = common_friction;  ///< with the walls; default contact.wall_friction if given, else friction

  bool has_friction() const { return !(friction == common_friction) || !(wall_friction == common_friction); }
  bool operator==(const Species&) const = default;
};

inline constexpr std::size_t most_species = 100;

/// Plain data, one member per scene key, named as the key. A section that is absent in the file has
/// `present = false` or its term off; values that the file leaves out hold their documented default.
struct Scene {
  Geometry geometry;

  struct Box {
    bool present = false;
    std::array<double, 3> min{}, max{};  ///< plain walls of a laboratory scene [m]
  } box;

  struct Fluid {
    double viscosity = 0;  ///< [Pa s]
    double density = 0;    ///< [kg/m3]
  } fluid;

  struct Flow {
    FlowSource source = FlowSource::none;
    double mean_velocity = 0;          ///< mean in the wide channel [m/s]
    double rate = 0;                   ///< given in the place of mean_velocity, which it becomes; then 0 [m3/s]
    std::array<double, 3> velocity{};  ///< of a uniform flow [m/s]
    double mesh_cells_per_neck = 0;    ///< cells across the full neck width [-]
    bool extrapolate = false;          ///< towards cells of no size, from this mesh and a coarser one
    double grid_spacing = 0;           ///< of flow.h5 [m]
    double grid_tolerance = 0;         ///< error that grid_spacing was chosen for [-]; 0: none
    Lookup lookup = Lookup::nearest;
    bool rescale = false;
    struct {
      double strength = 0;  ///< standard deviation of the factor on V0 [-]
      double time = 0;      ///< correlation time [s]
    } pulsation;
    DrivenBy drive = DrivenBy::rate;
    double pressure_drop = 0;  ///< that drives it, inlet to outlet [Pa]; 0: it is not driven by pressure
    double compliance = 0;     ///< between a pump of constant rate and the channel [m3/Pa]; 0: none

    /// Whether the particles' resistance decides how fast it goes: dem/fluid/pressure_balance.hpp.
    bool balances() const { return drive == DrivenBy::pressure || compliance > 0; }

    /// A prescribed factor on the whole flow: dem/fluid/oscillation.hpp.
    struct {
      double amplitude = 0;  ///< over the mean flow [-]; 0: none
      double frequency = 0;  ///< [Hz]
      double phase = 0;      ///< at time 0, of a period [-]
      OscillationShape shape = OscillationShape::sine;
      std::string table;  ///< CSV of time and factor in their place; empty: none

      bool on() const { return amplitude > 0 || !table.empty(); }
    } oscillation;
  } flow;

  struct Particles {
    double diameter = 0;  ///< mean over the number of particles [m]; default that of species or size_file
    SizeDistribution size_distribution = SizeDistribution::normal;
    double size_spread = 0;        ///< standard deviation of the diameter over its mean, in each species [-]
    std::string size_file;         ///< CSV of diameters and shares; empty: none
    std::vector<Species> species;  ///< empty: all particles are of one kind
    double density = 0;            ///< [kg/m3]; default fluid.density
    double roughness = 0;          ///< xi [m], one length for all sizes; default 0.005 diameter
    std::string initial;           ///< CSV of initial particles; empty: none
  } particles;

  struct Contact {
    std::string law = "hertz";             ///< a word of dem/physics/contact_laws.hpp
    double youngs_modulus = 0;             ///< [Pa]
    double poisson_ratio = 0;              ///< [-]
    double stiffness = 0;                  ///< of linear springs [N/m]; 0: none
    double surface_energy = 0;             ///< work of adhesion, both surfaces together [J/m2]; 0: none
    double restitution = 0.7;              ///< of a dry head-on impact [-]
    double tangential_factor = 2.0 / 3.0;  ///< on the Mindlin stiffness [-]
    double tangential_damping = 1;         ///< damping ratio of sliding, rolling and torsion over the normal one [-]
    std::string turning = "luding";        ///< how rolling and torsion turn, a word of the same
    TorsionUpdate torsion_update = TorsionUpdate::objective;
    Friction friction;
    Friction wall_friction;          ///< default: friction
    double wall_youngs_modulus = 0;  ///< [Pa]; default youngs_modulus
    double wall_poisson_ratio = 0;   ///< [-]; default poisson_ratio
    double wall_restitution = 0;     ///< of a dry head-on impact on a wall [-]; 0: restitution
  } contact;

  struct Lubrication {
    bool enabled = false;
    BelowRoughness below_roughness = BelowRoughness::off;
    bool walls = false;
    double cutoff = 0;  ///< largest gap [m]; default diameter / 2
  } lubrication;

  struct Drag {
    bool enabled = false;
    std::string law = "hoef";  ///< a word of dem/physics/drag_law.hpp
    DragVelocity velocity = DragVelocity::interstitial;
    bool viscous_torque = false;
    struct {
      double strength = 0;  ///< standard deviation relative to the mean drag [-]
      double time = 0;      ///< correlation time [s]
    } fluctuation;
  } drag;

  struct Porosity {
    PorosityMethod method = PorosityMethod::strips;
    int strips = 0;              ///< 0: porosity 1 everywhere
    bool neck = false;           ///< the neck is a strip of its own
    double width = 0;            ///< of the kernel of a local porosity [m]; default 1.5 diameters
    double update_interval = 0;  ///< [s]; default tau / 1000
  } porosity;

  struct Inlet {
    bool enabled = false;
    InletStart start = InletStart::filled;
    double rate = 0;           ///< largest number of insertions per second [1/s]; 0: as many as fit
    double concentration = 0;  ///< share of the inflow's volume that is particles [-]; 0: as many as fit
    int taps = 2;              ///< moments without friction that consolidate a filled start [-]
    /// Solids that pass the neck without friction before a flowing start counts, in neck widths times its
    /// cross-section [-]
    double strain = 0;
  } inlet;

  std::array<double, 3> body_force{};  ///< on every particle [N]
  std::array<double, 3> gravity{};     ///< with buoyancy from the densities [m/s2]

  struct Unclog {
    UnclogProtocol protocol = UnclogProtocol::none;
    double after = 0;      ///< nothing passed for this time [s]; default 5 tau
    double duration = 0;   ///< of a release: friction is off for this time [s]; default 0.23 tau
    double region = 0;     ///< friction is off from this many neck widths upstream of the neck on [-]; 0: everywhere
    double strain = 0;     ///< of restart and rewind: as inlet.strain [-]
    bool shortcut = true;  ///< a clog that is proved to be at rest is not waited for
  } unclog;

  struct Time {
    double end = 0;                       ///< [s]
    double step = 0;                      ///< [s]; 0: step_fraction of the contact time
    double step_fraction = 0.02;          ///< of tau_Hertz [-]
    double contact_limit_share = 0;       ///< largest step over the contacts' expected limit [-]; 0: any
    double mass_scale = 1;                ///< [-]
    double rotational_inertia_scale = 1;  ///< [-]
    Integrator integrator = Integrator::verlet;
    bool allow_unstable = false;  ///< warn of a step above its limit instead of refusing it
  } time;

  struct Passages {
    double plane = 0;  ///< x that a particle must cross [m]; default middle of the neck
  } passages;

  struct Output {
    double snapshot_interval = 0;    ///< [s]; 0: none
    double burst_snapshots = 0;      ///< between the first snapshots of a burst [s]; 0: none of their own
    bool contacts = false;           ///< snapshots hold the forces between those that touch
    double series_interval = 0;      ///< [s]; default tau / 10
    double checkpoint_interval = 0;  ///< of wall-clock time [s]; default 60 s
  } output;

  struct Fidelity {
    std::string preset;    ///< empty: none
    double tolerance = 0;  ///< [-]; 0: none
  } fidelity;

  struct Ensemble {
    std::vector<std::uint64_t> seeds;
    std::vector<std::string> sweep;  ///< "key = value, value": see coupling/scene/sweep.hpp
  } ensemble;

  /// Of the flow that the scene has: the mean over the wide channel, or the uniform one [m/s]; 0 without.
  double flow_speed() const;

  /// Of a silo, whose particles fall along the channel and are not carried: g_x (1 - rho_f / rho_p) over the mass
  /// scale, of particles.density [m/s2]; 0 elsewhere.
  double fall_acceleration() const;
  bool falls() const { return fall_acceleration() > 0; }

  /// What speeds are compared with: flow_speed(), or sqrt(a D) of such a fall, the speed after half the neck's
  /// width, which is that of the grains at the orifice within a factor of about two (Beverloo et al., Chem. Eng. Sci.
  /// 15 (1961) 260) [m/s]; 0 without either.
  double speed_scale() const;

  /// tau = d / v of that speed, the time a particle takes to travel its diameter [s]; 0 without.
  double stokes_time() const;
};

/// "key=value" of a --set option.
using Overrides = std::vector<std::string>;

/// Reads a scene file, applies the overrides, checks everything, fills in the defaults.
/// Relative file names inside (stl, initial) are taken from the scene file's folder.
/// \throws Error with file, line, key, value, what is allowed, and the nearest known key
Scene read_scene(const std::filesystem::path& file, const Overrides& overrides = {});

/// The same from text; `name` stands for the file in messages.
Scene parse_scene(const std::string& text, const std::string& name, const Overrides& overrides = {});

/// The complete scene as TOML in SI units: parse_scene reads it back to an equal scene. It goes
/// into every output.
std::string effective_scene(const Scene& scene);

/// Only the keys that decide the flow field, one a line: what a flow is identified by.
std::string flow_inputs(const Scene& scene);

/// "1-40", "3", "1-4,9": seeds in the order given.
/// \throws Error naming the text
std::vector<std::uint64_t> parse_seeds(const std::string& text);

/// The same back: "1-4,9".
std::string format_seeds(const std::vector<std::uint64_t>& seeds);

}  // namespace clogflow
