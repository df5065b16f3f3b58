// clog info --json: one object for each kind of file.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "coupling/files/flow_grid.hpp"
#include "coupling/files/run_file.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow::cli {

nlohmann::json info_json(const Scene& scene, const std::string& file, const std::string& flow_hash);
nlohmann::json info_json(const FlowGrid& grid, const std::string& file);
nlohmann::json info_json(const RunData& run, const std::string& file);
nlohmann::json pack_info_json(const std::filesystem::path& pack);

/// The largest speed at a point of the grid [m/s].
double fastest(const FlowGrid& grid);

/// Points in the fluid over all points [-].
double fluid_share(const FlowGrid& grid);

}  // namespace clogflow::cli
