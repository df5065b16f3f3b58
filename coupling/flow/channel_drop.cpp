#include "coupling/flow/channel_drop.hpp"

#include "coupling/base/require.hpp"
#include "coupling/flow/flow_reach.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/geometry/duct_flow.hpp"
#include "coupling/geometry/stl_channel.hpp"

namespace clogflow {

namespace {

/// Pieces along the channel.
constexpr int pieces = 400;

}  // namespace

double solved_pressure_drop(const FlowGrid& flow, const Scene& scene) {
  const auto drop = is_stl_channel(scene.geometry) ? flow.record.pressure_drop : channel_pressure_drop(flow, scene);
  require(drop && *drop > 0,
          "{} (needs the pressure drop of the empty channel, which the flow file does not tell): make it anew with "
          "clog map",
          scene.flow.compliance > 0 ? "flow.compliance" : "flow.drive = \"pressure\"");
  return *drop;
}

std::optional<double> estimated_pressure_drop(const Scene& scene) {
  const auto& g = scene.geometry;
  if (!g.present || !g.stl.empty()) return std::nullopt;
  const ChannelShape shape = channel_shape(g);
  const double rate = scene.flow.mean_velocity * g.channel_width, step = (shape.end() - shape.start()) / pieces;
  double drop = 0;
  for (int k = 0; k < pieces; ++k) {
    const double width = shape.width(shape.start() + (k + 0.5) * step);
    drop += scene.fluid.viscosity * rate / width * DuctFlow(width, g.neck_height).resistance() * step;
  }
  return drop;
}

}  // namespace clogflow
