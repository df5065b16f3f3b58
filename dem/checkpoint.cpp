#include "dem/checkpoint.hpp"

#include <cstring>

#include "coupling/content_hash.hpp"
#include "coupling/file_part.hpp"
#include "coupling/publish_file.hpp"
#include "coupling/require.hpp"
#include "coupling/text_file.hpp"

namespace clog {

namespace {

constexpr char version[] = "clogflow state 2\n";
constexpr std::size_t version_size = sizeof version - 1, hash_size = 16;

/// What is wrong with a file's content, or an empty text.
std::string fault(const std::string& content, const std::string& identity) {
  if (content.size() < version_size + 2 * hash_size) return "it is cut short";
  if (content.compare(0, version_size, version) != 0) return "it is of another version";
  if (content.compare(version_size + hash_size, hash_size,
                      content_hash(content.substr(version_size + 2 * hash_size))) != 0)
    return "its checksum does not fit (torn or damaged)";
  if (content.compare(version_size, hash_size, content_hash(identity)) != 0)
    return "it belongs to another scene, flow, program or kind of processor";
  return "";
}

}  // namespace

Checkpoint::Checkpoint(const std::filesystem::path& run_file, std::string identity)
    : newest_(run_file), older_(run_file), identity_(std::move(identity)) {
  newest_.replace_extension(".state");
  older_.replace_extension(".state.old");
}

void Checkpoint::save(const std::string& state) {
  std::error_code ignored;
  if (newest_is_good_) std::filesystem::rename(newest_, older_, ignored);
  newest_is_good_ = false;
  publish_file(version + content_hash(identity_) + content_hash(state) + state, newest_);
  newest_is_good_ = true;
}

bool Checkpoint::load(const std::function<void(const std::string&)>& take,
                      const std::function<void(const std::string&)>& say) {
  bool passed_over = false;
  std::error_code ignored;
  for (const auto& file : {newest_, older_}) {
    if (!std::filesystem::exists(file, ignored)) continue;
    try {
      const std::string content = read_text_file(file);
      const std::string problem = fault(content, identity_);
      require(problem.empty(), "{}", problem);
      take(content.substr(version_size + 2 * hash_size));
      newest_is_good_ = file == newest_;
      if (passed_over) say(fmt::format("goes on from {}", file.string()));
      return true;
    } catch (const std::exception& error) {
      say(fmt::format("{} is not used: {}", file.string(), error.what()));
      passed_over = true;
    }
  }
  if (passed_over) say("starts anew");
  return false;
}

void Checkpoint::remove() {
  std::error_code ignored;
  std::filesystem::remove(newest_, ignored);
  std::filesystem::remove(older_, ignored);
  // Of a process that was killed while it wrote.
  clear_remainders(newest_);
}

}  // namespace clog
