clog_tests(test_postprocess
  SOURCES
    postprocess/events/test_bursts.cpp
    postprocess/events/test_first_burst.cpp
    postprocess/laws/test_censored.cpp
    postprocess/laws/test_confidence.cpp
    postprocess/laws/test_discrete_power_law.cpp
    postprocess/laws/test_geometric_law.cpp
    postprocess/laws/test_hazard.cpp
    coupling/base/test_number_column.cpp
    postprocess/laws/test_power_law.cpp
    postprocess/laws/test_sequences.cpp
    postprocess/summary/test_burst_order.cpp
    postprocess/summary/test_first_burst_statistics.cpp
    postprocess/summary/test_quantities.cpp
    postprocess/summary/test_size_statistics.cpp
    postprocess/output/test_statistics_files.cpp
    postprocess/summary/test_stopping_rule.cpp
    postprocess/summary/test_sweeps.cpp
    postprocess/laws/test_weighted_line.cpp
  LIBRARIES clog_postprocess
  LABELS unit
)

# Starts python and the program itself, so it is slower than a unit test.
clog_tests(test_postprocess_programs
  SOURCES
    postprocess/output/test_real_runs.cpp
    postprocess/output/test_report.cpp
    postprocess/output/test_verbs.cpp
  LIBRARIES clog_postprocess
  LABELS pipeline
)
target_compile_definitions(test_postprocess_programs PRIVATE CLOG_PROGRAM="$<TARGET_FILE:clog>")
add_dependencies(test_postprocess_programs clog)
