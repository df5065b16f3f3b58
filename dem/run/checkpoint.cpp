#include "dem/run/checkpoint.hpp"

#include "coupling/base/archive.hpp"
#include "coupling/base/content_hash.hpp"
#include "coupling/base/file_part.hpp"
#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/scene/scene_difference.hpp"

namespace clogflow {

namespace {

constexpr std::string_view any_version = "clogflow state ", version = "clogflow state 8\n";
constexpr std::size_t hash_size = 16;

[[noreturn]] void refuse(const std::string& why) { throw StateRefused(why); }

}  // namespace

void check_may_go_on(const StateOwner& theirs, const StateOwner& ours) {
  constexpr auto remedy = "give another --out, or remove it to start anew";
  if (theirs.seed != ours.seed) refuse(fmt::format("belongs to seed {}: {}", theirs.seed, remedy));
  if (const auto difference = find_role(scene_differences(theirs.scene_text, ours.scene_text), KeyRole::trajectory))
    refuse(fmt::format("belongs to another scene ({}): {}", difference->words(), remedy));
  if (theirs.inputs != ours.inputs)
    refuse(fmt::format("was made with another flow, or other files of particles or walls: {}", remedy));
  if (theirs.build != ours.build)
    refuse(fmt::format("was made by another build of the program ({}; this is {}): go on with that one, {}",
                       theirs.build, ours.build, remedy));
  if (theirs.instruction_set != ours.instruction_set)
    refuse(fmt::format("was made with the instruction set {} (here {} is chosen): set CLOG_ISA={}, {}",
                       theirs.instruction_set, ours.instruction_set, theirs.instruction_set, remedy));
}

std::string pack_state(OwnedState owned) {
  ArchiveWriter archive;
  archive(owned.owner, owned.state);
  return std::string(version) + content_hash(archive.bytes()) + archive.bytes();
}

OwnedState unpack_state(const std::string& content) {
  if (content.starts_with(any_version) && !content.starts_with(version) && content.size() > any_version.size() &&
      content[any_version.size()] >= '0' && content[any_version.size()] <= '9')
    refuse(
        "was made by another version of the program: go on with that one, give another --out, or "
        "remove it to start anew");
  require(content.size() >= version.size() + hash_size, "it is cut short");
  require(content.starts_with(version), "it is no saved state, or damaged");
  const std::string bytes = content.substr(version.size() + hash_size);
  require(content.compare(version.size(), hash_size, content_hash(bytes)) == 0,
          "its checksum does not fit (torn or damaged)");
  OwnedState owned;
  ArchiveReader archive(bytes);
  archive(owned.owner, owned.state);
  return owned;
}

Checkpoint::Checkpoint(const std::filesystem::path& run_file, StateOwner owner)
    : newest_(run_file), older_(run_file), owner_(std::move(owner)) {
  newest_.replace_extension(".state");
  older_.replace_extension(".state.old");
}

void Checkpoint::save(const std::string& state) {
  std::error_code ignored;
  if (newest_is_good_) std::filesystem::rename(newest_, older_, ignored);
  newest_is_good_ = false;
  publish_file(pack_state({owner_, state}), newest_, NamedWhen::written);
  newest_is_good_ = true;
}

std::filesystem::path Checkpoint::load(const std::function<void(const std::string&)>& take,
                                       const std::function<void(const std::string&)>& say) {
  bool passed_over = false;
  std::error_code ignored;
  for (const auto& file : {newest_, older_}) {
    if (!std::filesystem::exists(file, ignored)) continue;
    try {
      const OwnedState found = unpack_state(read_text_file(file));
      check_may_go_on(found.owner, owner_);
      take(found.state);
      newest_is_good_ = file == newest_;
      return file;
    } catch (const StateRefused& refused) {
      refuse(fmt::format("{} {}", file.string(), refused.what()));
    } catch (const std::exception& error) {
      say(fmt::format("{} is not used: {}", file.string(), error.what()));
      passed_over = true;
    }
  }
  if (passed_over) say("no saved state is left to go on from, starts anew");
  return {};
}

bool Checkpoint::is_there() const {
  std::error_code ignored;
  return std::filesystem::exists(newest_, ignored) || std::filesystem::exists(older_, ignored);
}

void Checkpoint::remove() {
  std::error_code ignored;
  std::filesystem::remove(newest_, ignored);
  std::filesystem::remove(older_, ignored);
  // Of a process that was killed while it wrote.
  clear_remainders(newest_);
}

}  // namespace clogflow
