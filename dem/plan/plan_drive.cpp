#include "dem/plan/plan_drive.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "coupling/geometry/channel_shape.hpp"
#include "dem/physics/dimensionless.hpp"

namespace clogflow {

namespace {

double value_of(const Plan& plan, std::string_view term) {
  const auto found = std::ranges::find(plan.terms, term, &PlannedTerm::term);
  return found == plan.terms.end() ? 0 : found->value;
}

/// Softness and inertia are what lets the speed of a drive that never goes back decide who passes.
void judge_invariance(const Model& model, Plan& plan) {
  const double fastest = model.factors.fastest, load = model.factors.load;
  const double stokes = fastest * value_of(plan, "particle inertia");
  const double kappa = value_of(plan, "particle stiffness") / std::pow(load, 2.0 / 3);
  plan.drive_notes.push_back(fmt::format(
      "a drive that never goes back cannot change which particles pass and clog where these are rigid and without "
      "inertia: it only relabels time; at its largest, {:.3g} times the mean flow, St = {:.2g} and kappa = {:.3g}",
      fastest, stokes, kappa));
  if (stokes > largest_inertia)
    plan.drive_warnings.push_back(fmt::format(
        "St = {:.2g} at the drive's largest: scaled mass would pretend that the drive matters: lower time.mass_scale",
        stokes));
  if (kappa > 0 && kappa < softest)
    plan.drive_warnings.push_back(
        fmt::format("kappa = {:.3g} at the drive's largest load: softness would pretend that the drive matters: {}",
                    kappa, overlap_remedy(plan.contact)));
}

/// What the pressures are, before anything was solved.
void judge_pressures(const Scene& s, const FlowFactors& factors, Plan& plan) {
  const auto drops = expected_drops(s, nullptr);
  if (!drops) return;
  plan.terms.push_back({"balance of pressures", "a pack's resistance over the channel's", drops->pack / drops->channel,
                        drops->pack > 0.1 * drops->channel, true, "a clog slows the flow, a burst speeds it up"});
  plan.drive_notes.push_back(fmt::format(
      "the mean flow takes about {:.3g} Pa through the empty channel, {:.3g} Pa more through a pack at rest "
      "that fills it (estimates: the flow file tells the first)",
      drops->channel, drops->pack));
  // As if the channel's resistance alone had to move it: dem/fluid/pressure_balance.hpp.
  const double together = (1 + drops->pack / drops->channel) * value_of(plan, "particle inertia");
  plan.drive_notes.push_back(fmt::format(
      "a pack responds to a change of pressure in (1 + pack / channel) m/c = {:.2g} Stokes times", together));
  if (together > largest_inertia)
    plan.drive_warnings.push_back(fmt::format(
        "a pack responds to a change of pressure in {:.2g} Stokes times (more than {}: its scaled mass would "
        "matter): lower time.mass_scale",
        together, largest_inertia));
  const double resistance = (drops->channel + drops->pack) / channel_flow_rate(s.geometry, s.flow.mean_velocity);
  if (s.flow.compliance > 0)
    plan.drive_notes.push_back(fmt::format(
        "flow.compliance relaxes in C (Delta p0 + pack) / Q0 = {:.3g} s, {:.3g} Stokes times, in a clog, where the "
        "pressure rises to what drives the mean flow through the pack",
        s.flow.compliance * resistance, s.flow.compliance * resistance / s.stokes_time()));
  else
    plan.drive_notes.emplace_back(
        fmt::format("flow.pressure_drop drives about {:.3g} times the mean flow through the pack at rest, {:.3g} times "
                    "through the empty channel",
                    factors.load, factors.fastest));
}

}  // namespace

void judge_drive(const Scene& s, const Model& model, Plan& plan) {
  const Oscillation oscillation(s);
  if (s.flow.balances()) judge_pressures(s, model.factors, plan);
  if (!oscillation.on() && !s.flow.balances()) return;
  if (oscillation.on() && s.geometry.present && s.fluid.density > 0) {
    const double height = s.geometry.neck_height;
    const double number = womersley_number({s.fluid.density, s.fluid.viscosity}, oscillation.frequency(), height);
    plan.terms.push_back({"inertia of an unsteady flow", "(H/2) sqrt(2 pi f rho / eta), Womersley", number, number > 1,
                          false,
                          fmt::format("below 1 the flow keeps its shape: up to {:.3g} Hz here",
                                      quasi_steady_until({s.fluid.density, s.fluid.viscosity}, height))});
  }
  if (oscillation.reverses())
    plan.drive_notes.emplace_back(
        "the flow goes back: particles behind the neck come back with it, and a screen at the inlet, which the liquid "
        "passes, holds the others; a passage counts anew once its particle was a radius before the plane again");
  else
    judge_invariance(model, plan);
}

}  // namespace clogflow
