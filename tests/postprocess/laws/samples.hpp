// Samples from known laws, and refusals as text.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "coupling/base/random_stream.hpp"
#include "coupling/base/require.hpp"

namespace clogflow::postprocess {

inline std::vector<double> pareto_sample(std::size_t n, double alpha, RandomStream random) {
  std::vector<double> values(n);
  for (double& x : values) x = std::pow(1.0 - random.uniform(), -1.0 / (alpha - 1.0));
  return values;
}

inline std::vector<double> exponential_sample(std::size_t n, double mean, RandomStream random) {
  std::vector<double> values(n);
  for (double& x : values) x = -mean * std::log(1.0 - random.uniform());
  return values;
}

/// The text of the Error that an action throws; "accepted" when it throws none.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace clogflow::postprocess
