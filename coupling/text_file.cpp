#include "coupling/text_file.hpp"

#include <fstream>
#include <sstream>

#include "coupling/require.hpp"

namespace clog {

std::string read_text_file(const std::filesystem::path& file) {
  require(std::filesystem::is_regular_file(file), "{} is missing", file.string());
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  require(in.good() && text.good(), "cannot read {}", file.string());
  return std::move(text).str();
}

}  // namespace clog
