// Chooses the instruction set when the program starts.

#include <string>

#include "coupling/base/environment.hpp"
#include "coupling/base/require.hpp"
#include "dem/kernels/kernels.hpp"

namespace clogflow {

namespace {

bool processor_has(const Kernels& kernels) {
  if (&kernels == &kernels_avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("fma");
  if (&kernels == &kernels_avx2)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  return true;
}

}  // namespace

const Kernels& select_kernels(const char* wanted) {
  const std::string chosen = wanted ? wanted : environment("CLOG_ISA").value_or("");
  // Fastest first.
  for (const Kernels* kernels : {&kernels_avx512, &kernels_avx2, &kernels_x86_64}) {
    if (!chosen.empty() && chosen != kernels->name) continue;
    if (processor_has(*kernels)) return *kernels;
    require(chosen.empty(), "CLOG_ISA = {} (this processor lacks it): unset it", chosen);
  }
  throw Error(fmt::format("CLOG_ISA = {} (must be avx512, avx2 or x86_64)", chosen));
}

}  // namespace clogflow
