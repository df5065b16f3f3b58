# A few seconds a reader; `tests/fuzz/run 600` for long. Skipped, with a line, where clang is missing. Without CLOG_FUZZ=1
# (when configuring) only the readers of files that others hand over, built without the solver: a minute of one core.
set(fuzzed scene samples stl flow_file run_file)
if(DEFINED ENV{CLOG_FUZZ})
  set(fuzzed)  # all
endif()
add_test(NAME fuzz_build COMMAND ${CMAKE_CURRENT_LIST_DIR}/run 0 ${CMAKE_BINARY_DIR}/fuzz ${fuzzed})
set_tests_properties(fuzz_build PROPERTIES LABELS fuzz SKIP_RETURN_CODE 77 TIMEOUT 1200 FIXTURES_SETUP fuzzers)
add_test(NAME fuzz_readers COMMAND ${CMAKE_CURRENT_LIST_DIR}/run 4 ${CMAKE_BINARY_DIR}/fuzz ${fuzzed})
set_tests_properties(fuzz_readers PROPERTIES LABELS fuzz SKIP_RETURN_CODE 77 TIMEOUT 600 FIXTURES_REQUIRED fuzzers)
