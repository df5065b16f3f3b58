// What a plan says of a flow that is not steady.
#pragma once

#include "dem/plan/plan.hpp"
#include "dem/run/model.hpp"

namespace clogflow {

/// Adds the Womersley number, and what the drive can and cannot change; nothing for a steady flow. After the other
/// terms.
void judge_drive(const Scene& scene, const Model& model, Plan& plan);

}  // namespace clogflow
