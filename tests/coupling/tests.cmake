clog_tests(test_scene_reading
  SOURCES coupling/base/test_units.cpp coupling/scene/test_readable_scene.cpp coupling/scene/test_scene.cpp coupling/scene/test_scene_refusals.cpp
          coupling/scene/test_hostile_scene.cpp coupling/scene/test_sweep.cpp coupling/scene/test_particle_sizes.cpp
          coupling/keys/test_key_reference.cpp
  LIBRARIES clog_coupling LABELS unit)
clog_tests(test_flow_case
  SOURCES coupling/geometry/test_channel_geometry.cpp coupling/geometry/test_duct_flow.cpp
          coupling/flow/test_flow_error.cpp coupling/flow/test_flow_reach.cpp coupling/flow/test_flow_rescale.cpp coupling/openfoam/test_foam_case_writer.cpp coupling/openfoam/test_foam_log.cpp coupling/openfoam/test_foam_samples.cpp coupling/openfoam/test_quadratic_flow.cpp coupling/geometry/test_stl_channel.cpp coupling/geometry/test_wall_outlines.cpp
  LIBRARIES clog_coupling LABELS unit)
clog_tests(test_file_formats
  SOURCES coupling/files/test_flow_grid.cpp coupling/files/test_run_file.cpp coupling/files/test_hdf5_faults.cpp coupling/files/test_hostile_hdf5.cpp
          coupling/base/test_publish_file.cpp coupling/base/test_team.cpp coupling/base/test_vector.cpp coupling/base/test_expect.cpp coupling/base/test_environment.cpp coupling/files/test_records.cpp
  LIBRARIES clog_coupling hdf5::hdf5 LABELS unit)
clog_tests(test_layers
  SOURCES habits/test_layers.cpp
  LIBRARIES clog_coupling LABELS unit)
