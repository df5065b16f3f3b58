clog_tests(test_stability
  SOURCES trade/test_stability.cpp trade/test_stability_terms.cpp trade/test_step_trials.cpp
  LIBRARIES clog_trade LABELS slow)
clog_tests(test_trade
  SOURCES trade/test_observables.cpp trade/test_response.cpp trade/test_fidelity.cpp trade/test_study.cpp
  LIBRARIES clog_trade LABELS slow)
