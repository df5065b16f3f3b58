#include "coupling/flow/flow_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "coupling/base/require.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "coupling/openfoam/coarser_case.hpp"
#include "coupling/openfoam/flow_space.hpp"
#include "coupling/openfoam/foam_log.hpp"

namespace clogflow {
namespace {

namespace fs = std::filesystem;

constexpr double order = 1.5, order_at_edge = 0.5, order_of_correction = 1.8;
constexpr double factor_of_safety = 1.25;
constexpr double largest_correction = 0.5;  // of the velocity that it corrects

double share_of_difference(double p) { return 1 / (std::pow(coarsening, p) - 1); }

// Of two solutions, over the neck's mean velocity.
VelocityError difference(const FoamSamples& fine, const FoamSamples& coarse, double neck_mean) {
  require(fine.points == coarse.points, "the samples of the coarser mesh are at other points");
  std::vector<double> sizes;
  double squares = 0;
  for (std::size_t i = 0; i < fine.velocity.size(); ++i) {
    if (!fine.found[i] || !coarse.found[i]) continue;
    double square = 0;
    for (int c = 0; c < 3; ++c) square += std::pow(double{fine.velocity[i][c]} - double{coarse.velocity[i][c]}, 2);
    squares += square;
    sizes.push_back(std::sqrt(square));
  }
  require(!sizes.empty(), "the samples of the two meshes have no point in common");
  const auto count = static_cast<double>(sizes.size());
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * (count - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  const double most = *at;
  return {.rms = std::sqrt(squares / count) / neck_mean,
          .most = most / neck_mean,
          .largest = *std::max_element(at, sizes.end()) / neck_mean};
}

}  // namespace

VelocityError richardson_error(const FoamSamples& fine, const FoamSamples& coarse, double neck_mean) {
  VelocityError error = difference(fine, coarse, neck_mean);
  error.rms *= share_of_difference(order);
  error.most *= share_of_difference(order);
  error.largest *= share_of_difference(order_at_edge);
  return error;
}

double richardson_error(double fine, double coarse) {
  return share_of_difference(order) * std::abs(fine - coarse) / std::abs(fine);
}

double correction(double fine, double coarse) { return share_of_difference(order_of_correction) * (fine - coarse); }

double told_error(double fine, double coarse) { return factor_of_safety * std::abs(correction(fine, coarse)); }

VelocityError extrapolate(FoamSamples& fine, const FoamSamples& coarse, double neck_mean) {
  VelocityError told = difference(fine, coarse, neck_mean);
  for (double* of : {&told.rms, &told.most, &told.largest}) *of = told_error(*of, 0);
  for (std::size_t i = 0; i < fine.velocity.size(); ++i) {
    if (!fine.found[i] || !coarse.found[i]) continue;
    double added[3], square = 0, size = 0;
    for (int c = 0; c < 3; ++c) {
      added[c] = correction(fine.velocity[i][c], coarse.velocity[i][c]);
      square += added[c] * added[c];
      size += double{fine.velocity[i][c]} * fine.velocity[i][c];
    }
    if (square > largest_correction * largest_correction * size) continue;
    for (int c = 0; c < 3; ++c) fine.velocity[i][c] = static_cast<float>(fine.velocity[i][c] + added[c]);
  }
  return told;
}

std::optional<CoarserFlow> read_coarser_flow(const fs::path& folder, const Scene& scene) {
  const fs::path coarse = coarser_folder(folder);
  const std::string run = (folder / "Allrun").string();
  if (!fs::exists(coarse)) {
    require(!scene.flow.extrapolate,
            "{} is missing (flow.extrapolate = true needs the coarser case); write the case again", coarse.string());
    return std::nullopt;
  }
  const Scene other = read_scene(coarse / "scene.toml");
  require(flow_inputs(other) == flow_inputs(coarser_scene(scene)),
          "{} is not the coarser case of {}; write the case again with --check", coarse.string(), folder.string());
  require(fs::exists(coarse / "solved") && read_text_file(coarse / "solved") == read_text_file(coarse / "hash"),
          "{} is not solved; run {}", coarse.string(), run);
  return CoarserFlow{.cells_per_neck = other.flow.mesh_cells_per_neck,
                     .samples = read_flow_samples(coarse, flow_space(scene)),
                     .pressure_drop = read_pressure_drop(coarse)};
}

}  // namespace clogflow
