find_package(benchmark REQUIRED)
add_executable(bench_step benchmarks/bench_step.cpp)
target_link_libraries(bench_step PRIVATE clog_dem benchmark::benchmark GTest::gtest)
target_compile_definitions(bench_step PRIVATE CLOG_TEST_DATA="${CMAKE_CURRENT_SOURCE_DIR}/reference")
