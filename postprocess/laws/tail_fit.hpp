// A power-law fit with what must be said beside it: the rival, and whether the law describes the data at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "postprocess/laws/goodness_of_fit.hpp"
#include "postprocess/laws/power_law.hpp"
#include "postprocess/laws/rival.hpp"

namespace clogflow::postprocess {

/// What is fitted and how.
struct FitRequest {
  std::optional<double> xmin;          ///< absent: found by the scan
  std::size_t p_value_replicates = 0;  ///< of the goodness of fit; 0: no test
  std::uint64_t seed = 1;
};

struct TailFit {
  PowerLawFit law;
  Values kind = Values::continuous;
  RivalTest exponential;
  Bootstrap bootstrap;            ///< behind the p-value, and whether x_min was scanned
  std::optional<double> p_value;  ///< absent: not asked
};

/// \throws Error as fit_power_law
TailFit fit_tail(const SortedSample& sample, const FitRequest& request);

/// Why there is no fit.
struct Refusal {
  std::string why;
};

template <class Fit>
using FitOrRefusal = std::variant<Refusal, Fit>;

}  // namespace clogflow::postprocess
