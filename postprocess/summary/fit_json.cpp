// Fits as JSON.
#include "postprocess/summary/fit_json.hpp"

#include <cmath>

namespace clogflow::postprocess {
namespace {

RivalTest against_exponential(const SortedSample& sample, const PowerLawFit& fit) {
  if (sample.kind() == Values::whole) {
    std::vector<double> tail;
    for (std::size_t i = sample.lower_bound(fit.xmin); i < sample.size(); ++i) tail.push_back(sample.value(i));
    return discrete_power_law_against_exponential(tail, fit.xmin, fit.alpha);
  }
  std::vector<Observation> tail;
  for (std::size_t i = sample.lower_bound(fit.xmin); i < sample.size(); ++i) tail.push_back({sample.value(i), false});
  return power_law_against_exponential(tail, fit.xmin);
}

}  // namespace

nlohmann::json number_or_null(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); }

nlohmann::json as_json(const Estimate& estimate) {
  nlohmann::json json{{"value", number_or_null(estimate.value)},
                      {"low", number_or_null(estimate.low)},
                      {"high", number_or_null(estimate.high)}};
  if (!estimate.note.empty()) json["note"] = estimate.note;
  return json;
}

nlohmann::json as_json(const RivalTest& test) {
  const char* verdict = test.p_value > 0.1 ? "undecided" : test.log_ratio > 0.0 ? "power law" : "exponential";
  return {{"rate", number_or_null(test.rate)},
          {"log_likelihood_ratio", test.log_ratio},
          {"normalized_ratio", test.normalized},
          {"p_value", test.p_value},
          {"favoured", verdict}};
}

nlohmann::json fit_as_json(const SortedSample& sample, const FitRequest& request) {
  const PowerLawFit fit = request.xmin ? fit_power_law(sample, *request.xmin) : fit_power_law(sample);
  nlohmann::json json{{"discrete", sample.kind() == Values::whole},
                      {"alpha", fit.alpha},
                      {"xmin", fit.xmin},
                      {"xmin_from", request.xmin ? "given" : "scan"},
                      {"sigma", fit.sigma},
                      {"n", fit.n},
                      {"n_tail", fit.n_tail},
                      {"ks", fit.ks},
                      {"ties", rule_for_ties(sample.kind())},
                      {"exponential", as_json(against_exponential(sample, fit))}};
  if (fit.n_tail < rough_below) {
    json["warning"] = "fewer than 50 values in the tail: alpha is rough";
  }
  if (request.p_value) {
    const Bootstrap bootstrap{*request.p_value, request.seed, request.xmin ? LowerEnd::fixed : LowerEnd::scanned};
    const double p = goodness_of_fit(sample, fit, bootstrap);
    json["p_value"] = p;
    json["p_value_error"] = p_value_error(p, bootstrap.replicates);
    json["p_value_replicates"] = bootstrap.replicates;
    json["seed"] = request.seed;
  }
  return json;
}

}  // namespace clogflow::postprocess
