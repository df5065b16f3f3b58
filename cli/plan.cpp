// clog plan: what a scene needs, the limits of the step, what a run costs.

#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/verbs.hpp"
#include "dem/plan.hpp"
#include "trade/fidelity.hpp"

namespace clog::cli {
namespace {

struct PlanOptions {
  std::filesystem::path scene;
  std::string tolerance;
  Overrides overrides;
};

void print_limit(const char* what, double limit, double dt) {
  if (limit == 0) return;
  if (std::isfinite(limit))
    fmt::print("  {:<34} {:>10.3g} s   dt / limit {:.3g}\n", what, limit, dt / limit);
  else
    fmt::print("  {:<34} {:>10}\n", what, "none");
}

void print_plan(const PlanOptions& options) {
  const auto [scene, fidelity] = trade::read_resolved_scene(options.scene, options.overrides);
  const Plan plan = make_plan(scene);
  if (!fidelity.empty()) fmt::print("{}\n\n", fidelity);
  fmt::print("{:<34} {:<42} {:>10}  {:<7} {:<9} {}\n", "term", "decided by", "value", "needed",
             "modelled", "because");
  for (const PlannedTerm& t : plan.terms)
    fmt::print("{:<34} {:<42} {:>10.3g}  {:<7} {:<9} {}\n", t.term, t.number, t.value,
               t.needed ? "yes" : "no", t.modelled ? "yes" : "no", t.reason);
  fmt::print("\ntime step {:.4g} s\n", plan.dt);
  print_limit("Hertz contact time", plan.limits.contact_time, plan.dt);
  print_limit("Rayleigh time", plan.limits.rayleigh_time, plan.dt);
  print_limit("explicit drag", plan.limits.drag, plan.dt);
  print_limit("lubrication at h = 2 xi", plan.limits.lubrication, plan.dt);
  print_limit("contacts in a pack", plan.limits.contacts, plan.dt);
  print_limit("0.01 d per step in the neck", plan.way_limit, plan.dt);
  fmt::print("\none seed: about {:.0f} particles, {:.3g} steps and {:.3g} to fill the channel, "
             "{:.3g} MB, {:.3g} s on one core at {:.2g} particle-steps/s\n",
             plan.particles, plan.steps, plan.filling_steps, 1e-6 * plan.memory, plan.seconds,
             nominal_rate);
  for (const std::string& line : warnings(plan)) fmt::print("warning: {}\n", line);
}

}  // namespace

void add_plan(CLI::App& app) {
  auto* verb = app.add_subcommand("plan", "what a scene needs and costs");
  auto options = std::make_shared<PlanOptions>();
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("--tolerance", options->tolerance, "as for clog run");
  verb->add_option("--set", options->overrides, "key=value: overrides the scene")->allow_extra_args(false);
  verb->callback([options] {
    if (!options->tolerance.empty())
      options->overrides.push_back("fidelity.tolerance=" + options->tolerance);
    print_plan(*options);
  });
}

}  // namespace clog::cli
