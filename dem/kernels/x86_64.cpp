// The hot loops for x86-64; CMakeLists.txt gives this file its own compiler flags.
#include "dem/kernels/table.hpp"

namespace clogflow {

const Kernels kernels_x86_64 = make_kernels("x86_64");

}  // namespace clogflow
