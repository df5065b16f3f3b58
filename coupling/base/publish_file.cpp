#include "coupling/base/publish_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "coupling/base/file_part.hpp"
#include "coupling/base/require.hpp"

namespace clogflow {

void publish_file(const std::string& content, const std::filesystem::path& file, NamedWhen named) {
  FilePart part(file);
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t written = ::write(part.descriptor(), content.data() + done, content.size() - done);
    require(written >= 0 || errno == EINTR, "{} (cannot be written: {})", file.string(),
            std::error_code(errno, std::generic_category()).message());
    if (written > 0) done += static_cast<std::size_t>(written);
  }
  part.publish(named);
}

}  // namespace clogflow
