clog_tests(test_scene_reading
  SOURCES coupling/test_units.cpp coupling/test_readable_scene.cpp coupling/test_scene.cpp coupling/test_scene_refusals.cpp
          coupling/test_hostile_scene.cpp coupling/test_sweep.cpp
  LIBRARIES clog_coupling LABELS unit)
clog_tests(test_flow_case
  SOURCES coupling/test_channel_geometry.cpp coupling/test_duct_flow.cpp
          coupling/test_flow_error.cpp coupling/test_flow_reach.cpp coupling/test_flow_rescale.cpp coupling/test_foam_case_writer.cpp coupling/test_foam_log.cpp coupling/test_foam_samples.cpp coupling/test_stl_channel.cpp
  LIBRARIES clog_coupling LABELS unit)
clog_tests(test_file_formats
  SOURCES coupling/test_flow_grid.cpp coupling/test_run_file.cpp coupling/test_hdf5_faults.cpp coupling/test_hostile_hdf5.cpp
          coupling/test_publish_file.cpp coupling/test_expect.cpp coupling/test_environment.cpp coupling/test_records.cpp
  LIBRARIES clog_coupling hdf5::hdf5 LABELS unit)
clog_tests(test_layers
  SOURCES coupling/test_layers.cpp
  LIBRARIES clog_coupling LABELS unit)
