// flow.h5, mutated.
#include "coupling/flow_grid.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clog::fuzz::try_input([&] { clog::read_flow_grid(clog::fuzz::as_file(data, size)); });
}
