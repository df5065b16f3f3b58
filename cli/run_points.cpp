#include "cli/run_points.hpp"

#include <algorithm>

#include "coupling/base/archive.hpp"
#include "coupling/base/require.hpp"
#include "coupling/flow/flow_rescale.hpp"
#include "dem/plan/plan.hpp"
#include "dem/stability/step_limit.hpp"
#include "dem/state/initial_particles.hpp"
#include "ensemble/seed_run.hpp"
#include "ensemble/shared_flow.hpp"
#include "trade/fidelity.hpp"

namespace clogflow::cli {
namespace {

using SharedGrid = std::shared_ptr<const FlowGrid>;

/// The flow as this scene wants it; `file` as it was read, shared by the points that want it so.
SharedGrid flow_for(RunPoint& point, const RunSource& source, SharedGrid& file) {
  if (point.scene.flow.source != FlowSource::openfoam) {
    require(source.flow.empty(), "{}: flow.source is not \"openfoam\", so {} would not be used: leave out --flow",
            source.scene.string(), source.flow.string());
    return {};
  }
  require(!source.flow.empty(),
          "{}: flow.source = \"openfoam\" needs the flow: give --flow flow.h5 (clog case, its "
          "Allrun and clog map make it)",
          source.scene.string());
  if (!file) file = std::make_shared<const FlowGrid>(read_flow_grid(source.flow));
  if (!point.scene.flow.rescale) return file;
  RescaledFlow rescaled = rescaled_flow(*file, point.scene);
  if (!point.note.empty()) point.note += "\n";
  point.note += fmt::format(
      "the flow is scaled by {:.6g}; that leaves out {:.2g} % of the "
      "neck's mean velocity at most",
      rescaled.factor, 100 * rescaled.error);
  return std::make_shared<const FlowGrid>(std::move(rescaled.grid));
}

std::vector<std::uint64_t> seeds_asked(const std::string& text) {
  try {
    return parse_seeds(text);
  } catch (const Error& error) {
    throw Error(fmt::format("--seeds {}", error.what()));
  }
}

RunPoint read_point(const RunSource& source, const SweepPoint& at, SharedGrid& file) {
  Overrides overrides = source.overrides;
  overrides.insert(overrides.end(), at.overrides.begin(), at.overrides.end());
  auto [scene, fidelity] = trade::read_resolved_scene(source.scene, overrides);
  RunPoint point{.folder = at.folder, .scene = std::move(scene), .flow = {}, .note = fidelity, .inputs = ""};
  if (source.seeds) point.scene.ensemble.seeds = seeds_asked(*source.seeds);
  point.flow = flow_for(point, source, file);
  // What is wrong with the scene is wrong for every seed: say it once, before any run begins.
  const std::vector<Particle> initial = read_initial_particles(point.scene);
  const Model model = make_model(point.scene, point.flow.get(), initial);
  check_step(expected_limits(model, initial), model);
  point.cost = make_plan(point.scene).seconds();
  point.inputs = inputs_hash({point.scene, point.flow.get(), {}});
  return point;
}

/// A point without its flow, of which it has the number.
struct PackedPoint {
  std::string folder, scene, note, inputs;
  double cost = 0;
  int flow = -1;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(folder, scene, note, inputs, cost, flow);
  }
};

/// Points with the same flow have one grid.
class Packer {
public:
  explicit Packer(const std::vector<RunPoint>& points) {
    for (const RunPoint& p : points)
      packed_.push_back({p.folder, effective_scene(p.scene), p.note, p.inputs, p.cost, number_of(p.flow)});
  }

  std::string bytes() {
    ArchiveWriter archive;
    std::size_t flows = flows_.size();
    archive(flows, packed_);
    return archive.bytes();
  }
  const std::vector<SharedGrid>& flows() const { return flows_; }

private:
  int number_of(const SharedGrid& flow) {
    if (!flow) return -1;
    const auto found = std::ranges::find(flows_, flow);
    if (found == flows_.end()) flows_.push_back(flow);
    return static_cast<int>(std::ranges::find(flows_, flow) - flows_.begin());
  }

  std::vector<PackedPoint> packed_;
  std::vector<SharedGrid> flows_;
};

}  // namespace

std::vector<RunPoint> read_run_points(const RunSource& source) {
  // The command line replaces the sweep of the scene.
  const auto sweeps = source.sweeps.empty()
                          ? trade::read_resolved_scene(source.scene, source.overrides).scene.ensemble.sweep
                          : source.sweeps;
  std::vector<RunPoint> all;
  SharedGrid file;
  for (const SweepPoint& point : sweep_points(sweeps)) {
    try {
      all.push_back(read_point(source, point, file));
    } catch (const Error& error) {
      throw Error(point.folder.empty() ? error.what() : fmt::format("{}: {}", point.folder, error.what()));
    }
  }
  return all;
}

std::vector<RunPoint> shared_run_points(std::vector<RunPoint> of_first, const std::filesystem::path& scene_file,
                                        Ranks& ranks) {
  if (ranks.count() == 1) return of_first;
  Packer packer(of_first);
  std::vector<PackedPoint> packed;
  std::size_t flows = 0;
  ArchiveReader archive(ranks.of_first(packer.bytes()));
  archive(flows, packed);
  std::vector<SharedGrid> shared;
  for (std::size_t k = 0; k < flows; ++k)
    shared.push_back(
        std::make_shared<const FlowGrid>(shared_flow(ranks.is_first() ? *packer.flows()[k] : FlowGrid{}, ranks)));
  std::vector<RunPoint> points;
  for (const PackedPoint& p : packed)
    points.push_back({p.folder, parse_scene(p.scene, scene_file.string()),
                      p.flow < 0 ? nullptr : shared[static_cast<std::size_t>(p.flow)], p.note, p.cost, p.inputs});
  return points;
}

}  // namespace clogflow::cli
