// The stability map's second family: the columns of the first with one more term of the program each.
#pragma once

#include <string>
#include <vector>

#include "trade/stability.hpp"

namespace clogflow {

/// What a point has beside its column of equal spheres.
enum class Term {
  sizes,       ///< large and small spheres by turns
  densities,   ///< heavy and light ones by turns
  frictions,   ///< rough and smooth ones by turns
  jkr,         ///< spheres that stick, soft ones
  dmt,         ///< and hard ones
  hooke,       ///< linear springs
  mercury,     ///< the other rolling and torsion
  beetstra,    ///< a drag that grows with the slip
  gravity,     ///< spheres that are heavier than the liquid
  drive,       ///< an oscillation, which may turn back
  local,       ///< a channel with porosity around each sphere
  pressure,    ///< a channel driven by a pressure drop
  compliance,  ///< a channel behind a soft tube
  walls,       ///< walls of another stiffness, films at them, a torque of the fluid
  together     ///< sizes, densities, frictions, a law, drag by slip, gravity and a drive at once
};
inline constexpr int term_count = 15;
std::string name(Term term);

struct TermPoint {
  Term term;
  ExtremePoint base;
  double size_ratio = 1;        ///< large over small diameter, 1 to 10
  double density_ratio = 1;     ///< of the small (every second) over the others, 0.1 to 10
  double friction_share = 1;    ///< of the small (every second) over the others, 0 to 1
  std::string law = "hertz";    ///< contact.law
  double stickiness = 0;        ///< pull-off force over the drag of one sphere, 0.01 to 100
  double spring = 0;            ///< of law hooke, over E d, 0.001 to 1
  bool mercury = false;         ///< contact.turning
  std::string drag = "hoef";    ///< drag.law
  double weight = 0;            ///< less buoyancy, over the drag of one sphere, 0.01 to 100
  double amplitude = 0;         ///< of the drive, over the mean flow, 0.1 to 2
  std::string shape = "none";   ///< of the drive: "sine", "square", or "random" about the mean
  int periods = 1;              ///< of it in trial_steps of the point's own step, 1 to 20
  double drop_ratio = 1;        ///< pressure drop over that of the empty channel, 1 to 100
  double compliance_steps = 0;  ///< time in which the tube fills, in steps of the point, 10 to 1e4
  double wall_ratio = 1;        ///< Young's modulus of the walls over that of the spheres, 0.01 to 100
};

/// \param number  from 1 on, for each term anew
TermPoint term_point(Term term, int number);

/// Refuses, or measures, as for equal spheres. Throws nothing.
StepVerdict measure(const TermPoint& point);

}  // namespace clogflow
