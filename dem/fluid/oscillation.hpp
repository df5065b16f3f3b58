// A prescribed factor on the whole flow: a pump that pulsates, ramps, flow that goes back.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// q(t) on V0(x), which keeps its shape:
///   sine    1 + A sin(2 pi (f t + phase))
///   square  1 + A sgn of that sine
///   table   linear between its rows; before the first and behind the last as in these
/// Neglects that a flow needs the time rho (H/2)^2 / eta to follow, which a Womersley number well below 1 allows (clog
/// plan prints it), and, where it goes back, that a flow with inertia is not its own mirror image.
class Oscillation {
public:
  Oscillation() = default;
  /// \throws Error if the table cannot be read
  explicit Oscillation(const Scene& scene);

  bool on() const { return amplitude_ > 0 || !table_.empty(); }

  double factor(double time) const;   ///< q [-]
  double largest() const;             ///< of |q| [-]
  bool reverses() const;              ///< whether q is ever below 0
  bool is_steady(double time) const;  ///< whether q stays as it is from then on

  /// Volume of the longest way back over the flow rate of V0 [s]; infinite if it never ends.
  double longest_return() const;

  /// Frequency of a sine that changes as fast, over the largest |q| [Hz]
  double frequency() const;

private:
  struct Row {
    double time, factor;  // [s], [-]
  };
  static std::vector<Row> read_table(const std::string& file);
  double least() const;

  double amplitude_ = 0, frequency_ = 0, phase_ = 0;
  bool square_ = false;
  std::vector<Row> table_;
};

/// Refuses a flow that goes back where particles could not: past the end of a channel they are gone, so what comes
/// back must come from behind the neck and before that end.
/// \throws Error naming the key, the volume that goes back and the one that there is
void check_return(const Scene& scene, const Oscillation& oscillation);

/// Share of the volume behind the neck that may go back at most: the middle of a profile goes twice as far as its
/// mean [-].
inline constexpr double returning_share = 0.5;

}  // namespace clogflow
