// run_NNNN.h5, mutated.
#include "coupling/run_file.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clog::fuzz::try_input([&] { clog::read_run_file(clog::fuzz::as_file(data, size)); });
}
