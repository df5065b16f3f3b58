clog_tests(test_stability
  SOURCES trade/test_stability.cpp
  LIBRARIES clog_trade LABELS slow)
