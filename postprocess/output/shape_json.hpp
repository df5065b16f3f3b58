// The channel of a scene for those who draw it: measures, outline, walls.
#pragma once

#include <nlohmann/json.hpp>

#include "coupling/scene/scene.hpp"

namespace clogflow::postprocess {

/// \return measures of the channel; `upper` and `lower`, the outline of a channel of keys; of one from a file `fluid`,
/// its cut half way up, and `walls`, nine numbers a triangle, to 0.1 nm. `present` is false where there is no channel.
/// A file of more than `most_drawn_triangles` has no `walls`: a drawing would be too large.
nlohmann::json shape_json(const Scene& scene);

inline constexpr std::size_t most_drawn_triangles = 20000;

}  // namespace clogflow::postprocess
