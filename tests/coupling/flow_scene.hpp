// A small scene with an OpenFOAM flow.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "coupling/base/source_folder.hpp"
#include "coupling/scene/scene.hpp"
#include "tests/scratch.hpp"

namespace clogflow {

inline Scene flow_scene(const Overrides& overrides = {}) {
  return parse_scene(R"(
[geometry]
neck_width = "100 um"
half_angle = "60 deg"
[fluid]
viscosity = "1.8e-3 Pa s"
density = "1062 kg/m3"
[flow]
source = "openfoam"
mean_velocity = "5 mm/s"
mesh_cells_per_neck = 12
grid_spacing = "5 um"
[particles]
diameter = "33 um"
[contact]
youngs_modulus = "3 MPa"
poisson_ratio = 0.35
[time]
end = "1 s"
[ensemble]
seeds = "1"
)",
                     "flow scene", overrides);
}

inline void write_file(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

inline std::filesystem::path foam_template() { return source_folder() / "foam_case"; }

}  // namespace clogflow
