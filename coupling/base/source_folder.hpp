// Where the program's own data files stand: the template of the OpenFOAM case, figure scripts.
#pragma once

#include <filesystem>

namespace clogflow {

/// `share/clogflow` beside the `bin` of an installed program (or where CMAKE_INSTALL_DATADIR has it), wherever both
/// were moved to; otherwise the top folder of the sources that this program was built from.
std::filesystem::path source_folder();

}  // namespace clogflow
