#include "coupling/openfoam/foam_case_writer.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "coupling/base/case_lock.hpp"
#include "coupling/base/content_hash.hpp"
#include "coupling/base/file_part.hpp"
#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/openfoam/coarser_case.hpp"
#include "coupling/openfoam/foam_dictionaries.hpp"
#include "coupling/openfoam/foam_mesh.hpp"
#include "coupling/openfoam/snappy_mesh.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

constexpr const char* stl_copy = "geometry.stl";

/// In the place of a hash while a case is being written: such a folder is ours, and nothing solves
/// it.
constexpr const char* unfinished = "unfinished\n";

bool is_time_folder(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.find_first_not_of("0123456789.") == std::string::npos;
}

// Without `solved` and with an unfinished hash nobody trusts what a kill in the middle of this
// leaves.
void remove_results(const fs::path& folder) {
  fs::remove(folder / "solved");
  publish_file(unfinished, folder / "hash");
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto name = entry.path().filename().string();
    if (name == "postProcessing" || name == "fluxes" || name == "pressure" || name == "coarse" ||
        name.starts_with("log.") || is_time_folder(entry.path())) {
      fs::remove_all(entry.path());
    }
  }
  for (const char* name : {"polyMesh", "triSurface", "extendedFeatureEdgeMesh"})
    fs::remove_all(folder / "constant" / name);
  fs::remove(folder / stl_copy);
  fs::remove(folder / "meshUnit");
}

using Files = std::map<std::string, std::string>;

Files files_of_template(const fs::path& template_folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(template_folder)) {
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), template_folder).string()] = read_text_file(entry.path());
  }
  return files;
}

// All that OpenFOAM will read, as text in a fixed order: a changed template or mesh is another
// case.
std::string everything(const Files& files) {
  std::string text;
  for (const auto& [name, content] : files) text += name + "\n" + content;
  return text;
}

// Refuses a folder that is neither empty nor a flow case: its files would be mixed with ours.
void refuse_foreign_folder(const fs::path& folder) {
  if (!fs::exists(folder)) return;
  require(fs::is_directory(folder), "{} is a file (a case needs a folder); name another", folder.string());
  // What a call that was killed in its first moment left.
  clear_remainders(folder / "hash");
  const bool foreign = std::ranges::any_of(fs::directory_iterator(folder),
                                           [](const auto& entry) { return entry.path().filename() != "lock"; });
  require(!foreign || fs::exists(folder / "hash"),
          "{} is not empty and not a flow case (it has no file `hash`); name another folder", folder.string());
}

Files structured(const Scene& scene) {
  const FlowMesh mesh = flow_mesh(scene);
  const std::vector<std::string> names = station_names(mesh);
  return {{"system/sceneDict", scene_dictionary(scene, flow_lattice(scene, mesh), {})},
          {"system/blockMeshDict", block_mesh_dictionary(mesh, scene.geometry.neck_height / 2)},
          {"system/topoSetDict", surfaces_dictionary(mesh)},
          {"system/fluxDict", flux_dictionary(names)},
          {"surfaces", surface_names(names)},
          {"constant/inletProfile", inlet_profile(scene, mesh)}};
}

Files unstructured(const Scene& scene) {
  const auto read = read_stl_channel(scene.geometry);
  const StlChannel& channel = *read;
  const SnappyMesh mesh = snappy_mesh(scene, channel);
  auto files = snappy_files(scene, channel, mesh);
  files["system/sceneDict"] =
      scene_dictionary(scene, stl_lattice(scene, channel, mesh), snappy_sampling(mesh)) + snappy_entries(mesh);
  files[stl_copy] = read_text_file(scene.geometry.stl);
  return files;
}

// The case carries its walls, so that it can be moved and mapped anywhere.
std::string case_scene(const Scene& scene) {
  Scene here = scene;
  if (is_stl_channel(scene.geometry)) here.geometry.stl = stl_copy;
  return effective_scene(here);
}

// The installation may be read-only: files and folders here are made anew, writable, whatever they
// are there.
void write_text(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  fs::permissions(file.parent_path(), fs::perms::owner_all, fs::perm_options::add);
  publish_file(text, file);
  if (file.filename().string().starts_with("All"))
    fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add);
}

FoamCaseState write_files(const Scene& scene, const fs::path& folder, const fs::path& template_folder) {
  require(fs::exists(template_folder / "Allrun"), "no OpenFOAM template in {} (an incomplete source tree?)",
          template_folder.string());
  Files files = is_stl_channel(scene.geometry) ? unstructured(scene) : structured(scene);
  files.merge(files_of_template(template_folder));
  const std::string hash = content_hash(flow_inputs(scene)) + "\n" + content_hash(everything(files)) + "\n";
  const auto holds = [&](const char* name) {
    return fs::exists(folder / name) && read_text_file(folder / name) == hash;
  };
  if (holds("hash") && holds("solved")) return FoamCaseState::solved;

  fs::create_directories(folder);
  CaseLock lock(folder);
  if (!lock.take()) {
    // Its solver is at work on what we want.
    if (holds("hash")) return FoamCaseState::unsolved;
    require(lock.take_patiently(), "{} is being solved for another flow, by {}; wait for it or name another folder",
            folder.string(), lock.holder());
  }
  const bool same = holds("hash");
  if (same && holds("solved")) return FoamCaseState::solved;
  remove_results(folder);
  if (is_stl_channel(scene.geometry)) fs::create_directories(folder / "constant" / "triSurface");
  for (const auto& [name, text] : files) write_text(folder / name, text);
  write_text(folder / "scene.toml", case_scene(scene));
  write_text(folder / "hash", hash);
  return same ? FoamCaseState::unsolved : FoamCaseState::written;
}

}  // namespace

FoamCaseState write_foam_case(const Scene& scene, const fs::path& folder, const fs::path& template_folder,
                              FoamCaseCheck check) {
  require(scene.flow.source == FlowSource::openfoam,
          "flow.source is not \"openfoam\" (this scene needs no flow case); set it to write one");
  try {
    refuse_foreign_folder(folder);
    if (check == FoamCaseCheck::without && !scene.flow.extrapolate) return write_files(scene, folder, template_folder);
    const Scene coarser = coarser_scene(scene);
    const FoamCaseState state = write_files(scene, folder, template_folder);
    return std::min(state, write_files(coarser, coarser_folder(folder), template_folder));
  } catch (const fs::filesystem_error& error) {
    throw Error(fmt::format("cannot write the case {} ({})", folder.string(), error.what()));
  }
}

}  // namespace clogflow
