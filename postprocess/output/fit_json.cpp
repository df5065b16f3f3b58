// Fits as JSON.
#include "postprocess/output/fit_json.hpp"

#include <cmath>

namespace clogflow::postprocess {
namespace {

using nlohmann::json;

json as_json(const RivalTest& test) {
  return {{"rate", number_or_null(test.rate)},
          {"log_likelihood_ratio", test.log_ratio},
          {"normalized_ratio", test.normalized},
          {"p_value", test.p_value},
          {"favoured", favoured(test)}};
}

}  // namespace

json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(); }

json as_json(const Estimate& estimate) {
  json result{{"value", number_or_null(estimate.value)},
              {"low", number_or_null(estimate.low)},
              {"high", number_or_null(estimate.high)}};
  if (!estimate.note.empty()) result["note"] = estimate.note;
  return result;
}

json as_json(const TailFit& fit) {
  json result{{"discrete", fit.kind == Values::whole},
              {"alpha", fit.law.alpha},
              {"xmin", fit.law.xmin},
              {"xmin_from", fit.bootstrap.lower_end == LowerEnd::fixed ? "given" : "scan"},
              {"sigma", fit.law.sigma},
              {"n", fit.law.n},
              {"n_tail", fit.law.n_tail},
              {"ks", fit.law.ks},
              {"ties", rule_for_ties(fit.kind)},
              {"exponential", as_json(fit.exponential)}};
  if (fit.law.n_tail < rough_below) result["warning"] = "fewer than 50 values in the tail: alpha is rough";
  if (fit.p_value) {
    result["p_value"] = *fit.p_value;
    result["p_value_error"] = p_value_error(*fit.p_value, fit.bootstrap.replicates);
    result["p_value_replicates"] = fit.bootstrap.replicates;
    result["seed"] = fit.bootstrap.seed;
  }
  return result;
}

json as_json(const ArrestFit& fit) {
  json result{{"alpha", fit.law.parameter},
              {"sigma", fit.law.sigma},
              {"n_complete", fit.law.complete},
              {"n_censored", fit.law.censored},
              {"exponential", as_json(fit.exponential)},
              {"ks", fit.survival.ks},
              {"largest_miss_at", fit.survival.at},
              {"standard_errors", fit.survival.standard_errors}};
  result.update(verdict_json(fit));
  if (fit.p_value_replicates > 0) {
    result["p_value_error"] = fit.survival.p_error;
    result["p_value_replicates"] = fit.p_value_replicates;
  }
  return result;
}

json verdict_json(const ArrestFit& fit) {
  json result{{"verdict", fit.verdict.words}};
  if (fit.p_value_replicates > 0) {
    result["p_value"] = fit.survival.p_value;
    result["ruled_out"] = fit.verdict.ruled_out;
  }
  return result;
}

}  // namespace clogflow::postprocess
