#include "coupling/flow_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "coupling/channel_shape.hpp"
#include "coupling/flow_space.hpp"
#include "coupling/foam_log.hpp"
#include "coupling/require.hpp"
#include "coupling/text_file.hpp"

namespace clog {
namespace {

namespace fs = std::filesystem;

constexpr double coarsening = 2;
constexpr double order = 1.5, order_at_edge = 0.5;
constexpr double fewest_cells = 4;

double share_of_difference(double p) { return 1 / (std::pow(coarsening, p) - 1); }

}  // namespace

Scene coarser_scene(const Scene& scene) {
  Scene coarse = scene;
  coarse.flow.mesh_cells_per_neck = scene.flow.mesh_cells_per_neck / coarsening;
  require(coarse.flow.mesh_cells_per_neck >= fewest_cells,
          "flow.mesh_cells_per_neck = {} (a check solves with half of them, and {} is the least); "
          "give at least {}",
          scene.flow.mesh_cells_per_neck, fewest_cells, coarsening * fewest_cells);
  return coarse;
}

fs::path coarser_folder(const fs::path& folder) { return folder / "coarse"; }

VelocityError richardson_error(const FoamSamples& fine, const FoamSamples& coarse,
                               double neck_mean) {
  require(fine.points == coarse.points, "the samples of the coarser mesh are at other points");
  std::vector<double> difference;
  double squares = 0;
  for (std::size_t i = 0; i < fine.velocity.size(); ++i) {
    if (!fine.found[i] || !coarse.found[i]) continue;
    double square = 0;
    for (int c = 0; c < 3; ++c)
      square += std::pow(double{fine.velocity[i][c]} - double{coarse.velocity[i][c]}, 2);
    squares += square;
    difference.push_back(std::sqrt(square));
  }
  require(!difference.empty(), "the samples of the two meshes have no point in common");
  const auto count = static_cast<double>(difference.size());
  const auto at = difference.begin() + static_cast<std::ptrdiff_t>(0.99 * (count - 1));
  std::nth_element(difference.begin(), at, difference.end());
  const double most = *at;
  const double smooth = share_of_difference(order) / neck_mean;
  return {.rms = smooth * std::sqrt(squares / count),
          .most = smooth * most,
          .largest = share_of_difference(order_at_edge) / neck_mean *
                     *std::max_element(at, difference.end())};
}

double richardson_error(double fine, double coarse) {
  return share_of_difference(order) * std::abs(fine - coarse) / std::abs(fine);
}

nlohmann::json mesh_error(const fs::path& folder, const Scene& scene, const FoamSamples& fine) {
  const fs::path coarse = coarser_folder(folder);
  if (!fs::exists(coarse)) return nullptr;
  const std::string run = (folder / "Allrun").string();
  const fs::path file = coarse / "scene.toml";
  const Scene other = read_scene(file);
  require(flow_inputs(other) == flow_inputs(coarser_scene(scene)),
          "{} is not the coarser case of {}; write the case again with --check", coarse.string(),
          folder.string());
  require(fs::exists(coarse / "solved"), "{} is not solved; run {}", coarse.string(), run);
  const VelocityError velocity =
      richardson_error(fine, read_flow_samples(coarse, flow_space(scene)), neck_mean_velocity(scene));
  const double drop = read_pressure_drop(folder), coarse_drop = read_pressure_drop(coarse);
  return {{"cells_per_neck", {scene.flow.mesh_cells_per_neck, other.flow.mesh_cells_per_neck}},
          {"velocity_rms", velocity.rms},
          {"velocity_99_percent", velocity.most},
          {"velocity_largest", velocity.largest},
          {"pressure_drop", richardson_error(drop, coarse_drop)}};
}

}  // namespace clog
