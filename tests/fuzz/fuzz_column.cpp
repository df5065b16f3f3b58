// The column of numbers that `clog fit` reads.
#include "postprocess/number_column.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clog::fuzz::try_input([&] { clog::fuzz::must(!clog::postprocess::read_number_column(clog::fuzz::as_file(data, size)).empty(), "a column is not empty"); });
}
