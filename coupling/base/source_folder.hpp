// Where the program's own data files stand: the template of the OpenFOAM case, figure scripts, scenes.
#pragma once

#include <filesystem>

namespace clogflow {

/// The top folder of the sources that this program was built from.
std::filesystem::path source_folder();

}  // namespace clogflow
