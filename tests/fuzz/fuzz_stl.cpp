// Walls from an STL file, text or binary.
#include "coupling/stl.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clog::fuzz::try_input([&] { clog::fuzz::must(!clog::read_stl(clog::fuzz::as_file(data, size)).empty(), "walls are not empty"); });
}
