// Small flow and run files for the tests of formats.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "coupling/files/flow_grid.hpp"
#include "coupling/files/run_file.hpp"
#include "tests/scratch.hpp"

namespace clogflow {

inline std::filesystem::path temporary(const std::string& name) { return scratch_folder() / name; }

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// 40 x 30 x 20 points with a different value everywhere: large enough to be stored in pieces.
inline FlowGrid sample_grid() {
  FlowGrid grid;
  grid.points = {40, 30, 20};
  grid.origin = Vec3(-1e-3, -2e-4, 0);
  grid.spacing = 1e-6;
  for (int i = 0; i < 3 * 40 * 30 * 20; ++i) grid.velocity.push_back(static_cast<float>(i) * 1e-6f);
  for (int i = 0; i < 40 * 30 * 20; ++i) grid.solid.push_back(i % 7 == 0);
  grid.walls = {{{Vec3(0, 0, 0), Vec3(1e-3, 0, 0), Vec3(0, 1e-3, 0)}},
                {{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1.0 / 3)}}};
  grid.scene_text = "[flow]\nsource = \"openfoam\"\n";
  grid.hash = "0123456789abcdef";
  grid.record.openfoam_version = "2312 \u00b5";
  grid.record.cells = 48000;
  return grid;
}

inline RunData sample_run() {
  RunData run;
  run.seed = 7;
  run.scene_text = "a = 1\n";
  run.record.host = "somewhere";
  run.record.flow_hash = "0123";
  run.end_time = 1.5;
  run.passages = {.time = {0.25, 0.5},
                  .id = {3, 1},
                  .y = {1e-6, -1e-6},
                  .z = {5e-5, 6e-5},
                  .friction_off = {0, 1},
                  .neck = {},
                  .radius = {},
                  .species = {}};
  run.releases = {.off = {0.4}, .on = {0.4015}, .largest_speed = {1e-7}, .position = {-1e-5}};
  auto& series = run.series;
  series.time = {0, 1, 1.5};
  series.count = series.contacts = series.wall_contacts = {10, 11, 12};
  series.porosity = {{0.5, 0.6}, {0.4, 0.5}, {0.5, 0.5}};
  for (auto* column :
       {&series.packing_fraction, &series.kinetic_energy, &series.elastic_energy, &series.largest_overlap,
        &series.drag_work, &series.dissipated, &series.median_speed, &series.speed_q99})
    *column = {0.1, 0.2, 1.0 / 3};
  for (const std::size_t particles : {2u, 0u, 3u}) {
    RunData::Snapshot snapshot;
    snapshot.time = static_cast<double>(run.snapshots.size());
    for (std::size_t i = 0; i < particles; ++i) {
      snapshot.id.push_back(static_cast<std::int64_t>(10 * particles + i));
      snapshot.radius.push_back(16.5e-6);
      for (auto* vector : {&snapshot.position, &snapshot.velocity, &snapshot.spin, &snapshot.force, &snapshot.torque})
        for (int axis = 0; axis < 3; ++axis) vector->push_back(static_cast<double>(100 * particles + 10 * i) + axis);
    }
    run.snapshots.push_back(snapshot);
  }
  return run;
}

}  // namespace clogflow
