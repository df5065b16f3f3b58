// In the place of dem/kernels/select.cpp: the other instruction sets are written for g++.
#include "dem/kernels/kernels.hpp"

namespace clogflow {

const Kernels& select_kernels(const char*) { return kernels_x86_64; }

}  // namespace clogflow
