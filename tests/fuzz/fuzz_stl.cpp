// Walls from an STL file, text or binary, and their triangles joined.
#include "coupling/stl.hpp"
#include "coupling/wall_mesh.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clog::fuzz::try_input([&] {
    const clog::Walls walls = clog::read_stl(clog::fuzz::as_file(data, size));
    clog::fuzz::must(!walls.empty(), "walls are not empty");
    clog::open_rims(clog::join_walls(walls));
  });
}
