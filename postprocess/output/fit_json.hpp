// Fits as JSON: the same keys in `clog fit` and in stats.json.
#pragma once

#include <nlohmann/json.hpp>

#include "postprocess/laws/tail_fit.hpp"
#include "postprocess/summary/event_statistics.hpp"

namespace clogflow::postprocess {

/// A number, or null where it is not finite (JSON has no NaN).
nlohmann::json number_or_null(double value);

/// value, low, high (null where unknown), and the note if there is one.
nlohmann::json as_json(const Estimate& estimate);

/// discrete (whether the law is one on whole numbers), alpha, xmin, sigma, n, n_tail, ks, ties, exponential {...};
/// p_value, p_value_error, p_value_replicates, seed when asked; warning when the tail has fewer than 50 values.
nlohmann::json as_json(const TailFit& fit);

/// alpha, sigma, n_complete, n_censored, exponential {...}, ks, largest_miss_at, standard_errors; p_value_error,
/// p_value_replicates if it was tested; and as verdict_json.
nlohmann::json as_json(const ArrestFit& fit);

/// verdict; p_value and ruled_out if it was tested.
nlohmann::json verdict_json(const ArrestFit& fit);

}  // namespace clogflow::postprocess
