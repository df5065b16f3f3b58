// The only file that is compiled with the path of the sources, so that builds in other folders can
// share the compiled form of all others.
#include "coupling/base/source_folder.hpp"

namespace clogflow {

std::filesystem::path source_folder() { return CLOG_SOURCE_DIR; }

}  // namespace clogflow
