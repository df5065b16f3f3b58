# Published benchmarks, closed forms and conservation laws: one program asserts them, the other writes
# the same numbers to docs/reports/verification.md.
add_library(clog_verification OBJECT
  verification/all_groups.cpp
  verification/chung_ooi_normal.cpp
  verification/chung_ooi_oblique.cpp
  verification/closed_forms.cpp
  verification/drive.cpp
  verification/gravity.cpp
  verification/unequal_sizes.cpp
  verification/species_friction.cpp
  verification/cohesion.cpp
  verification/convergence.cpp
  verification/energy.cpp
  verification/invariants.cpp
  verification/guards.cpp
  verification/large_beside_small.cpp)
target_link_libraries(clog_verification PUBLIC clog_dem clog_test_support)
clog_tests(test_verification
  SOURCES verification/test_verification.cpp
  LIBRARIES clog_verification LABELS verification)
add_executable(verification_report verification/verification_report.cpp)
target_link_libraries(verification_report PRIVATE clog_verification)

# The same state in LAMMPS, if it is installed.
foreach(peer lammps turning)
  add_test(NAME peer_${peer} COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/verification/peer_${peer} $<TARGET_FILE:clog>)
  set_tests_properties(peer_${peer} PROPERTIES SKIP_RETURN_CODE 77 LABELS verification TIMEOUT ${test_time_limit})
endforeach()
