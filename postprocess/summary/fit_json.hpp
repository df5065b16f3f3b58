// Fits as JSON: the same keys in `clog fit` and in stats.json.
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "postprocess/laws/confidence.hpp"
#include "postprocess/laws/goodness_of_fit.hpp"
#include "postprocess/laws/power_law.hpp"
#include "postprocess/laws/rival.hpp"

namespace clogflow::postprocess {

/// A number, or null where it is not finite (JSON has no NaN).
nlohmann::json number_or_null(double value);

/// value, low, high (null where unknown), and the note if there is one.
nlohmann::json as_json(const Estimate& estimate);

/// What is fitted and how.
struct FitRequest {
  std::optional<double> xmin;          ///< absent: found by the scan
  std::optional<std::size_t> p_value;  ///< replicates; absent: no test
  std::uint64_t seed = 1;
};

/// discrete (whether the law is one on whole numbers), alpha, xmin, sigma, n, n_tail, ks, ties, exponential {...};
/// p_value, p_value_error, p_value_replicates, seed when asked; warning when the tail has fewer than 50 values. \throws
/// Error as fit_power_law
nlohmann::json fit_as_json(const SortedSample& sample, const FitRequest& request);

nlohmann::json as_json(const RivalTest& test);

}  // namespace clogflow::postprocess
