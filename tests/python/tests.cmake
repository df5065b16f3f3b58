# The package of python/, on files that the program writes, and the notebooks that show it.
foreach(part files statistics program export film lengths page terminal)
  add_test(NAME python.${part} COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/python/run_test test_${part} $<TARGET_FILE:clog>)
  set_tests_properties(python.${part} PROPERTIES LABELS pipeline SKIP_RETURN_CODE 77 TIMEOUT ${test_time_limit})
endforeach()
add_test(NAME python.notebooks COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/python/run_test test_notebooks $<TARGET_FILE:clog>)
set_tests_properties(python.notebooks PROPERTIES LABELS pipeline SKIP_RETURN_CODE 77 TIMEOUT ${test_time_limit} PROCESSORS 2)
