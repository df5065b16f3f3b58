#include "coupling/foam_case_writer.hpp"

#include <fstream>
#include <string>

#include "coupling/content_hash.hpp"
#include "coupling/foam_dictionaries.hpp"
#include "coupling/require.hpp"
#include "coupling/text_file.hpp"

namespace clog {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.close();
  require(out.good(), "cannot write {} (disk full, or no permission?)", file.string());
}

bool is_time_folder(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.find_first_not_of("0123456789.") == std::string::npos;
}

void remove_results(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto name = entry.path().filename().string();
    if (name == "postProcessing" || name == "fluxes" || name == "solved" ||
        name.starts_with("log.") || is_time_folder(entry.path())) {
      fs::remove_all(entry.path());
    }
  }
  fs::remove_all(folder / "constant" / "polyMesh");
}

void copy_template(const fs::path& from, const fs::path& to) {
  require(fs::exists(from / "Allrun"), "no OpenFOAM template in {} (an incomplete source tree?)",
          from.string());
  fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
}

// Refuses a folder that is neither empty nor a flow case: its files would be mixed with ours.
void refuse_foreign_folder(const fs::path& folder) {
  require(!fs::exists(folder) || fs::is_directory(folder),
          "{} is a file (a case needs a folder); name another", folder.string());
  require(!fs::exists(folder) || fs::is_empty(folder) || fs::exists(folder / "hash"),
          "{} is not empty and not a flow case (it has no file `hash`); name another folder",
          folder.string());
}

FoamCaseState write_files(const Scene& scene, const fs::path& folder,
                          const fs::path& template_folder) {
  const FlowMesh mesh = flow_mesh(scene);
  const FlowLattice lattice = flow_lattice(scene, mesh.inlet);
  const std::string hash = content_hash(flow_inputs(scene)) + "\n";
  const auto holds = [&](const char* name) {
    return fs::exists(folder / name) && read_text_file(folder / name) == hash;
  };
  const bool same = holds("hash");
  if (same && holds("solved")) return FoamCaseState::solved;

  fs::create_directories(folder);
  remove_results(folder);
  copy_template(template_folder, folder);
  write_text(folder / "system" / "sceneDict", scene_dictionary(scene, mesh, lattice));
  write_text(folder / "constant" / "inletProfile", inlet_profile(scene, mesh));
  write_text(folder / "scene.toml", effective_scene(scene));
  write_text(folder / "hash", hash);
  return same ? FoamCaseState::unsolved : FoamCaseState::written;
}

}  // namespace

FoamCaseState write_foam_case(const Scene& scene, const fs::path& folder,
                              const fs::path& template_folder) {
  require(scene.flow.source == FlowSource::openfoam,
          "flow.source is not \"openfoam\" (this scene needs no flow case); set it to write one");
  try {
    refuse_foreign_folder(folder);
    return write_files(scene, folder, template_folder);
  } catch (const fs::filesystem_error& error) {
    throw Error(fmt::format("cannot write the case {} ({})", folder.string(), error.what()));
  }
}

}  // namespace clog
