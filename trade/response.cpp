#include "trade/response.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>

#include "coupling/base/require.hpp"

namespace clogflow::trade {

namespace {

constexpr double reference_modulus = 10e6, reference_mass = 30;  // doses of 1
constexpr double paper_modulus = 3e9;                            // [Pa]
constexpr double to_95 = 1.96;                                   // standard errors that make a 95 % interval
constexpr int unknowns = 4;                                      // the value without any dose, and a slope for each

std::array<double, 3> in_order(const Doses& doses, double overlap_power) {
  return {std::pow(doses.softness, overlap_power), doses.mass, doses.step};
}

double softness_of(double modulus) { return std::pow(modulus / reference_modulus, -2.0 / 3.0); }

Eigen::Vector4d row_of(const Doses& doses, double overlap_power) {
  const auto [softness, mass, step] = in_order(doses, overlap_power);
  return {1, softness, mass, step};
}

}  // namespace

Doses doses_of(const Scene& scene, double step_over_limit) {
  return {softness_of(scene.contact.youngs_modulus), scene.time.mass_scale / reference_mass,
          step_over_limit * step_over_limit};
}

bool is_small(const Doses& doses) { return doses.mass <= 1; }

Difference Response::from_paper(const Doses& doses, bool is_share) const {
  const std::array<double, 3> here = in_order(doses, overlap_power),
                              paper = in_order({softness_of(paper_modulus), 1 / reference_mass, 0}, overlap_power);
  double change = 0, square = 0;
  for (int k = 0; k < 3; ++k) {
    change += slope[k] * (here[k] - paper[k]);
    for (int l = 0; l < 3; ++l) square += (here[k] - paper[k]) * variance[k][l] * (here[l] - paper[l]);
  }
  const auto shown = [&](double value) { return is_share ? value : std::expm1(value); };
  const double reach = to_95 * std::sqrt(square);
  return {.difference = shown(change), .low = shown(change - reach), .high = shown(change + reach)};
}

Response fit_response(const std::vector<Answer>& answers, bool is_share, const std::optional<KnownSlope>& step,
                      double overlap_power) {
  const int f = static_cast<int>(answers.size()) + (step ? 1 : 0) - unknowns;
  require(f >= 1,
          "{} settings cannot show how an observable answers to three doses (5 can, or 4 with --step-from): run "
          "more",
          answers.size());
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  const auto height = [&](const Answer& a) { return is_share ? a.spread.value : std::log(a.spread.value); };
  for (const Answer& a : answers) {
    require(
        std::isfinite(height(a)) && std::isfinite(a.spread.error) && a.spread.error > 0,
        "a setting has no value with an error (too few clogs, or nothing of the kind was recorded): run more seeds");
    const double weight = 1 / (a.spread.error * a.spread.error);
    const Eigen::Vector4d row = row_of(a.doses, overlap_power);
    normal += weight * row * row.transpose();
    right += weight * height(a) * row;
  }
  if (step) {
    const double weight = 1 / (step->error * step->error);
    normal(3, 3) += weight;
    right[3] += weight * step->value;
  }
  const Eigen::FullPivLU<Eigen::Matrix4d> solver(normal);
  require(solver.isInvertible(), "the settings that ran do not tell softness, mass and step apart: run others too");
  const Eigen::Vector4d law = solver.solve(right);
  Response response{.overlap_power = overlap_power, .degrees_of_freedom = f};
  for (const Answer& a : answers) {
    const double miss = (height(a) - law.dot(row_of(a.doses, overlap_power))) / a.spread.error;
    response.chi_squared += miss * miss;
  }
  if (step) response.chi_squared += std::pow((law[3] - step->value) / step->error, 2);
  namespace bm = boost::math;
  response.p_value = bm::cdf(bm::complement(bm::chi_squared(f), response.chi_squared));
  const Eigen::Matrix4d variance = std::max(1.0, response.chi_squared / f) * solver.inverse();
  for (int k = 0; k < 3; ++k) {
    response.slope[k] = law[k + 1];
    response.error[k] = std::sqrt(variance(k + 1, k + 1));
    response.low[k] = response.slope[k] - to_95 * response.error[k];
    response.high[k] = response.slope[k] + to_95 * response.error[k];
    for (int l = 0; l < 3; ++l) response.variance[k][l] = variance(k + 1, l + 1);
  }
  return response;
}

}  // namespace clogflow::trade
