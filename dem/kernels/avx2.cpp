// The hot loops for avx2; CMakeLists.txt gives this file its own compiler flags.
#include "dem/kernels/table.hpp"

namespace clogflow {

const Kernels kernels_avx2 = make_kernels("avx2");

}  // namespace clogflow
