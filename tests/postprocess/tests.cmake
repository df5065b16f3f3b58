clog_tests(test_postprocess
  SOURCES
    postprocess/test_bursts.cpp
    postprocess/test_censored.cpp
    postprocess/test_confidence.cpp
    postprocess/test_number_column.cpp
    postprocess/test_power_law.cpp
    postprocess/test_statistics_files.cpp
  LIBRARIES clog_postprocess
  LABELS unit
)
