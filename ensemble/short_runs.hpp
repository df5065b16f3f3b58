// Finished runs that are to be lengthened get another name before any work begins.
#pragma once

#include "ensemble/seed_run.hpp"

namespace clogflow {

/// So that what stands as a run file is done. What is wrong with it is said when the seed's turn comes.
void set_aside_if_short(const Ensemble& ensemble, const std::string& inputs, std::uint64_t seed);

}  // namespace clogflow
