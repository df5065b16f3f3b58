#include "dem/fluid/fluid_noise.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "dem/physics/ornstein_uhlenbeck.hpp"
#include "dem/state/normal_numbers.hpp"

namespace clogflow {

namespace {

enum Stream : std::uint32_t { birth = 1, change = 2, pulse_begin = 3, pulse_change = 4 };

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

FluidNoise::FluidNoise(const Scene& scene)
    : fluctuation_{scene.drag.fluctuation.strength, scene.drag.fluctuation.time},
      pulsation_{scene.flow.pulsation.strength, scene.flow.pulsation.time} {}

void FluidNoise::advance(const Particles& particles, std::uint64_t seed, double time) {
  if (!started_) {
    started_ = true;
    pulse_ = normal_numbers({seed, pulse_begin})[0];
    fluctuation_.next = time + fluctuation_.interval();
    pulsation_.next = time + pulsation_.interval();
  }
  if (fluctuation_.strength > 0 && ids_ != particles.id) follow(particles.id, seed);
  if (fluctuation_.strength > 0 && time >= fluctuation_.next) {
    const double share = fluctuation_.draw(time);
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const auto normal = normal_numbers({seed, change, fluctuation_.draws, ids_[i]});
      for (int a = 0; a < 3; ++a) xi_[3 * i + a] = ornstein_uhlenbeck_step(xi_[3 * i + a], normal[a], share);
    }
  }
  if (pulsation_.strength > 0 && time >= pulsation_.next) {
    const double share = pulsation_.draw(time);
    pulse_ = ornstein_uhlenbeck_step(pulse_, normal_numbers({seed, pulse_change, pulsation_.draws})[0], share);
  }
}

double FluidNoise::Process::draw(double now) {
  // A step longer than the interval makes one draw for all the intervals in it: that is exact too.
  const double intervals = 1 + std::floor((now - next) / interval());
  ++draws;
  next += intervals * interval();
  return intervals * interval_share;
}

void FluidNoise::follow(const std::vector<std::int64_t>& ids, std::uint64_t seed) {
  std::unordered_map<std::int64_t, std::size_t> known;
  for (std::size_t i = 0; i < ids_.size(); ++i) known[ids_[i]] = i;
  std::vector<double> xi(3 * ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto found = known.find(ids[i]);
    if (found != known.end()) {
      std::copy_n(&xi_[3 * found->second], 3, &xi[3 * i]);
    } else {
      const auto normal = normal_numbers({seed, birth, 0, ids[i]});
      std::copy(normal.begin(), normal.end(), &xi[3 * i]);
    }
  }
  ids_ = ids;
  xi_ = std::move(xi);
}

std::array<double, 3> FluidNoise::fluctuation(std::size_t i) const {
  const double s = fluctuation_.strength;
  return {s * xi_[3 * i], s * xi_[3 * i + 1], s * xi_[3 * i + 2]};
}

bool FluidNoise::valid() const {
  return xi_.size() == 3 * ids_.size() && finite(xi_) && finite({pulse_, fluctuation_.next, pulsation_.next});
}

}  // namespace clogflow
