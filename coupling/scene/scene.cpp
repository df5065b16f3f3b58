// A scene from a file or a text: read, complete, check.
#include "coupling/scene/scene.hpp"

#include <fstream>
#include <iterator>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/scene/particle_sizes.hpp"
#include "coupling/scene/scene_bounds.hpp"
#include "coupling/scene/scene_draft.hpp"

namespace clogflow {
namespace {

Scene finish(SceneDraft draft) {
  fill_defaults(draft);
  check_scene(draft);
  return std::move(draft.scene);
}

// A name in the scene file is taken from its folder; one on the command line from where we are.
void locate(const SceneDraft& draft, const std::filesystem::path& folder,
            std::pair<std::string_view, std::string*> key) {
  auto& [path, file] = key;
  if (file->empty()) return;
  const auto given = draft.given.find(path);
  if (!given->second.where.starts_with("--set ")) *file = (folder / *file).lexically_normal().string();
  std::error_code ignored;  // such as a name that is too long
  require(std::filesystem::is_regular_file(*file, ignored), "{} (there is no file {})", draft.says(path),
          shown_text(*file, 300));
}

// A file of sizes becomes the mixture that it says: what is written of the scene needs the file no more.
void take_sizes(SceneDraft& draft) {
  auto& particles = draft.scene.particles;
  if (particles.size_file.empty()) return;
  const std::vector<Species> read = read_size_file(particles.size_file);
  require(!draft.has("particles.species") || particles.species == read,
          "{} (particles.species says other sizes: leave one out)", draft.says("particles.size_file"));
  particles.species = read;
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, const Overrides& overrides) {
  require(std::filesystem::exists(file), "{} (no such scene file)", file.string());
  // Asked first: to open a pipe waits for its other end.
  require(std::filesystem::is_regular_file(file), "{} (the scene file cannot be read: it is no regular file)",
          file.string());
  // Before it is read into memory.
  require(std::filesystem::file_size(file) <= longest_scene, "{} ({} bytes: a scene has at most {})", file.string(),
          std::filesystem::file_size(file), longest_scene);
  std::ifstream stream(file, std::ios::binary);
  require(stream.good(), "{} (the scene file cannot be read)", file.string());
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  SceneDraft draft = read_draft(text, file.string(), overrides);
  locate(draft, file.parent_path(), {"geometry.stl", &draft.scene.geometry.stl});
  locate(draft, file.parent_path(), {"particles.initial", &draft.scene.particles.initial});
  locate(draft, file.parent_path(), {"flow.oscillation.table", &draft.scene.flow.oscillation.table});
  locate(draft, file.parent_path(), {"particles.size_file", &draft.scene.particles.size_file});
  measure_stl(draft);
  take_sizes(draft);
  return finish(std::move(draft));
}

Scene parse_scene(const std::string& text, const std::string& name, const Overrides& overrides) {
  return finish(read_draft(text, name, overrides));
}

}  // namespace clogflow
