// How an observable answers to the numerics: a first-order law through all settings of a study, which bounds the
// difference of each from the particles that no run could afford.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "coupling/scene/scene.hpp"
#include "trade/observables.hpp"

namespace clogflow::trade {

/// How far a setting is from hard particles without extra mass and an exact step; 1 for each is 10 MPa, mass x 30
/// and a step at the limit of the contacts.
struct Doses {
  double softness = 0;  ///< overlap over diameter, as E^(-2/3) of Hertz' contacts [-]
  double mass = 0;      ///< Stokes number: mass scale [-]
  double step = 0;      ///< square of the step over the limit of the contacts: velocity-Verlet is of second order [-]
};

inline constexpr std::array<const char*, 3> dose_names{"softness", "mass", "step"};

/// Whether the law of first order speaks of this mass. Beyond some 30 its effect saturates: at D/d = 2.13 the packing
/// near the neck is 0.371, 0.373, 0.377, 0.400, 0.439, 0.464 for 1, 3, 10, 30, 100, 300 times the true mass.
/// \measured docs/reports/trade.md
bool is_small(const Doses& doses);

/// \param step_over_limit  as measured, mean over the runs
Doses doses_of(const Scene& scene, double step_over_limit);

/// What a response is fitted to.
struct Answer {
  Doses doses;
  Spread spread;  ///< of the observable
};

/// ln(value) = c + sum_k a_k dose_k, or the value itself for a share: weighted least squares. Where the settings
/// scatter beyond their errors, these grow by the root of chi squared over its degrees of freedom. \source Particle
/// Data Group, Review of Particle Physics, introduction 5.2.2 (scale factor)
struct Response {
  double overlap_power = 1;                         ///< the dose of softness is taken to this power
  std::array<double, 3> slope{};                    ///< a_k: change for a dose of 1 [-]
  std::array<double, 3> error{};                    ///< standard error of a_k [-]
  std::array<double, 3> low{}, high{};              ///< 95 % interval of a_k [-]
  std::array<std::array<double, 3>, 3> variance{};  ///< of the a_k together [-]
  double chi_squared = 0;
  int degrees_of_freedom = 0;
  double p_value = 1;  ///< that errors alone scatter the settings this far from the law

  /// The difference of `doses` from the paper's particles (3 GPa, true mass, exact step), with its 95 % interval.
  /// \param is_share  absolute, not relative
  Difference from_paper(const Doses& doses, bool is_share) const;
};

/// A slope as another study found it.
struct KnownSlope {
  double value = 0, error = 0;
};

/// \param step  the response to the step in another study, a further measurement: it acts on contacts, whatever D/d
/// \throws Error with fewer measurements than unknowns + 1, or if they do not tell the doses apart
Response fit_response(const std::vector<Answer>& answers, bool is_share, const std::optional<KnownSlope>& step = {},
                      double overlap_power = 1);

}  // namespace clogflow::trade
