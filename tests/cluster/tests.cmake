# Needs Slurm (slurmctld, slurmd, slurm-client, munge), which neither Allrun nor Alltest installs: without it the test is
# skipped, with a line that says so.
add_test(NAME Slurm COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/cluster/slurm_test $<TARGET_FILE:clog>)
set_tests_properties(Slurm PROPERTIES LABELS cluster SKIP_RETURN_CODE 77 TIMEOUT 900)
add_test(NAME SimulatedScheduler COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/cluster/test_scheduler)
set_tests_properties(SimulatedScheduler PROPERTIES LABELS cluster)
# Takes root, for namespaces.
add_test(NAME TwoNodes COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/cluster/two_nodes $<TARGET_FILE:clog>)
set_tests_properties(TwoNodes PROPERTIES LABELS cluster SKIP_RETURN_CODE 77 TIMEOUT 600)
