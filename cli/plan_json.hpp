// clog plan --json.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "dem/plan/plan.hpp"

namespace clogflow::cli {

/// What the table and the lines of `clog plan` say, and what was found out for them.
struct PlanFindings {
  std::string file;  ///< of the scene
  std::string fidelity;
  double speed = 0;                      ///< of this machine [instructions/s]
  double runs = 0;                       ///< seeds times points of a sweep [-]
  std::string flow_file;                 ///< of --flow, or empty
  double measured_reach = 0;             ///< in it [m]
  std::optional<double> flow_drop = {};  ///< over the scene's channel in it [Pa]
};

nlohmann::json plan_json(const Scene& scene, const Plan& plan, const PlanFindings& found);

}  // namespace clogflow::cli
