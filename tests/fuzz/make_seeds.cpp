// The binary seeds, small: a flow file and a run file, into the folder given.
#include "coupling/files/flow_grid.hpp"
#include "coupling/files/run_file.hpp"

namespace {

clogflow::FlowGrid small_grid() {
  clogflow::FlowGrid grid;
  grid.points = {3, 2, 2};
  grid.spacing = 1e-6;
  grid.velocity.assign(36, 0.5f);
  grid.solid.assign(12, 0);
  grid.walls = {{{clogflow::Vec3(0, 0, 0), clogflow::Vec3(1, 0, 0), clogflow::Vec3(0, 1, 0)}}};
  grid.scene_text = "a = 1\n";
  grid.hash = "0123";
  grid.record.cells = 8;
  return grid;
}

clogflow::RunData small_run() {
  clogflow::RunData run;
  run.seed = 7;
  run.scene_text = "a = 1\n";
  run.record.host = "here";
  run.end_time = 1.5;
  run.passages = {.time = {0.25, 0.5}, .id = {3, 1}, .y = {0, 0}, .z = {0, 0}, .friction_off = {0, 1}, .neck = {}};
  auto& series = run.series;
  series.time = {0};
  series.count = series.contacts = series.wall_contacts = {1};
  series.porosity = {{0.5}};
  for (auto* column :
       {&series.packing_fraction, &series.kinetic_energy, &series.elastic_energy, &series.largest_overlap,
        &series.drag_work, &series.dissipated, &series.median_speed, &series.speed_q99})
    *column = {0.1};
  run.snapshots.push_back({.time = 0,
                           .id = {1},
                           .radius = {1e-6},
                           .position = {1, 2, 3},
                           .velocity = {0, 0, 0},
                           .spin = {0, 0, 0},
                           .force = {0, 0, 0},
                           .torque = {0, 0, 0}});
  return run;
}

}  // namespace

int main(int, char** arguments) {
  const std::filesystem::path folder = arguments[1];
  clogflow::write_flow_grid(small_grid(), folder / "flow_file" / "small.h5");
  clogflow::RunData run = small_run();
  clogflow::write_run_file(run, folder / "run_file" / "small.h5");
  std::filesystem::remove(folder / "run_file" / "small.xmf");
}
