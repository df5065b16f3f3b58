# Installed programs, the package and the recipes; nothing is built for them.
set(installs ${CMAKE_CURRENT_SOURCE_DIR}/install)
add_test(NAME InstalledProgram COMMAND ${installs}/installed_program ${CMAKE_BINARY_DIR} $<TARGET_FILE:clog>)
add_test(NAME DebianPackage COMMAND ${installs}/debian_package ${CMAKE_BINARY_DIR})
add_test(NAME OneVersion COMMAND ${installs}/one_version $<TARGET_FILE:clog>)
add_test(NAME Recipes COMMAND ${installs}/recipes)
set_tests_properties(InstalledProgram DebianPackage OneVersion Recipes PROPERTIES
  LABELS pipeline SKIP_RETURN_CODE 77 TIMEOUT ${test_time_limit})
