// clog plan: what a scene needs, the limits of the step, what a run costs.

#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/output.hpp"
#include "cli/plan_json.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/in_processes.hpp"
#include "coupling/base/require.hpp"
#include "coupling/files/flow_grid.hpp"
#include "coupling/flow/flow_reach.hpp"
#include "coupling/flow/flow_rescale.hpp"
#include "coupling/scene/sweep.hpp"
#include "dem/plan/machine_speed.hpp"
#include "dem/plan/plan.hpp"
#include "trade/fidelity.hpp"

namespace clogflow::cli {
namespace {

struct PlanOptions {
  std::filesystem::path scene, flow;
  std::string tolerance;
  Overrides overrides;
};

void print_limit(const char* what, double limit, double dt) {
  if (limit == 0) return;
  if (std::isfinite(limit))
    print_words("  {:<34} {:>10.3g} s   dt / limit {:.3g}\n", what, limit, dt / limit);
  else
    print_words("  {:<34} {:>10}\n", what, "none");
}

std::string share_of(const PlannedTerm& term) {
  return term.share > 0 ? fmt::format("{:.0f} %", 100 * term.share) : "";
}

/// What only the flow file of --flow can tell.
void look_into_flow(const Scene& scene, const Plan& plan, PlanFindings& found) {
  const std::string& file = found.flow_file;
  require(file.empty() || scene.flow.source == FlowSource::openfoam,
          "flow.source is not \"openfoam\", so {} would not be used: leave out --flow", file);
  if (file.empty() || plan.grid_reach == 0) return;
  const FlowGrid flow = read_flow_grid(file);
  check_flow_belongs(scene, flow);
  found.measured_reach = measured_reach(flow, scene, reach_tolerance);
  found.flow_drop = channel_pressure_drop(flow, scene);
}

void print_flow(const Scene& scene, const Plan& plan, const PlanFindings& found) {
  if (plan.grid_reach == 0) return;
  print_words(
      "\nflow: from {:.3g} m upstream of the narrowing the developed duct profile is exact to {:.2g} % of the "
      "mean velocity (expected)\n",
      plan.grid_reach, 100 * reach_tolerance);
  if (!found.flow_file.empty()) print_words("      in {}: from {:.3g} m\n", found.flow_file, found.measured_reach);
  if (found.flow_drop)
    print_words("      pressure drop from the inlet of this scene's channel: {:.4g} Pa\n", *found.flow_drop);
  const bool known = neck_reynolds_number(scene) <= largest_reynolds_number;
  print_words("      a creeping flow scaled to this rate is wrong by {:.2g} % of the neck's mean velocity{}\n",
              100 * plan.scaling_error, known ? "" : ", extrapolated: such a flow is not scaled");
}

std::string in_words(double seconds) {
  if (seconds < 120) return fmt::format("{:.2g} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

void print_burst(const Scene& scene, const Plan& plan, double speed) {
  if (!scene.inlet.enabled) return;
  const ExpectedBurst& burst = plan.burst;
  if (!burst.unknown.empty()) return print_result("cost of a burst: not known ({})\n", burst.unknown);
  const double each = plan.burst_instructions / speed;
  print_result(
      "one burst: <s> about {:.3g}, {:.3g} s simulated ({:.2g} without friction, {:.2g} until the clog, {:.2g} until "
      "it "
      "is proved), {:.2g} particle-steps, {:.2g} s on one core (docs/reports/friction.md)\n",
      burst.mean, burst.simulated(), burst.start, burst.flow, burst.proof, plan.burst_steps, each);
  const auto cores = static_cast<double>(usable_cores());
  for (const double share : planned_precisions) {
    const double bursts = bursts_for(burst.spread, share);
    print_result("  <s> within {:.0f} %: {:.0f} bursts{}, {} on {:.0f} cores\n", 100 * share, bursts,
                 burst.spread_seen ? "" : " at most", in_words(bursts * each / cores), cores);
  }
}

std::string bytes_in_words(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.0f} kB", 1e-3 * bytes);
  return bytes < 1e9 ? fmt::format("{:.3g} MB", 1e-6 * bytes) : fmt::format("{:.3g} GB", 1e-9 * bytes);
}

void print_disk(const Plan& plan, double runs) {
  const DiskUse& disk = plan.disk;
  const char* bound = disk.is_at_most ? "at most " : "";
  print_result(
      "disk: {}{} a run ({:.0f} snapshots {}, series {}, passages {}), {}{} for {:.0f} runs; {} beside while a "
      "run is at work\n",
      bound, bytes_in_words(disk.run()), disk.snapshot_count, bytes_in_words(disk.snapshots),
      bytes_in_words(disk.series), bytes_in_words(disk.passages), bound, bytes_in_words(disk.run() * runs), runs,
      bytes_in_words(disk.at_work()));
}

void print_plan(const Scene& scene, const Plan& plan, const PlanFindings& found) {
  if (!found.fidelity.empty()) print_words("{}\n\n", found.fidelity);
  print_words("{:<34} {:<42} {:>10}  {:<7} {:<9} {:<5} {}\n", "term", "decided by", "value", "needed", "modelled",
              "cost", "because");
  for (const PlannedTerm& t : plan.terms)
    print_words("{:<34} {:<42} {:>10.3g}  {:<7} {:<9} {:<5} {}\n", t.term, t.number, t.value, t.needed ? "yes" : "no",
                t.modelled ? "yes" : "no", share_of(t), t.reason);
  if (!plan.sizes_note.empty()) print_words("\n{}\n", plan.sizes_note);
  if (!plan.drag_note.empty()) print_words("\n{}\n", plan.drag_note);
  for (const std::string& note : plan.drive_notes) print_words("drive: {}\n", note);
  print_result("\ntime step {:.4g} s\n", plan.dt);
  print_limit(plan.limits.linear ? "contact time" : "Hertz contact time", plan.limits.contact_time, plan.dt);
  print_limit("Rayleigh time", plan.limits.rayleigh_time, plan.dt);
  print_limit("explicit drag", plan.limits.drag, plan.dt);
  print_limit("lubrication at h = 2 xi", plan.limits.lubrication, plan.dt);
  print_limit("contacts in a pack", plan.limits.contacts, plan.dt);
  print_limit("0.01 d per step in the neck", plan.way_limit, plan.dt);
  print_flow(scene, plan, found);
  const double speed = found.speed;
  print_result(
      "\none seed: about {:.0f} particles, {:.3g} steps and {:.3g} to fill the channel, {:.3g} MB, {:.3g} s on "
      "one core of this machine ({:.2g} particle-steps/s, tried out now)\n",
      plan.particles, plan.steps, plan.filling_steps, 1e-6 * plan.memory, plan.seconds(speed),
      (plan.steps + plan.filling_steps) * plan.particles / plan.seconds(speed));
  print_burst(scene, plan, speed);
  print_disk(plan, found.runs);
  for (const std::string& line : warnings(plan)) print_warning(line);
}

void tell_plan(const PlanOptions& options) {
  const auto [scene, fidelity] = trade::read_resolved_scene(options.scene, options.overrides);
  const Plan plan = make_plan(scene);
  PlanFindings found{.file = options.scene.string(), .fidelity = fidelity, .flow_file = options.flow.string()};
  look_into_flow(scene, plan, found);
  constexpr double trial = 0.3;  // s
  found.speed = instructions_per_second(trial);
  found.runs = static_cast<double>(scene.ensemble.seeds.size() * sweep_points(scene.ensemble.sweep).size());
  if (json_wanted()) return print_json(plan_json(scene, plan, found));
  print_plan(scene, plan, found);
}

}  // namespace

void add_plan(CLI::App& app) {
  auto* verb = app.add_subcommand("plan", "what a scene needs and costs");
  auto options = std::make_shared<PlanOptions>();
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("--flow", options->flow, "flow.h5 of the scene: how far the neck is felt in it");
  verb->add_option("--tolerance", options->tolerance, "as for clog run");
  verb->add_option("--set", options->overrides, "key=value: overrides the scene")->allow_extra_args(false);
  verb->callback([options] {
    if (!options->tolerance.empty()) options->overrides.push_back("fidelity.tolerance=" + options->tolerance);
    tell_plan(*options);
  });
}

}  // namespace clogflow::cli
