// The walls of a scene, where particles may be and where they leave.
#pragma once

#include "dem/run/model.hpp"

namespace clogflow {

/// Whether the scene has a channel, of keys or of a file.
bool is_channel(const Scene& scene);

/// Walls of the scene's channel, open at both ends: those of the flow file if a file gave them.
/// \param note  what a file's walls are worth a word for is put there
Walls open_channel(const Scene& scene, const FlowGrid* flow, std::string& note);

/// Walls and limits: the box of a laboratory, the file's walls, or the channel (of keys or of a file) with a
/// closed left end, so that no particle leaves against the flow.
/// \throws Error for walls that cannot be those of the scene
void build_walls(Model& model, const FlowGrid* flow);

}  // namespace clogflow
