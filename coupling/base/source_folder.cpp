// The only file that is compiled with the path of the sources, so that builds in other folders can
// share the compiled form of all others.
#include "coupling/base/source_folder.hpp"

namespace clogflow {

std::filesystem::path source_folder() {
  std::error_code none;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", none);
  const auto installed = (program.parent_path() / CLOG_DATA_FROM_PROGRAM).lexically_normal();
  return !none && std::filesystem::is_directory(installed, none) ? installed : CLOG_SOURCE_DIR;
}

}  // namespace clogflow
