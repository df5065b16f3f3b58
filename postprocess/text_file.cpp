// Writes beside, flushes, renames.
#include "postprocess/text_file.hpp"

#include <fstream>

#include "coupling/require.hpp"

namespace clog::postprocess {

void write_text_file(const std::string& text, const std::filesystem::path& file) {
  const std::filesystem::path beside = file.string() + ".part";
  std::ofstream out(beside, std::ios::binary);
  out << text;
  out.close();
  require(!out.fail(), "{}: cannot be written", beside.string());
  std::error_code status;
  std::filesystem::rename(beside, file, status);
  require(!status, "{}: cannot be renamed from {} ({})", file.string(), beside.string(),
          status.message());
}

}  // namespace clog::postprocess
