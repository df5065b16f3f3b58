# Links of all pages, and the paths that the pages for newcomers name.
add_test(NAME DocumentationLinks COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/docs/test_links)
set_tests_properties(DocumentationLinks PROPERTIES LABELS unit SKIP_RETURN_CODE 77)

# All forms of the key reference.
add_test(NAME KeyReferenceForms COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/docs/test_keys $<TARGET_FILE:clog>)
set_tests_properties(KeyReferenceForms PROPERTIES LABELS unit SKIP_RETURN_CODE 77 TIMEOUT ${test_time_limit})

# The site, and the pages that are made; the commands of the pages, those of the tutorial and the cookbook run.
add_test(NAME DocumentationSite COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/docs/test_site)
add_test(NAME DocumentationCommands COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/docs/test_commands $<TARGET_FILE:clog>)
set_tests_properties(DocumentationSite DocumentationCommands PROPERTIES
  LABELS pipeline SKIP_RETURN_CODE 77 TIMEOUT ${test_time_limit})
