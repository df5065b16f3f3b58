clog_tests(test_postprocess
  SOURCES
    postprocess/test_bursts.cpp
    postprocess/test_censored.cpp
    postprocess/test_confidence.cpp
    postprocess/test_discrete_power_law.cpp
    postprocess/test_geometric_law.cpp
    postprocess/test_number_column.cpp
    postprocess/test_power_law.cpp
    postprocess/test_quantities.cpp
    postprocess/test_statistics_files.cpp
    postprocess/test_stopping_rule.cpp
    postprocess/test_sweeps.cpp
    postprocess/test_weighted_line.cpp
  LIBRARIES clog_postprocess
  LABELS unit
)

# Starts python and the program itself, so it is slower than a unit test.
clog_tests(test_postprocess_programs
  SOURCES
    postprocess/test_real_runs.cpp
    postprocess/test_report.cpp
    postprocess/test_verbs.cpp
  LIBRARIES clog_postprocess
  LABELS pipeline
)
target_compile_definitions(test_postprocess_programs PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>")
add_dependencies(test_postprocess_programs clog)
