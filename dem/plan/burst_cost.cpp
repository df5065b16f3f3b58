#include "dem/plan/burst_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "coupling/geometry/channel_geometry.hpp"
#include "coupling/scene/particle_sizes.hpp"
#include "coupling/scene/unclog_protocol.hpp"
#include "dem/plan/plan.hpp"

namespace clogflow {

extern const char* const friction_map;

namespace {

/// D/v of the map's scene, with which its rates scale [s].
constexpr double map_time = 100e-6 / 5e-3;

/// Standard deviation over mean of bursts between restarts and of first bursts, friction 0.6 three times: 0.42 to 0.52
/// in six samples of 48 to 445 bursts at D/d = 2.13 and 2.5 (docs/reports/friction.md, end). Larger ones had 6 seeds,
/// which show 0.26 to 0.46. [-]
constexpr double measured_spread = 0.48;

/// From the last passage until the clog is proved to be at rest, over D/v: 1.4 to 1.6 for restarts, 1.4 to 2.0 for
/// runs that stop; it does not change with the size. [-]
constexpr double proof_time = 1.5;

/// The rate of the map leaves out arrests, which a burst has too. [-]
constexpr double with_arrests = 1.3;

struct Row {
  double ratio, seeds, clogged, mean, rate;
  Friction friction;
};

/// Rows of one law of friction, the default one: cells whose name has letters are variants of it.
std::vector<Row> rows() {
  std::vector<Row> all;
  std::istringstream lines(friction_map);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    constexpr std::size_t needed = 13;
    if (cells.size() < needed || cells[0].find_first_not_of("0123456789_") != std::string::npos) continue;
    const auto number = [&](std::size_t k) { return std::strtod(cells[k].c_str(), nullptr); };
    all.push_back({number(1), number(5), number(6), number(8), number(12), {number(2), number(3), number(4)}});
  }
  return all;
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b)); }

bool same(const Friction& a, const Friction& b) {
  return near(a.sliding, b.sliding) && near(a.rolling, b.rolling) && near(a.torsion, b.torsion);
}

/// What the map was not measured for, or an empty text.
std::string off_map(const Scene& s) {
  const Geometry& g = s.geometry;
  const double right_angle = std::numbers::pi / 2;
  const auto protocol = s.unclog.protocol;
  if (!restarts(protocol) && protocol != UnclogProtocol::stop)
    return "unclog.protocol is neither \"restart\", \"rewind\" nor \"stop\"";
  if (!s.inlet.enabled || s.inlet.start != InletStart::flowing || s.inlet.concentration > 0 || s.inlet.rate > 0)
    return "inlet.start is not \"flowing\", with as many particles as fit";
  if (!g.present || !g.stl.empty() || !near(g.neck_height, g.neck_width) || !near(g.channel_width, 4 * g.neck_width) ||
      !near(g.half_angle, right_angle * 2 / 3))
    return "its neck is square, in a channel four times as wide that narrows at 60 deg";
  if (!ParticleSizes(s.particles).equal()) return "its particles are equal";
  if (s.contact.surface_energy > 0 || s.contact.law != "hertz") return "its contacts are of Hertz, without adhesion";
  if (!s.lubrication.enabled || !s.drag.enabled || s.drag.velocity != DragVelocity::interstitial)
    return "it has lubrication, and drag at the interstitial velocity";
  if (s.flow.balances() || s.flow.oscillation.on() || s.gravity != std::array<double, 3>{})
    return "its flow is steady, without gravity";
  if (!same(s.contact.friction, s.contact.wall_friction)) return "its walls have the friction of the particles";
  return "";
}

/// Exponentially between two points.
double between(double x, double x0, double y0, double x1, double y1) {
  return x1 > x0 ? y0 * std::pow(y1 / y0, (x - x0) / (x1 - x0)) : y0;
}

}  // namespace

double bursts_for(double spread, double share) { return std::ceil(std::pow(1.96 * spread / share, 2)); }

ExpectedBurst expected_burst(const Scene& s) {
  ExpectedBurst burst;
  const auto unknown = [&](const std::string& why) {
    burst.unknown = why;
    return burst;
  };
  if (const std::string why = off_map(s); !why.empty()) return unknown("not measured: " + why);
  const Friction& mu = s.contact.friction;
  std::vector<Row> known;
  for (const Row& row : rows())
    if (same(row.friction, mu)) known.push_back(row);
  if (known.empty())
    return unknown(fmt::format("friction {}, {}, {} (sliding, rolling, torsion) is not on the map", mu.sliding,
                               mu.rolling, mu.torsion));
  const double ratio = s.geometry.neck_width / s.particles.diameter;
  std::ranges::sort(known, {}, &Row::ratio);
  // At the map's smallest D/d nothing passes: bursts begin at the next. Its ratios are rounded.
  std::erase_if(known, [](const Row& row) { return row.mean <= 0; });
  constexpr double rounding = 1e-3;
  if (known.empty() || ratio < known.front().ratio * (1 - rounding) || ratio > known.back().ratio * (1 + rounding))
    return unknown(fmt::format("the map has bursts from D/d = {} to {}, not at {:.3g}",
                               known.empty() ? 0 : known.front().ratio, known.empty() ? 0 : known.back().ratio, ratio));
  const auto above = std::ranges::lower_bound(known, ratio * (1 - rounding), {}, &Row::ratio);
  const Row& high = *above;
  const Row& low = above == known.begin() || near(high.ratio, ratio) || high.ratio < ratio ? high : *(above - 1);
  for (const Row* row : {&low, &high})
    if (2 * row->clogged < row->seeds)
      return unknown(fmt::format("at D/d = {} only {} of {} seeds of the map clogged: <s> is above {:.3g}", row->ratio,
                                 row->clogged, row->seeds, row->mean));
  burst.mean = between(ratio, low.ratio, low.mean, high.ratio, high.mean);
  burst.spread_seen = same(mu, {0.6, 0.6, 0.6});
  burst.spread = burst.spread_seen ? measured_spread : std::sqrt(1 + 1 / burst.mean);
  const double time = s.geometry.neck_width / s.flow.mean_velocity;
  const double rate = between(ratio, low.ratio, low.rate, high.ratio, high.rate) * map_time / time;
  const bool again = restarts(s.unclog.protocol);
  burst.start =
      frictionless_time(s, again ? s.unclog.strain : s.inlet.strain, again ? packing_of_restart : packing_of_start);
  burst.flow = with_arrests * burst.mean / rate;
  burst.proof = proof_time * time;
  return burst;
}

}  // namespace clogflow
