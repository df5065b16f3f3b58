# The whole comparison takes a minute and two programs: tests/same_bits OLD NEW. Here: that it can fail.
add_test(NAME same_bits_can_fail COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/oracle/test_same_bits $<TARGET_FILE:clog>)
set_tests_properties(same_bits_can_fail PROPERTIES LABELS slow TIMEOUT ${test_time_limit})
