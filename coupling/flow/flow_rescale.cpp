#include "coupling/flow/flow_rescale.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include "coupling/base/require.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/scene/readable_scene.hpp"

namespace clogflow {
namespace {

// Refuses where two lists of flow inputs differ.
void require_same(const std::string& of_file, const std::string& of_scene) {
  std::istringstream a(of_file), b(of_scene);
  std::string line_a, line_b;
  while (true) {
    const bool more_a = static_cast<bool>(std::getline(a, line_a));
    const bool more_b = static_cast<bool>(std::getline(b, line_b));
    if (!more_a && !more_b) return;
    require(more_a && more_b && line_a == line_b,
            "the flow file belongs to another scene ({}, this scene has {}): make it anew with clog "
            "case and clog map",
            readable_scene(more_a ? line_a : "nothing more"), readable_scene(more_b ? line_b : "nothing more"));
  }
}

// What the scaling may change.
std::string without_rate(const std::string& inputs) {
  std::istringstream in(inputs);
  std::string kept;
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with("fluid.") && !line.starts_with("flow.mean_velocity")) kept += line + "\n";
  return kept;
}

Scene scene_of(const FlowGrid& flow) { return parse_scene(flow.scene_text, "the scene in flow.h5"); }

}  // namespace

double neck_reynolds_number(const Scene& scene) {
  return scene.fluid.density * neck_mean_velocity(scene.geometry, scene.flow.mean_velocity) *
         scene.geometry.neck_width / scene.fluid.viscosity;
}

RescaledFlow rescaled_flow(FlowGrid grid, const Scene& scene) {
  const Scene solved = scene_of(grid);
  require_same(without_rate(flow_inputs(solved)), without_rate(flow_inputs(scene)));
  const double from = neck_reynolds_number(solved), to = neck_reynolds_number(scene);
  for (const double number : {from, to})
    require(number <= largest_reynolds_number,
            "flow.rescale = true (the neck's Reynolds number is {:.3g}, and the error of scaling is "
            "known up to {} only): leave it out and solve this flow",
            number, largest_reynolds_number);
  RescaledFlow result{.grid = std::move(grid),
                      .factor = scene.flow.mean_velocity / solved.flow.mean_velocity,
                      .error = error_per_reynolds_number * std::abs(to - from)};
  for (float& component : result.grid.velocity) component = static_cast<float>(component * result.factor);
  // Of creeping flow, which it is scaled as.
  if (auto& drop = result.grid.record.pressure_drop)
    *drop *= result.factor * (scene.fluid.viscosity / solved.fluid.viscosity);
  result.grid.record.rescaled = {.from = result.grid.hash, .factor = result.factor, .error = result.error};
  result.grid.scene_text = effective_scene(scene);
  result.grid.hash = content_hash(flow_inputs(scene));
  return result;
}

void check_flow_belongs(const Scene& scene, const FlowGrid& flow) {
  const std::string wanted = flow_inputs(scene);
  if (flow.hash == content_hash(wanted)) return;
  // Made by a version that named flows otherwise, it may still be that of the scene.
  require_same(flow_inputs(scene_of(flow)), wanted);
}

}  // namespace clogflow
