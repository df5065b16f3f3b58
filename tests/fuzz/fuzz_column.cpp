// The column of numbers that `clog fit` reads.
#include "coupling/base/number_column.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clogflow::fuzz::try_input([&] {
    clogflow::fuzz::must(!clogflow::postprocess::read_number_column(clogflow::fuzz::as_file(data, size)).empty(),
                         "a column is not empty");
  });
}
