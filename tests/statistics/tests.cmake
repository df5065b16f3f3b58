# free_bursts is a part of ./Alltest --nightly. committor FLOW SEED AGE WITHIN COPIES PUSH is for docs/reports/bridging.md.
clog_tests(test_pushed_copies
  SOURCES statistics/test_pushed_copies.cpp statistics/pushed_copies.cpp
  LIBRARIES clog_dem LABELS unit)
add_executable(committor statistics/committor.cpp statistics/pushed_copies.cpp)
target_link_libraries(committor PRIVATE clog_dem)
add_test(NAME bridging_parts COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/statistics/test_bridging)
add_test(NAME first_clog_law COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/statistics/test_first_clog_law)
add_test(NAME results_verdicts COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/statistics/test_results_verdicts)
set_tests_properties(bridging_parts first_clog_law results_verdicts PROPERTIES SKIP_RETURN_CODE 77 LABELS unit TIMEOUT ${test_time_limit})
