#include "coupling/base/text_file.hpp"

#include <fstream>
#include <sstream>

#include "coupling/base/require.hpp"

namespace clogflow {

std::string read_text_file(const std::filesystem::path& file) {
  require(std::filesystem::is_regular_file(file), "{} is missing", file.string());
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  // An empty file is no failure, but inserting no character counts as one.
  if (in.good() && in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  require(!in.bad() && in.is_open() && text.good(), "cannot read {}", file.string());
  return std::move(text).str();
}

}  // namespace clogflow
