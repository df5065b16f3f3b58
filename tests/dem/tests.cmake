clog_tests(test_physics
  SOURCES dem/test_material_pair.cpp dem/test_contact_laws.cpp dem/test_fluid_laws.cpp dem/test_drag_laws.cpp
          dem/test_other_contact_laws.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_few_particles
  SOURCES dem/test_impacts.cpp dem/test_friction.cpp dem/test_suspended.cpp dem/test_films.cpp
          dem/test_fluid_noise.cpp dem/test_energy_account.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_walls
  SOURCES dem/test_wall_surface.cpp dem/test_wall_contacts.cpp dem/test_curved_walls.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_against_scalar
  SOURCES dem/test_against_scalar.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_dem_parts
  SOURCES dem/test_passages.cpp dem/test_clog_watch.cpp dem/test_initial_particles.cpp
          dem/test_stl.cpp dem/test_flow_field.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_channel_parts
  SOURCES dem/test_inlet.cpp dem/test_refusals.cpp dem/test_shaking.cpp dem/test_step_limit.cpp
          dem/test_model_refusals.cpp dem/test_plan.cpp dem/test_stl_scene.cpp dem/test_flow_fit.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_channel_runs
  SOURCES dem/test_channel_runs.cpp dem/test_full_inlet.cpp
  LIBRARIES clog_dem LABELS slow)
clog_tests(test_ensemble
  SOURCES dem/test_ensemble.cpp
  LIBRARIES clog_ensemble LABELS slow)
target_compile_definitions(test_ensemble PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>")
add_dependencies(test_ensemble clog)
