# `tests/fuzz/run 600` tries the readers for long. As a part of ctest only on request (CLOG_FUZZ=1 when
# configuring): building ten fuzzers takes longer than all other tests.
if(NOT DEFINED ENV{CLOG_FUZZ})
  return()
endif()
# A few seconds a reader; `tests/fuzz/run 600` for long. Skipped, with a line, where clang is missing.
add_test(NAME fuzz_build COMMAND ${CMAKE_CURRENT_LIST_DIR}/run 0 ${CMAKE_BINARY_DIR}/fuzz)
set_tests_properties(fuzz_build PROPERTIES LABELS fuzz SKIP_RETURN_CODE 77 TIMEOUT 1200 FIXTURES_SETUP fuzzers)
add_test(NAME fuzz_readers COMMAND ${CMAKE_CURRENT_LIST_DIR}/run 3 ${CMAKE_BINARY_DIR}/fuzz)
set_tests_properties(fuzz_readers PROPERTIES LABELS fuzz SKIP_RETURN_CODE 77 TIMEOUT 600 FIXTURES_REQUIRED fuzzers)
