// Run files of a made-up flow with known laws: geometric bursts, Pareto arrests, particles on a
// lattice.
#pragma once

#include <cmath>
#include <filesystem>
#include <string>

#include "coupling/files/run_file.hpp"
#include "coupling/scene/scene.hpp"
#include "coupling/scene/unclog_protocol.hpp"
#include "tests/postprocess/laws/samples.hpp"

namespace clogflow::postprocess {

struct SyntheticEnsemble {
  std::string diameter = "33 um";
  std::string protocol = "none";
  double mean_burst = 12;
  double alpha = 2.5;
  double end = 1.5;                  ///< [s]
  double snapshot_interval = 0.002;  ///< [s]; 0: none
  double empty = 0;                  ///< share of the releases that nothing follows
  std::string more = {};             ///< further lines of the scene
  Overrides overrides = {};          ///< of its keys
};

inline std::string scene_of(const SyntheticEnsemble& ensemble) {
  const std::string text = ensemble.more + R"(
[geometry]
neck_width = "100 um"
half_angle = "60 deg"
[fluid]
viscosity = "1.8e-3 Pa s"
density = "1062 kg/m3"
[flow]
source = "openfoam"
mean_velocity = "5 mm/s"
[particles]
diameter = ")" + ensemble.diameter +
                           R"("
[contact]
youngs_modulus = "3e6 Pa"
poisson_ratio = 0.35
[drag]
[porosity]
strips = 3
[inlet]
[unclog]
protocol = ")" + ensemble.protocol +
                           R"("
[time]
end = ")" + std::to_string(ensemble.end) +
                           " s\"\n";
  return effective_scene(parse_scene(text, "synthetic.toml", ensemble.overrides));
}

/// A snapshot of spheres on a jittered lattice that fills the channel; flowing ones move along x.
inline RunData::Snapshot synthetic_snapshot(double time, double diameter, double flowing, RandomStream random) {
  RunData::Snapshot snapshot;
  snapshot.time = time;
  const double spacing = 1.12 * diameter;
  const double narrowing = 150e-6 / std::tan(60 * 3.14159265358979 / 180);
  for (double x = -600e-6; x < 100e-6 - diameter; x += spacing) {
    const double half = x < -narrowing ? 200e-6 : x < 0 ? 50e-6 - x * 150e-6 / narrowing : 50e-6;
    for (double y = -half + 0.6 * diameter; y < half - 0.5 * diameter; y += spacing) {
      for (double z = 0.5 * diameter; z < 100e-6 - 0.4 * diameter; z += spacing) {
        if (x > 0 && flowing < 0.5) continue;
        const double jitter = 0.12 * diameter;
        snapshot.id.push_back(static_cast<std::int64_t>(snapshot.id.size()));
        for (const double c : {x, y, z}) snapshot.position.push_back(c + jitter * (random.uniform() - 0.5));
        const double speed = flowing * 0.02 * std::min(1.0, 50e-6 / half) * (0.6 + 0.4 * random.uniform());
        for (const double c : {speed, 0.1 * speed * (random.uniform() - 0.5), 0.0}) snapshot.velocity.push_back(c);
        snapshot.radius.push_back(diameter / 2);
      }
    }
  }
  for (auto* zeros : {&snapshot.spin, &snapshot.force, &snapshot.torque}) zeros->assign(snapshot.position.size(), 0.0);
  return snapshot;
}

inline void add_passage(RunData& run, double time, std::uint8_t friction_off) {
  run.passages.time.push_back(time);
  run.passages.id.push_back(static_cast<std::int64_t>(run.passages.time.size()));
  run.passages.y.push_back(0);
  run.passages.z.push_back(50e-6);
  run.passages.friction_off.push_back(friction_off);
}

inline void add_series(RunData& run, double interval, RandomStream random) {
  for (double t = 0; t <= run.end_time; t += interval) {
    const double wave = 0.01 * std::sin(40 * t) + 0.004 * random.uniform();
    run.series.time.push_back(t);
    run.series.count.push_back(static_cast<std::int64_t>(950 + 2000 * wave));
    run.series.packing_fraction.push_back(0.45 + wave);
    run.series.porosity.push_back({0.62 - wave, 0.57 - 0.5 * wave, 0.53 + wave});
    for (auto* column :
         {&run.series.kinetic_energy, &run.series.elastic_energy, &run.series.largest_overlap, &run.series.drag_work,
          &run.series.dissipated, &run.series.median_speed, &run.series.speed_q99}) {
      column->push_back(0);
    }
    run.series.contacts.push_back(0);
    run.series.wall_contacts.push_back(0);
  }
}

inline RunData synthetic_run(const SyntheticEnsemble& ensemble, std::uint64_t seed) {
  RunData run;
  run.seed = seed;
  run.scene_text = scene_of(ensemble);
  run.record.program = "synthetic";
  run.record.fill_time = 0.08;
  run.end_time = ensemble.end;
  const Scene scene = parse_scene(run.scene_text, "synthetic.toml");
  const double tau = scene.stokes_time();
  RandomStream random(seed, 77);
  double next_snapshot = 0;
  const auto snapshots_until = [&](double time, double flowing) {
    while (ensemble.snapshot_interval > 0 && next_snapshot < std::min(time, run.end_time)) {
      run.snapshots.push_back(synthetic_snapshot(next_snapshot, scene.particles.diameter, flowing, random));
      next_snapshot += ensemble.snapshot_interval;
    }
  };
  const bool by_release = clears_clogs(scene.unclog.protocol);
  const double off = scene.unclog.protocol == UnclogProtocol::poke ? 0 : scene.unclog.duration;
  for (double t = 0.5 * tau; t < run.end_time;) {
    while (true) {
      add_passage(run, t, 0);
      if (random.uniform() < 1.0 / ensemble.mean_burst) break;
      const double lapse = 0.49 * tau * std::pow(random.uniform(), 1.5);
      if (t + lapse >= run.end_time) break;
      snapshots_until(t + lapse, 1.0);
      t += lapse;
    }
    if (scene.unclog.protocol == UnclogProtocol::stop) {
      // Known to be one after a while, unless the run ends before.
      if (t + scene.unclog.after >= run.end_time) break;
      run.end_time = t + scene.unclog.after;
      run.record.clogged_at = run.end_time;
      run.record.clog_position = random.uniform() < 0.1 ? -2e-4 : -2e-5;
      break;
    }
    const double arrest = 0.5 * tau * std::pow(1.0 - random.uniform(), -1.0 / (ensemble.alpha - 1.0));
    double start = by_release ? t + scene.unclog.after + 0.1 * tau : t + arrest;
    snapshots_until(start, 0.0);
    t = start;
    while (by_release && start + off < run.end_time) {
      run.releases.off.push_back(start);
      run.releases.on.push_back(start + off);
      run.releases.largest_speed.push_back(1e-7);
      run.releases.position.push_back(0);
      if (random.uniform() < 0.7 && off > 0) add_passage(run, start + 0.3 * off, 1);
      t = start + off + 0.2 * tau;
      if (ensemble.empty == 0 || random.uniform() >= ensemble.empty) break;
      start = t + scene.unclog.after;
    }
  }
  add_series(run, 0.1 * tau, random);
  return run;
}

/// Writes seeds 1 ... count into a folder, which it empties first.
inline std::filesystem::path write_ensemble(const std::filesystem::path& folder, const SyntheticEnsemble& ensemble,
                                            std::uint64_t count) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (std::uint64_t seed = 1; seed <= count; ++seed)
    write_run_file(synthetic_run(ensemble, seed), folder / run_file_name(seed));
  return folder;
}

}  // namespace clogflow::postprocess
