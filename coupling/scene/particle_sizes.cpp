#include "coupling/scene/particle_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupling/base/expect.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"

namespace clogflow {

namespace {

using std::numbers::sqrt2;

/// Share of a Gauss curve below z standard deviations.
double gauss_share(double z) { return 0.5 * std::erfc(-z / sqrt2); }

/// Of the curve, between the cuts.
double kept_share() { return gauss_share(size_cut) - gauss_share(-size_cut); }

/// Of a Gauss curve that is cut, over that of the whole one.
double cut_variance() {
  const double density = std::exp(-size_cut * size_cut / 2) / std::sqrt(2 * std::numbers::pi);
  return 1 - 2 * size_cut * density / kept_share();
}

/// Mean of exp(k s z) over the cut curve.
double cut_exponential(double ks) {
  return std::exp(ks * ks / 2) * (gauss_share(size_cut - ks) - gauss_share(-size_cut - ks)) / kept_share();
}

/// Where a rising function passes a value, by halving.
template <class Function>
double solve(double low, double high, double value, const Function& rising) {
  constexpr int halvings = 60;  // all bits of a number
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (rising(middle) < value ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Standard deviation of ln d that gives d the spread.
double logarithmic_width(double spread) {
  return solve(0, 2, 1 + spread * spread,
               [](double s) { return cut_exponential(2 * s) / (cut_exponential(s) * cut_exponential(s)); });
}

/// Standard deviations below which a share of the cut curve lies.
double cut_quantile(double share) {
  return solve(-size_cut, size_cut, share,
               [](double z) { return (gauss_share(z) - gauss_share(-size_cut)) / kept_share(); });
}

}  // namespace

SizeClass::SizeClass(SizeDistribution kind, double mean, double spread)
    : kind_(kind), mean_(mean), spread_(spread), middle_(mean), width_(spread * mean) {
  if (spread == 0) return;
  if (kind == SizeDistribution::normal) width_ /= std::sqrt(cut_variance());
  if (kind == SizeDistribution::lognormal) {
    width_ = logarithmic_width(spread);
    middle_ = std::log(mean / cut_exponential(width_));
  }
}

double SizeClass::quantile(double share) const {
  if (spread_ == 0) return mean_;
  if (kind_ == SizeDistribution::uniform) return middle_ + std::sqrt(3.0) * width_ * (2 * share - 1);
  const double z = share <= 0 ? -size_cut : share >= 1 ? size_cut : cut_quantile(share);
  return kind_ == SizeDistribution::lognormal ? std::exp(middle_ + width_ * z) : middle_ + width_ * z;
}

double SizeClass::share_up_to(double diameter) const {
  if (spread_ == 0) return diameter >= mean_ ? 1 : 0;
  if (diameter <= smallest()) return 0;
  if (diameter >= largest()) return 1;
  if (kind_ == SizeDistribution::uniform) return 0.5 + (diameter - middle_) / (2 * std::sqrt(3.0) * width_);
  const double value = kind_ == SizeDistribution::lognormal ? std::log(diameter) : diameter;
  return (gauss_share((value - middle_) / width_) - gauss_share(-size_cut)) / kept_share();
}

double SizeClass::moment(int k) const {
  expect(k >= 1 && k <= 3);
  if (k == 1) return mean_;
  // A symmetric curve has no third moment about its middle.
  const double plain = std::pow(mean_, k) * (1 + (k == 2 ? 1 : 3) * spread_ * spread_);
  if (k == 2 || kind_ != SizeDistribution::lognormal || spread_ == 0) return plain;
  return std::exp(k * middle_) * cut_exponential(k * width_);
}

ParticleSizes::ParticleSizes(const Scene::Particles& p)
    : equal_(p.size_spread == 0 && p.species.empty()), one_density_(true), diameter_(p.diameter) {
  const auto add = [&](double diameter, double share, double density) {
    classes_.emplace_back(p.size_distribution, diameter, p.size_spread);
    shares_.push_back(share);
    densities_.push_back(density > 0 ? density : p.density);
    one_density_ = one_density_ && densities_.back() == densities_.front();
  };
  for (const Species& each : p.species) add(each.diameter, each.share, each.density);
  if (p.species.empty()) add(p.diameter, 1, p.density);
}

double ParticleSizes::smallest() const {
  double least = classes_[0].smallest();
  for (const SizeClass& each : classes_) least = std::min(least, each.smallest());
  return least;
}

double ParticleSizes::largest() const {
  double most = 0;
  for (const SizeClass& each : classes_) most = std::max(most, each.largest());
  return most;
}

double ParticleSizes::moment(int k) const {
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < classes_.size(); ++i) sum += shares_[i] * classes_[i].moment(k), all += shares_[i];
  return sum / all;
}

double ParticleSizes::mean_volume() const {
  const double r = diameter_ / 2;
  // In the order of sphere_volume(): the same bits.
  return equal_ ? 4.0 / 3.0 * std::numbers::pi * r * r * r : std::numbers::pi / 6 * moment(3);
}

ParticleSizes::Drawn ParticleSizes::draw(double which, double size) const {
  int chosen = 0;
  const auto last = static_cast<int>(shares_.size()) - 1;
  for (; chosen < last && which >= shares_[chosen]; ++chosen) which -= shares_[chosen];
  return {classes_[chosen].quantile(size), chosen};
}

double mean_diameter(const std::vector<Species>& species) {
  double sum = 0, shares = 0;
  for (const Species& each : species) sum += each.share * each.diameter, shares += each.share;
  return sum / shares;
}

std::string short_length(double length) {
  return format_quantity(std::stod(fmt::format("{:.4g}", length)), dimension::length);
}

std::string spread_fault(const Scene::Particles& particles) {
  const ParticleSizes sizes(particles);
  const double least = sizes.smallest(), most = sizes.largest();
  // A tenfold mixture is one, rounding or not.
  if (least > 0 && most <= (1 + 1e-9) * largest_size_ratio * least) return {};
  return fmt::format(
      "diameters would be from {} to {}: the smallest must be above 0, and the largest at most {} times as large",
      short_length(least), short_length(most), largest_size_ratio);
}

}  // namespace clogflow
