clog_tests(test_exact_restart
  SOURCES faults/test_exact_restart.cpp faults/test_lengthened.cpp
  LIBRARIES clog_dem LABELS faults)
clog_tests(test_killed
  SOURCES faults/test_killed.cpp faults/test_states.cpp faults/test_disk.cpp faults/test_rescaled_run.cpp
  LIBRARIES clog_dem LABELS faults)
target_compile_definitions(test_killed PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>")
add_dependencies(test_killed clog)
clog_tests(test_killed_ranks
  SOURCES faults/test_killed_ranks.cpp
  LIBRARIES clog_dem LABELS faults)
target_compile_definitions(test_killed_ranks PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>")
add_dependencies(test_killed_ranks clog)
clog_tests(test_scene_limits
  SOURCES faults/test_scene_bounds.cpp faults/test_corner_cases.cpp faults/test_found_by_fuzzing.cpp faults/test_forged_states.cpp
  LIBRARIES clog_dem LABELS faults)
clog_tests(test_until
  SOURCES faults/test_until.cpp faults/test_time_limit.cpp
  LIBRARIES clog_dem clog_postprocess LABELS faults)
target_compile_definitions(test_until PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>")
add_dependencies(test_until clog)
clog_tests(test_longer_calls
  SOURCES faults/test_longer_calls.cpp
  LIBRARIES clog_dem LABELS faults)
target_compile_definitions(test_longer_calls PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>")
add_dependencies(test_longer_calls clog)
add_library(odd_system SHARED faults/odd_system.c)
target_link_libraries(odd_system PRIVATE ${CMAKE_DL_LIBS})
clog_tests(test_odd_systems
  SOURCES faults/test_odd_systems.cpp
  LIBRARIES clog_ensemble LABELS faults)
target_compile_definitions(test_odd_systems PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>"
  CLOG_ODD_SYSTEM="$<TARGET_FILE:odd_system>")
add_dependencies(test_odd_systems clog odd_system)

# The sanitizers must be the first library of a program, and the preloaded one would be.
if(NOT CLOG_SANITIZE)
  add_library(crash_shim MODULE faults/crash_shim.c)
  target_compile_options(crash_shim PRIVATE -Wall -Wextra)
  foreach(verb walls case map run stats report export trade)
    add_test(NAME crash_points.${verb} COMMAND /usr/bin/python3 -B ${CMAKE_CURRENT_SOURCE_DIR}/faults/crash_points.py
             $<TARGET_FILE:clog> $<TARGET_FILE:crash_shim> ${verb})
    set_tests_properties(crash_points.${verb} PROPERTIES LABELS faults TIMEOUT ${test_time_limit})
  endforeach()
endif()
