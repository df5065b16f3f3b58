# Habits that hold by themselves: how sources are written. `./Alltest --nightly` looks at all of them with clang.
set(habits ${CMAKE_CURRENT_SOURCE_DIR}/habits)
add_test(NAME Format COMMAND ${habits}/format)
add_test(NAME EveryUnitHasItsTest COMMAND ${habits}/units)
add_test(NAME ArrowsOfTheArchitecture COMMAND ${habits}/arrows)
add_test(NAME ChangedSourcesUnderClang COMMAND ${habits}/clang_sources syntax changed ${CMAKE_BINARY_DIR}/clang)
set_tests_properties(Format EveryUnitHasItsTest ArrowsOfTheArchitecture ChangedSourcesUnderClang
  PROPERTIES
  LABELS habits SKIP_RETURN_CODE 77 TIMEOUT ${test_time_limit})
