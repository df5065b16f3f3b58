#include "dem/plan/plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "coupling/base/units.hpp"
#include "coupling/flow/flow_reach.hpp"
#include "coupling/flow/flow_rescale.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/scene/particle_sizes.hpp"
#include "dem/physics/dimensionless.hpp"
#include "dem/physics/jkr.hpp"
#include "dem/physics/laws/dmt.hpp"
#include "dem/physics/material_pair.hpp"
#include "dem/physics/porosity.hpp"
#include "dem/physics/time_step.hpp"
#include "dem/plan/plan_drive.hpp"
#include "dem/plan/term_costs.hpp"
#include "dem/run/initial_placement.hpp"
#include "dem/run/model.hpp"
#include "dem/stability/pack_estimates.hpp"
#include "dem/state/external_force.hpp"

namespace clogflow {

namespace {

/// Duration of a filled start in units of the time the flow needs for the channel, as seen.
constexpr double filling_share = 0.7;

/// Bytes per particle of state, pair list and springs.
constexpr double bytes_per_particle = 900;

/// What a drag law that knows the Reynolds number still leaves out.
constexpr const char* lift = "lift or added mass";

/// Whether arches turn on their contacts is the user's to say: a coefficient of 0 is a choice, and leaves nothing out.
constexpr const char *rolling = "rolling friction", *torsion = "torsion friction";

/// Pull-off force over the drag of one sphere in the neck from which adhesion is called needed: at 1 and 3 no effect on
/// the first clogs was seen, at 10 they came four times sooner (docs/reports/cohesion.md).
constexpr double adhesion_from = 1;

/// Room beside a whole number of layers, in diameters, below which equal spheres order as in a crystal: at 50 um in a
/// channel of 100 um they do, at 47 um (0.13) they do not; between these it was not tried.
constexpr double ordering_room = 0.02;

/// Spread of the diameters, standard deviation over mean, from which hard spheres are taken not to crystallize. In
/// simulations nothing did above 0.07, and below it the slower the wider they spread:
/// Pusey et al., Phil. Trans. R. Soc. A 367 (2009) 4993.
constexpr double disorder = 0.08;

double size_spread(const ParticleSizes& sizes) {
  const double mean = sizes.moment(1);
  return std::sqrt(std::max(0.0, sizes.moment(2) / (mean * mean) - 1));
}

/// A warning of layers that just fit an opening, or empty.
std::string layers_warning(double opening, const Scene& scene, const char* key) {
  const ParticleSizes sizes(scene.particles);
  const double diameter = scene.particles.diameter;
  if (size_spread(sizes) >= disorder) return {};
  const double layers = std::floor(opening / diameter + 1e-9), room = opening / diameter - layers;
  if (layers < 1 || room >= ordering_room) return {};
  return fmt::format(
      "{} holds {:.0f} whole layers with room for {:.3g} more: equal spheres may order like a crystal there, as no "
      "suspension does; take a diameter a few per cent smaller{}",
      key, layers, std::max(room, 0.0),
      sizes.equal() ? ", or particles.size_spread = 0.08"
                    : fmt::format(" or a spread of sizes of {} and more", disorder));
}

struct Judge {
  Plan& plan;
  void operator()(PlannedTerm term) const { plan.terms.push_back(std::move(term)); }
};

void judge_fluid(const Scene& s, const Judge& term) {
  const auto& g = s.geometry;
  const double v = s.flow.mean_velocity;
  const SphereInFluid sphere{s.particles.diameter, s.particles.density, s.fluid.density, s.fluid.viscosity};
  const bool drag = s.drag.enabled;
  if (g.present && v > 0) {
    const double duct = reynolds_number(s.fluid.density, v, g.neck_height, s.fluid.viscosity);
    const double neck_speed = neck_mean_velocity(s.geometry, s.flow.mean_velocity);
    const double neck = reynolds_number(s.fluid.density, neck_speed, g.neck_height, s.fluid.viscosity);
    term({"fluid inertia in the channel", "Re = rho v D / eta", duct, duct > 0.1, true,
          "simpleFoam solves Navier-Stokes"});
    term({"fluid inertia in the neck", "Re at the neck's mean velocity", neck, neck > 0.1, true,
          "below 0.1 one Stokes field serves all flow rates"});
    const double slip = reynolds_number(s.fluid.density, neck_speed, sphere.diameter, s.fluid.viscosity);
    const DragLaw& law = drag_law(s);
    if (law.knows_slip) {
      term({"inertial drag", "Re_p = rho v_neck d / eta", slip, slip > 1, drag, "the drag law knows Re_p"});
      term({lift, "Re_p = rho v_neck d / eta", slip, slip > 1, false, "inertial drag is modelled, these are not"});
    } else {
      term({"inertial drag, lift, added mass", "Re_p = rho v_neck d / eta", slip, slip > 1, false,
            "the drag law holds for Re_p << 1"});
    }
    const double gravity = std::hypot(s.gravity[0], s.gravity[1], s.gravity[2]);
    const double settling = settling_ratio(sphere, v, gravity > 0 ? gravity : standard_gravity);
    term({"gravity", "settling velocity / v", settling, settling > 0.01, gravity > 0, "density matched when 0"});
    const double peclet = peclet_number(sphere, v);
    term({"Brownian motion", "Pe = v d / D_0", peclet, peclet < 1e3, false, "diffusion << flow"});
    term({"drag", law.knows_slip ? "f(eps, Re_p) in the pack" : "f(eps) in the pack",
          law.factor({pack_porosity, law.knows_slip ? slip : 0}), true, drag, "drives everything"});
    const double stokes =
        response_time(sphere, drag_law(s).slow_factor(pack_porosity)) * s.time.mass_scale * v / sphere.diameter;
    term({"particle inertia", "St = t_response v / d, mass scale included", stokes, stokes > largest_inertia, true,
          stokes > largest_inertia  ? "mass scaled too far"
          : stokes > unseen_inertia ? "some per cent of <s> and packing: docs/reports/trade.md"
                                    : "irrelevant: mass may be scaled up"});
    const double impact = collision_stokes_number(sphere, collision_speed_share * v);
    term({"dry restitution", "St of a collision", impact, impact > 10, true, "irrelevant below 10"});
    term({"lubrication", "roughness gap 2 xi / d", 2 * s.particles.roughness / sphere.diameter,
          2 * s.particles.roughness / sphere.diameter < 0.1, s.lubrication.enabled, "films thinner than d/10 resist"});
  }
}

void judge_drag(const Scene& s, Plan& plan) {
  if (!s.drag.enabled) return;
  switch (s.drag.velocity) {
    case DragVelocity::interstitial:
      plan.drag_note = "drag.velocity = \"interstitial\": the liquid keeps the flow's rate, F = c (V0/eps - u)";
      break;
    case DragVelocity::mixture:
      plan.drag_note =
          "drag.velocity = \"mixture\": liquid and particles together keep the flow's rate, F = c (V0 - u)/eps";
      break;
    case DragVelocity::superficial:
      plan.drag_note = "drag.velocity = \"superficial\": the liquid keeps the flow's rate, F = c eps (V0/eps - u)";
      plan.drag_gap = fmt::format(
          "drag.velocity = \"superficial\" leaves out the mean pressure gradient's share: on a pack at rest about "
          "{:.2g} "
          "of the total force, which \"interstitial\" and \"mixture\" have",
          1 - pack_porosity);
      break;
  }
}

/// How far the frictions of the species lie apart; a pair's lies between those of its two.
void judge_species_friction(const Scene& s, const Judge& term) {
  double least = std::numeric_limits<double>::infinity(), most = 0, least_wall = least, most_wall = 0;
  for (const Species& kind : s.particles.species) {
    const double own = surface_friction(s, kind).sliding, wall = wall_friction(s, kind).sliding;
    least = std::min(least, own), most = std::max(most, own);
    least_wall = std::min(least_wall, wall), most_wall = std::max(most_wall, wall);
  }
  term({"friction of species", "smallest / largest mu", most > 0 ? least / most : 1, true, true,
        fmt::format("mu between particles {:.3g} to {:.3g}, with walls {:.3g} to {:.3g}", least, most, least_wall,
                    most_wall)});
}

void judge_contacts(const Scene& s, const Model& model, const Judge& term) {
  const double v = s.flow.mean_velocity, d = s.particles.diameter;
  if (v > 0) {
    const double load = arch_load * drag_law(s).slow_factor(pack_porosity) * stokes_coefficient(s.fluid.viscosity, d) *
                        v / pack_porosity;
    const double kappa = d / model.laws.pair.overlap_at(load, d / 4);
    term({"particle stiffness", "kappa = d / overlap in an arch", kappa, kappa < softest, true,
          "softer particles let arches buckle"});
  }
  if (s.falls()) {
    const double radius = d / 2, mass = s.time.mass_scale * s.particles.density * sphere_volume(radius);
    const Vec3 weight = external_force(s, mass, radius);
    const double kappa = d / model.laws.pair.overlap_at(arch_load * std::sqrt(dot(weight, weight)), d / 4);
    term({"gravity", "v = sqrt(g D) [m/s]", s.speed_scale(), true, true, "drives everything; times count in d / v"});
    term({"particle stiffness", "kappa = d / overlap in an arch", kappa, kappa < softest, true,
          "softer particles let arches buckle"});
  }
  if (s.geometry.present)
    term({"third dimension", "neck width / d", s.geometry.neck_width / d, true, true,
          s.geometry.neck_width / d < 3 ? "close to a single layer" : "arches are domes"});
  // Where species differ, the largest of any pair.
  const FrictionLaw& f = model.laws.pair.friction;
  term({"sliding friction", "mu", f.sliding, true, f.sliding > 0, "arches need it"});
  constexpr const char* decides = "either of rolling and torsion lets arches hold that flow without both";
  term({rolling, "mu_r", f.rolling, true, f.rolling > 0, decides});
  term({torsion, "mu_o", f.torsion, true, f.torsion > 0, decides});
  if (has_friction_of_species(s.particles)) judge_species_friction(s, term);
}

/// What a run with several sizes is like.
void judge_sizes(const Scene& s, const Model& model, Plan& plan) {
  const ParticleSizes& sizes = model.sizes;
  if (sizes.equal()) return;
  const double spread = size_spread(sizes), ratio = sizes.largest() / sizes.smallest();
  plan.terms.push_back({"unequal sizes", "standard deviation / mean of the diameter", spread, spread >= disorder, true,
                        spread >= disorder ? "ends crystals" : "does not end crystals: that takes 0.08"});
  plan.sizes_note = fmt::format(
      "diameters from {} to {} (ratio {:.3g}) in {} kind{}: number mean {} (D/d and Stokes times), Sauter mean {} "
      "(drag); the smallest decides the step",
      short_length(sizes.smallest()), short_length(sizes.largest()), ratio, sizes.species(),
      sizes.species() > 1 ? "s" : "", short_length(s.particles.diameter), short_length(sizes.sauter_mean()));
}

/// What carries a particle past others: the flow in the neck, or wherever it is where there is no neck [m/s].
double passing_speed(const Scene& s) {
  return s.geometry.present && s.flow.mean_velocity > 0 ? neck_mean_velocity(s.geometry, s.flow.mean_velocity)
                                                        : s.flow_speed();
}

void judge_adhesion(const Scene& s, Plan& plan) {
  const auto& c = s.contact;
  const double radius = s.particles.diameter / 4, v = passing_speed(s);
  const SphereInFluid sphere{s.particles.diameter, s.particles.density, s.fluid.density, s.fluid.viscosity};
  if (!adheres(c)) {
    if (v > 0 && s.drag.enabled)
      plan.terms.push_back({"adhesion", "w [J/m2] of pull-off = 3 pi eta d v_neck",
                            stokes_coefficient(sphere.viscosity, sphere.diameter) * v / jkr_pull_off(1.0, radius),
                            false, false, "if yours is above it: contact.law, contact.surface_energy"});
    return;
  }
  const bool soft = c.law == "jkr";
  Dmt hard;
  hard.surface_energy = c.surface_energy;
  const double pull_off = soft ? jkr_pull_off(c.surface_energy, radius) : hard.pull_off(radius);
  if (v > 0) {
    const double ratio = adhesion_number(pull_off, sphere, v);
    plan.terms.push_back({"adhesion", "pull-off force / (3 pi eta d v_neck)", ratio, ratio > adhesion_from, true,
                          "above 1 the drag of one sphere parts no pair; clogs: docs/reports/cohesion.md"});
  }
  const Material own{c.youngs_modulus, c.poisson_ratio};
  const double tabor = tabor_number(c.surface_energy, effective_modulus(own, own), radius);
  plan.terms.push_back({"law of adhesion", "Tabor's mu_T", tabor, true, true,
                        fmt::format("jkr above {}, dmt below {}", jkr_from, dmt_until)});
  if (soft && tabor < dmt_until)
    plan.law_note =
        fmt::format("Tabor's mu_T = {:.3g} is below {}: contact.law = \"dmt\" fits, not \"jkr\"", tabor, dmt_until);
  if (!soft && tabor > jkr_from)
    plan.law_note =
        fmt::format("Tabor's mu_T = {:.3g} is above {}: contact.law = \"jkr\" fits, not \"dmt\"", tabor, jkr_from);
}

void find_limits(const Scene& s, const Model& model, Plan& plan) {
  plan.dt = model.dt;
  plan.limits = expected_limits(model, read_initial_particles(s));
  if (s.geometry.present && s.flow.mean_velocity > 0)
    plan.way_limit = 0.01 * s.particles.diameter /
                     (model.factors.fastest * neck_mean_velocity(s.geometry, s.flow.mean_velocity) / pack_porosity);
}

void estimate_cost(const Scene& s, const Model& model, Plan& plan) {
  plan.steps = static_cast<double>(model.steps);
  plan.particles = static_cast<double>(read_initial_particles(s).size());
  if (s.inlet.enabled) {
    const double start = channel_start(s.geometry);
    plan.particles +=
        (1 - pack_porosity) * channel_volume(s.geometry, start, 0) / ParticleSizes(s.particles).mean_volume();
    if (s.inlet.start != InletStart::empty)
      plan.filling_steps = filling_share * s.geometry.channel_length / s.speed_scale() / model.dt;
    if (s.inlet.start == InletStart::flowing)
      plan.filling_steps = frictionless_time(s, s.inlet.strain, packing_of_start) / model.dt;
  }
  plan.memory = bytes_per_particle * plan.particles;
  const double diameters = s.flow.mean_velocity * model.dt / s.particles.diameter;
  const double each = instructions_per_particle_step(s, diameters);
  plan.instructions = (plan.steps + plan.filling_steps) * plan.particles * each;
  for (const TermCost& cost : term_costs(s))
    for (PlannedTerm& term : plan.terms)
      if (term.term == cost.term) term.share = cost.instructions / each;
}

void estimate_burst(const Scene& s, Plan& plan) {
  plan.burst = expected_burst(s);
  if (!plan.burst.unknown.empty()) return;
  plan.burst_steps = plan.burst.simulated() / plan.dt * plan.particles;
  plan.burst_instructions =
      plan.burst_steps * instructions_per_particle_step(s, s.flow.mean_velocity * plan.dt / s.particles.diameter);
}

void judge_flow(const Scene& s, Plan& plan) {
  if (s.flow.source != FlowSource::openfoam) return;
  plan.grid_reach = expected_reach(s, reach_tolerance);
  plan.scaling_error = error_per_reynolds_number * neck_reynolds_number(s);
}

}  // namespace

double frictionless_time(const Scene& s, double strain, double packing) {
  if (s.falls()) return strain * s.geometry.neck_width / (packing * s.speed_scale());
  const double carried = packing * s.flow_speed() / (s.drag.velocity == DragVelocity::mixture ? 1 : 1 - packing);
  const Geometry& g = s.geometry;
  return strain * g.neck_width * neck_section(g) / channel_flow_rate(g, carried);
}

Plan make_plan(const Scene& scene) {
  const Model model = make_model(scene, nullptr, read_initial_particles(scene));
  check_placement(read_initial_file(scene), model);
  Plan plan;
  plan.walls_note = model.walls_note;
  judge_fluid(scene, Judge{plan});
  judge_contacts(scene, model, Judge{plan});
  judge_adhesion(scene, plan);
  judge_sizes(scene, model, plan);
  judge_drag(scene, plan);
  plan.contact = scene.contact;
  judge_drive(scene, model, plan);
  find_limits(scene, model, plan);
  estimate_cost(scene, model, plan);
  estimate_burst(scene, plan);
  plan.disk = disk_use(scene, plan.particles, plan.burst);
  judge_flow(scene, plan);
  if (scene.geometry.present) {
    plan.layers_note = layers_warning(scene.geometry.neck_height, scene, "geometry.neck_height");
    if (plan.layers_note.empty())
      plan.layers_note = layers_warning(scene.geometry.neck_width, scene, "geometry.neck_width");
  }
  return plan;
}

std::vector<std::string> warnings(const Plan& plan) {
  std::vector<std::string> lines;
  if (!plan.walls_note.empty()) lines.push_back(plan.walls_note);
  for (const PlannedTerm& t : plan.terms) {
    if (t.needed && !t.modelled && t.term != rolling && t.term != torsion)
      lines.push_back(fmt::format("{} is needed ({} = {:.3g}) but not modelled{}", t.term, t.number, t.value,
                                  t.term == lift ? "; inertial drag is" : ""));
    if (t.term == "particle inertia" && t.needed)
      lines.push_back(fmt::format("{} = {:.3g}: lower time.mass_scale", t.number, t.value));
    if (t.term == "particle stiffness" && t.needed)
      lines.push_back(
          fmt::format("{} = {:.3g} (too soft below 30): {}", t.number, t.value, overlap_remedy(plan.contact)));
  }
  if (!plan.drag_gap.empty()) lines.push_back(plan.drag_gap);
  if (!plan.law_note.empty()) lines.push_back(plan.law_note);
  lines.insert(lines.end(), plan.drive_warnings.begin(), plan.drive_warnings.end());
  if (!plan.layers_note.empty()) lines.push_back(plan.layers_note);
  if (plan.dt > plan.limits.smallest())
    lines.push_back(
        fmt::format("the step of {:.3g} s is unstable: the limit is {:.3g} s", plan.dt, plan.limits.smallest()));
  for (const std::string& line : {overlap_warning(plan.limits, plan.contact), passing_warning(plan.limits, plan.dt),
                                  impact_warning(plan.limits, plan.dt)})
    if (!line.empty()) lines.push_back(line);
  if (plan.way_limit > 0 && plan.dt > plan.way_limit)
    lines.push_back(
        fmt::format("the step of {:.3g} s is above {:.3g} s, in which the flow moves 0.01 d", plan.dt, plan.way_limit));
  return lines;
}

}  // namespace clogflow
