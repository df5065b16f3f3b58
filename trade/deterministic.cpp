#include "trade/deterministic.hpp"

#include <cmath>
#include <map>

#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"

namespace clogflow::trade {

namespace fs = std::filesystem;

namespace {

struct Outcome {
  std::map<std::int64_t, Vec3> force, way;
  double overlap = 0, particle_steps = 0;
};

/// First snapshot of any run of the study's earliest setting that has one.
RunData a_run(const Study& study, const std::vector<Setting>& settings) {
  for (const Setting& setting : settings)
    for (const std::uint64_t seed : scene_of(study, setting).ensemble.seeds)
      if (const fs::path file = folder_of(study, setting) / run_file_name(seed); fs::exists(file))
        return read_run_file(file);
  throw Error("the study has no run to start from");
}

double largest_overlap(const RunData::Snapshot& s) {
  double overlap = 0;
  for (std::size_t i = 0; i < s.id.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 apart(Vec3(&s.position[3 * i]) - Vec3(&s.position[3 * j]));
      overlap = std::max(overlap, s.radius[i] + s.radius[j] - apart.norm());
    }
  return overlap;
}

void write_pack(const RunData::Snapshot& s, const fs::path& file) {
  const double shrink = 0.5 * largest_overlap(s);
  std::string text = "x,y,z,radius\n";
  for (std::size_t i = 0; i < s.id.size(); ++i)
    text += fmt::format("{},{},{},{}\n", s.position[3 * i], s.position[3 * i + 1], s.position[3 * i + 2],
                        s.radius[i] - shrink);
  publish_file(text, file);
}

Outcome move(const Scene& scene, const FlowGrid* flow) {
  Simulation simulation(scene, flow, 1);
  Outcome outcome;
  std::map<std::int64_t, Vec3> start;
  const Particles& p = simulation.particles();
  const auto place = [&](std::size_t i) { return Vec3(p[i].x, p[i].y, p[i].z); };
  for (std::size_t i = 0; i < p.size(); ++i) start[p.id[i]] = place(i);
  const RunData data = simulation.run();
  const RunData::Snapshot &first = data.snapshots.front(), &last = data.snapshots.back();
  for (std::size_t i = 0; i < first.id.size(); ++i) outcome.force[first.id[i]] = Vec3(&first.force[3 * i]);
  for (std::size_t i = 0; i < last.id.size(); ++i)
    outcome.way[last.id[i]] = Vec3(&last.position[3 * i]) - start.at(last.id[i]);
  outcome.overlap = data.series.largest_overlap.back() / scene.particles.diameter;
  outcome.particle_steps = data.record.particle_steps.value();
  return outcome;
}

double relative_difference(const std::map<std::int64_t, Vec3>& reference, const std::map<std::int64_t, Vec3>& other) {
  double square = 0, scale = 0;
  for (const auto& [id, a] : reference)
    if (const auto b = other.find(id); b != other.end()) {
      square += (b->second - a).squaredNorm();
      scale += a.squaredNorm();
    }
  return std::sqrt(square / scale);
}

/// Every second, fourth ... point of the grid, as a coarser sampling would have it.
FlowGrid coarsened(const FlowGrid& fine, int factor) {
  FlowGrid coarse = fine;
  coarse.spacing = factor * fine.spacing;
  for (int a = 0; a < 3; ++a) coarse.points[a] = (fine.points[a] - 1) / factor + 1;
  coarse.velocity.clear(), coarse.solid.clear();
  for (int k = 0; k < coarse.points[2]; ++k)
    for (int j = 0; j < coarse.points[1]; ++j)
      for (int i = 0; i < coarse.points[0]; ++i) {
        const std::size_t at = fine.index(factor * i, factor * j, factor * k);
        for (int c = 0; c < 3; ++c) coarse.velocity.push_back(fine.velocity[3 * at + c]);
        coarse.solid.push_back(fine.solid[at]);
      }
  return coarse;
}

/// Settings that only a short run can afford.
std::vector<Setting> more_settings() {
  std::vector<Setting> more;
  const auto add = [&](const std::string& name, const Overrides& overrides) {
    more.push_back({name, "", "", Kind::dose, overrides});
  };
  for (const double fraction : {0.01, 0.005, 0.002})
    add(fmt::format("tau{:.0f}", 1 / fraction), {fmt::format("time.step_fraction={}", fraction)});
  return more;
}

}  // namespace

std::vector<ShortRun> short_runs(const Study& study) {
  const Scene base = read_scene(study.scene_file, study.overrides);
  std::vector<Setting> settings = settings_for(base);
  const fs::path pack = study.directory / "pack.csv";
  write_pack(a_run(study, settings).snapshots.front(), pack);
  for (const Setting& setting : more_settings()) settings.push_back(setting);
  const auto scene_for = [&](const Setting& setting) {
    Study own = study;
    own.overrides.insert(own.overrides.end(), {"inlet.enabled=false", "unclog.protocol=none",
                                               fmt::format("particles.initial={}", fs::absolute(pack).string()),
                                               fmt::format("time.end={} s", 0.1 * base.stokes_time())});
    return scene_of(own, setting);
  };
  const Outcome reference = move(scene_for({"", "", "", Kind::dose, {"time.step_fraction=0.004"}}), study.flow);
  std::vector<ShortRun> runs;
  const auto add = [&](const std::string& name, const Setting& setting, const FlowGrid* flow) {
    ShortRun run;
    run.name = name;
    try {
      const Outcome outcome = move(scene_for(setting), flow);
      run.force = relative_difference(reference.force, outcome.force);
      run.path = relative_difference(reference.way, outcome.way);
      run.overlap = outcome.overlap, run.particle_steps = outcome.particle_steps;
    } catch (const Error& error) {
      run.refused = error.what();
    }
    runs.push_back(run);
  };
  for (const Setting& setting : settings) add(setting.name, setting, study.flow);
  for (const int factor : {2, 4, 8}) {
    if (!study.flow) break;
    const FlowGrid coarse = coarsened(*study.flow, factor);
    add(fmt::format("grid x {}", factor), {}, &coarse);
    add(fmt::format("grid x {}, trilinear", factor), {"", "", "", Kind::dose, {"flow.lookup=trilinear"}}, &coarse);
  }
  return runs;
}

}  // namespace clogflow::trade
