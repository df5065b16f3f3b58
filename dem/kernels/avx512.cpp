// The hot loops for avx512; CMakeLists.txt gives this file its own compiler flags.
#include "dem/kernels/table.hpp"

namespace clogflow {

const Kernels kernels_avx512 = make_kernels("avx512");

}  // namespace clogflow
