clog_tests(test_flow_coarse
  SOURCES pipeline/test_flow_coarse.cpp pipeline/test_flow_error.cpp pipeline/test_flow_stl.cpp
  LIBRARIES clog_coupling LABELS flow)

# Not gtest_discover_tests: one process, because its tests share one solution of half a minute.
add_executable(test_flow_reference pipeline/test_flow_reference.cpp)
target_link_libraries(test_flow_reference PRIVATE clog_dem clog_test_support GTest::gtest_main)
# The night runs all of it: ./Alltest --nightly flow.
add_test(NAME FlowReference COMMAND test_flow_reference --gtest_filter=-StlReference.*)
set_tests_properties(FlowReference PROPERTIES LABELS flow TIMEOUT 600)
