// Walls from an STL file, text or binary, and their triangles joined.
#include "coupling/geometry/stl.hpp"
#include "coupling/geometry/wall_mesh.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clogflow::fuzz::try_input([&] {
    const clogflow::Walls walls = clogflow::read_stl(clogflow::fuzz::as_file(data, size));
    clogflow::fuzz::must(!walls.empty(), "walls are not empty");
    clogflow::open_rims(clogflow::join_walls(walls));
  });
}
