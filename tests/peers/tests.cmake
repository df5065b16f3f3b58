# Two packs of the case that the nightly part "peers" runs a hundred of; skipped without LIGGGHTS and LAMMPS.
add_test(NAME peer_first_clog COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/peers/first_clog $<TARGET_FILE:clog> --packs 1-2)
set_tests_properties(peer_first_clog PROPERTIES SKIP_RETURN_CODE 77 LABELS verification TIMEOUT ${test_time_limit})

# All of resolved_arch but OpenFOAM, which the nightly part "arch" runs.
add_test(NAME resolved_arch_parts COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/peers/test_resolved_arch)
set_tests_properties(resolved_arch_parts PROPERTIES SKIP_RETURN_CODE 77 LABELS unit TIMEOUT ${test_time_limit})
