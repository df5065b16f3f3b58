// The second, coarser case inside a flow case, which tells the error of the first.
#pragma once

#include <filesystem>

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Cells of the coarser mesh are longer by this.
inline constexpr double coarsening = 2;

/// The scene of the coarser solution: half as many cells along each edge.
/// \throws Error when that leaves fewer cells than a mesh needs
Scene coarser_scene(const Scene& scene);

/// Folder of the coarser case inside the case of a flow.
std::filesystem::path coarser_folder(const std::filesystem::path& folder);

}  // namespace clogflow
