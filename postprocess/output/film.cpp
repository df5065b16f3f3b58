// Everything is checked before the first frame is drawn.
#include "postprocess/output/film.hpp"

#include <sstream>

#include <nlohmann/json.hpp>

#include "coupling/base/require.hpp"
#include "coupling/files/run_file.hpp"
#include "coupling/scene/scene.hpp"
#include "postprocess/output/figure_scripts.hpp"
#include "postprocess/output/shape_json.hpp"

namespace clogflow::postprocess {
namespace {

namespace fs = std::filesystem;

bool is_installed(const std::string& program) {
  std::istringstream folders(of_environment("PATH", "/usr/bin"));
  for (std::string folder; std::getline(folders, folder, ':');)
    if (fs::exists(fs::path(folder) / program)) return true;
  return false;
}

void check_target(const fs::path& out) {
  const std::string ending = out.extension();
  if (ending.empty()) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(out, none))
      require(!entry.path().filename().string().starts_with("frame_"),
              "{}: holds frames already ({}); name another folder, or empty it", out.string(),
              entry.path().filename().string());
    return;
  }
  require(ending == ".mp4" || ending == ".webm",
          "--out {}: a film ends with .mp4 or .webm; without an ending it is a folder for PNG frames", out.string());
  require(is_installed("ffmpeg"),
          "{}: needs ffmpeg (apt-get install ffmpeg); --out FOLDER, without an ending, writes PNG frames instead",
          out.string());
}

/// \return the places of those to be drawn
std::vector<std::size_t> chosen_snapshots(const RunData& run, const FilmJob& job) {
  require(job.from <= job.to, "--from {} s is later than --to {} s", job.from, job.to);
  std::vector<std::size_t> chosen;
  std::size_t within = 0;
  for (std::size_t k = 0; k < run.snapshots.size(); ++k) {
    const double time = run.snapshots[k].time;
    if (time < job.from || time > job.to) continue;
    if (within++ % static_cast<std::size_t>(job.every) == 0) chosen.push_back(k);
  }
  require(!chosen.empty(), "{}: no snapshot between --from and --to ({}; output.snapshot_interval makes them)",
          job.run.string(),
          run.snapshots.empty() ? std::string("the run has none")
                                : fmt::format("it has {} from {:.6g} s to {:.6g} s", run.snapshots.size(),
                                              run.snapshots.front().time, run.snapshots.back().time));
  const std::size_t share = (chosen.size() + most_film_frames - 1) / most_film_frames;
  require(chosen.size() <= most_film_frames,
          "{}: {} snapshots, at most {} in a film: narrow --from and --to, or take fewer with --every {}",
          job.run.string(), chosen.size(), most_film_frames, static_cast<std::size_t>(job.every) * share);
  return chosen;
}

}  // namespace

std::vector<fs::path> make_film(const FilmJob& job) {
  require(job.every >= 1, "--every {}: at least 1", job.every);
  require(job.rate >= 1 && job.rate <= 120, "--rate {}: frames a second, from 1 to 120", job.rate);
  check_target(job.out);
  const RunData run = read_run_file(job.run);
  const std::vector<std::size_t> frames = chosen_snapshots(run, job);
  const Scene scene = parse_scene(run.scene_text, job.run.string());
  nlohmann::json shape = shape_json(scene);
  shape.erase("walls");  // drawn from above
  const bool is_folder = job.out.extension().empty();
  const nlohmann::json text{{"run", fs::absolute(job.run).string()},
                            {"geometry", shape},
                            {"tau", scene.stokes_time()},
                            {"frames", frames},
                            {"rate", job.rate},
                            {"film", is_folder ? "" : job.out.filename().string()}};
  const fs::path folder = is_folder ? job.out : job.out.has_parent_path() ? job.out.parent_path() : fs::path(".");
  return run_figure_script("make_film.py", {}, folder, text.dump());
}

}  // namespace clogflow::postprocess
