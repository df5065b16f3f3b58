#include "dem/fluid/porosity_strips.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/base/expect.hpp"
#include "coupling/base/require.hpp"
#include "dem/physics/porosity.hpp"

namespace clogflow {

PorosityStrips::PorosityStrips(double start, double end, std::vector<double> volumes, std::string remedy)
    : start_(start),
      length_((end - start) / static_cast<double>(volumes.size())),
      volume_(std::move(volumes)),
      porosity_(volume_.size(), 1.0),
      remedy_(std::move(remedy)) {}

void PorosityStrips::add_neck(double neck_end, double volume) {
  expect(!empty() && neck_strips_ == 0);
  neck_end_ = neck_end;
  neck_strips_ = 1;
  volume_.push_back(volume);
  porosity_.push_back(1.0);
}

StripPlace PorosityStrips::place() const {
  if (empty()) return {};
  StripPlace place{start_, 1 / length_, static_cast<double>(upstream() - 1)};
  if (neck_strips_ > 0) place.neck = upstream_end();
  return place;
}

void PorosityStrips::update(const Particles& p) {
  std::vector<double> solid(volume_.size(), 0.0);
  const double end = upstream_end();
  const StripPlace equal{start_, 1 / length_, static_cast<double>(upstream()) - 1};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double r = p[i].radius;
    if (neck_strips_ > 0 && p[i].x + r > end)
      solid.back() += sphere_volume_below(p[i].x, r, neck_end_) - sphere_volume_below(p[i].x, r, end);
    if (p[i].x - r >= end || p[i].x + r <= start_) continue;
    const int from = equal.strip_at(p[i].x - r), to = equal.strip_at(p[i].x + r);
    expect(from >= 0 && from <= to && static_cast<std::size_t>(to) < solid.size());
    if (from == to && p[i].x + r <= end && p[i].x - r >= start_) {
      solid[from] += sphere_volume(r);
      continue;
    }
    for (int k = from; k <= to; ++k)
      solid[k] += sphere_volume_below(p[i].x, r, start_ + (k + 1) * length_) -
                  sphere_volume_below(p[i].x, r, start_ + k * length_);
  }
  for (std::size_t k = 0; k < solid.size(); ++k) {
    porosity_[k] = 1 - solid[k] / volume_[k];
    require_fluid(k);
  }
}

void PorosityStrips::require_fluid(std::size_t strip) const {
  require(strip == upstream() || porosity_[strip] >= least_porosity,
          "porosity {:.3f} in strip {} of {} (below {}, particles must be overlapping): {} or use fewer strips",
          porosity_[strip], strip + 1, upstream(), least_porosity, remedy_);
  require(porosity_[strip] >= least_porosity,
          "porosity {:.3f} in the neck (below {}, particles must be overlapping): {} or leave out porosity.neck",
          porosity_[strip], least_porosity, remedy_);
}

bool PorosityStrips::valid() const {
  return porosity_.size() == volume_.size() && std::all_of(porosity_.begin(), porosity_.end(), [](double e) {
           return std::isfinite(e) && e >= least_porosity;
         });
}

double PorosityStrips::packing_fraction() const {
  double solid = 0, volume = 0;
  for (std::size_t k = 0; k < upstream(); ++k) {
    solid += (1 - porosity_[k]) * volume_[k];
    volume += volume_[k];
  }
  return volume > 0 ? solid / volume : 0;
}

}  // namespace clogflow
