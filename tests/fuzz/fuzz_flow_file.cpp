// flow.h5, mutated.
#include "coupling/files/flow_grid.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clogflow::fuzz::try_input([&] { clogflow::read_flow_grid(clogflow::fuzz::as_file(data, size)); });
}
