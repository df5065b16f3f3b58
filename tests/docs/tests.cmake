# Links of all pages, and the paths that the pages for newcomers name.
add_test(NAME DocumentationLinks COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/docs/test_links)
set_tests_properties(DocumentationLinks PROPERTIES LABELS unit SKIP_RETURN_CODE 77)
