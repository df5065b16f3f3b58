clog_tests(test_physics
  SOURCES dem/physics/test_material_pair.cpp dem/physics/test_contact_laws.cpp dem/physics/test_fluid_laws.cpp dem/physics/test_number.cpp dem/physics/test_drag_laws.cpp
          dem/physics/test_other_contact_laws.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_few_particles
  SOURCES dem/run/test_impacts.cpp dem/run/test_friction.cpp dem/fluid/test_suspended.cpp dem/fluid/test_films.cpp
          dem/fluid/test_fluid_noise.cpp dem/run/test_energy_account.cpp dem/contact/test_species_friction.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_walls
  SOURCES dem/contact/test_wall_surface.cpp dem/contact/test_wall_contacts.cpp dem/contact/test_curved_walls.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_against_scalar
  SOURCES dem/kernels/test_against_scalar.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_dem_parts
  SOURCES dem/run/test_passages.cpp dem/protocol/test_burst_clock.cpp dem/protocol/test_clog_watch.cpp dem/state/test_initial_particles.cpp
          dem/contact/test_stl.cpp dem/contact/test_size_levels.cpp dem/contact/test_contact_forces.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_fluid_parts
  SOURCES dem/fluid/test_flow_field.cpp dem/fluid/test_local_porosity.cpp dem/fluid/test_drag_readings.cpp
          dem/fluid/test_oscillation.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_channel_parts
  SOURCES dem/run/test_inlet.cpp dem/run/test_refusals.cpp dem/stability/test_shaking.cpp dem/stability/test_network_limit.cpp
          dem/stability/test_step_limit.cpp
          dem/run/test_model_refusals.cpp dem/plan/test_disk_use.cpp dem/plan/test_plan.cpp dem/run/test_stl_scene.cpp dem/run/test_flow_fit.cpp
          dem/run/test_release_region.cpp dem/protocol/test_supply_watch.cpp
  LIBRARIES clog_dem LABELS unit)
clog_tests(test_channel_runs
  SOURCES dem/run/test_channel_runs.cpp dem/run/test_contact_lists.cpp dem/run/test_full_inlet.cpp dem/run/test_silo.cpp
          dem/run/test_rest_proof.cpp dem/run/test_similarity.cpp dem/run/test_driven_flow.cpp dem/run/test_threads.cpp
  LIBRARIES clog_dem LABELS slow)
clog_tests(test_packing
  SOURCES ensemble/test_packing.cpp coupling/base/test_in_processes.cpp
  LIBRARIES clog_ensemble LABELS unit)
target_compile_definitions(test_packing PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>")
add_dependencies(test_packing clog)
clog_tests(test_ensemble
  SOURCES ensemble/test_ensemble.cpp
  LIBRARIES clog_ensemble LABELS slow)
target_compile_definitions(test_ensemble PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>")
add_dependencies(test_ensemble clog)
