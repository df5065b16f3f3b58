#include "cli/plan_json.hpp"

#include <nlohmann/json.hpp>

#include "cli/json_parts.hpp"
#include "coupling/base/in_processes.hpp"
#include "coupling/flow/flow_reach.hpp"

namespace clogflow::cli {
namespace {

using nlohmann::json;

json text_or_null(const std::string& text) { return text.empty() ? json() : json(text); }

json terms_json(const Plan& plan) {
  json terms = json::array();
  for (const PlannedTerm& t : plan.terms)
    terms.push_back({{"term", t.term},
                     {"number", t.number},
                     {"value", number_or_null(t.value)},
                     {"needed", t.needed},
                     {"modelled", t.modelled},
                     {"cost_share", t.share},
                     {"reason", t.reason}});
  return terms;
}

/// null: no such limit
json limit(double seconds) { return seconds > 0 ? number_or_null(seconds) : json(); }

json limits_json(const Plan& plan) {
  return {{"contact_time_s", limit(plan.limits.contact_time)},   {"rayleigh_time_s", limit(plan.limits.rayleigh_time)},
          {"explicit_drag_s", limit(plan.limits.drag)},          {"lubrication_s", limit(plan.limits.lubrication)},
          {"contacts_in_a_pack_s", limit(plan.limits.contacts)}, {"way_in_the_neck_s", limit(plan.way_limit)}};
}

json burst_json(const Plan& plan, double speed) {
  const ExpectedBurst& burst = plan.burst;
  if (!burst.unknown.empty()) return {{"unknown", burst.unknown}};
  const double each = plan.burst_instructions / speed;
  const auto cores = static_cast<double>(usable_cores());
  json precision = json::array();
  for (const double share : planned_precisions) {
    const double bursts = bursts_for(burst.spread, share);
    precision.push_back({{"relative_error", share}, {"bursts", bursts}, {"wall_time_s", bursts * each / cores}});
  }
  return {{"unknown", nullptr},
          {"mean_passages", burst.mean},
          {"simulated_s", burst.simulated()},
          {"start_s", burst.start},
          {"flow_s", burst.flow},
          {"proof_s", burst.proof},
          {"core_time_s", each},
          {"particle_steps", plan.burst_steps},
          {"cores", cores},
          {"precision", precision}};
}

json flow_json(const Plan& plan, const PlanFindings& found) {
  if (plan.grid_reach == 0) return nullptr;
  json flow{{"expected_reach_m", plan.grid_reach},
            {"reach_tolerance", reach_tolerance},
            {"scaling_error", plan.scaling_error},
            {"file", text_or_null(found.flow_file)}};
  if (!found.flow_file.empty()) {
    flow["measured_reach_m"] = found.measured_reach;
    flow["pressure_drop_Pa"] = found.flow_drop ? json(*found.flow_drop) : json();
  }
  return flow;
}

}  // namespace

json plan_json(const Scene& scene, const Plan& plan, const PlanFindings& found) {
  json all = json_head("plan");
  json notes = json::array();
  for (const std::string& note : {plan.sizes_note, plan.drag_note})
    if (!note.empty()) notes.push_back(note);
  for (const std::string& note : plan.drive_notes) notes.push_back(note);
  const double seconds = plan.seconds(found.speed);
  all.update({{"scene_file", found.file},
              {"scene", scene_json(effective_scene(scene))},
              {"fidelity", text_or_null(found.fidelity)},
              {"terms", terms_json(plan)},
              {"notes", notes},
              {"warnings", warnings(plan)},
              {"time_step_s", plan.dt},
              {"limits", limits_json(plan)},
              {"flow", flow_json(plan, found)},
              {"seed",
               {{"particles", plan.particles},
                {"steps", plan.steps},
                {"filling_steps", plan.filling_steps},
                {"memory_bytes", plan.memory},
                {"core_time_s", seconds},
                {"particle_steps_per_s", (plan.steps + plan.filling_steps) * plan.particles / seconds}}},
              {"burst", scene.inlet.enabled ? burst_json(plan, found.speed) : json()},
              {"disk",
               {{"run_bytes", plan.disk.run()},
                {"runs", found.runs},
                {"ensemble_bytes", plan.disk.run() * found.runs},
                {"at_work_bytes", plan.disk.at_work()},
                {"snapshots", plan.disk.snapshot_count},
                {"at_most", plan.disk.is_at_most}}}});
  return all;
}

}  // namespace clogflow::cli
