// Porosity strip by strip along the upstream channel.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "dem/kernels/grid_place.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// Below this the drag law means nothing, and only overlapping particles get there (the densest
/// packing of equal spheres leaves 0.26).
inline constexpr double least_porosity = 0.2;

/// Where the strips lie; without strips everything lies in number 0.
struct StripPlace {
  double start = 0, per_length = 1, last = 0;             // of the strips of equal length
  double neck = std::numeric_limits<double>::infinity();  // from this x on the strip after the last counts [m]

  int strip_at(double x) const { return static_cast<int>(strip_number((x - start) * per_length, last, x, neck)); }
};

/// Strips of equal length between the inlet and the neck's entrance, and one more for the neck if it is
/// added; spheres are cut exactly at the strips' edges, so a particle that sits on an edge cannot make the porosity
/// flip.
///   eps_k = 1 - (solid volume in strip k) / (volume of strip k)
class PorosityStrips {
public:
  /// No strips: porosity 1 everywhere.
  PorosityStrips() = default;

  /// \param start, end  x of the first and of the last edge [m];  \param volumes  of the strips
  /// [m3]
  PorosityStrips(double start, double end, std::vector<double> volumes,
                 std::string remedy = "raise contact.youngs_modulus");

  /// The neck, from where the other strips end to `neck_end`, is a strip of its own and the last.
  void add_neck(double neck_end, double volume);

  /// Measures anew. \throws Error if a strip holds more solid than can be
  void update(const Particles& particles);

  /// Strip of a place; beyond the ends the nearest.
  int strip_at(double x) const { return place().strip_at(x); }
  StripPlace place() const;

  const std::vector<double>& porosity() const { return porosity_; }
  bool empty() const { return porosity_.empty(); }

  /// Without that of the neck: what a run records.
  std::vector<double> upstream_porosity() const { return {porosity_.begin(), porosity_.end() - neck_strips_}; }

  /// Solid volume over volume, all strips but the neck's together [-].
  double packing_fraction() const;

  /// Whether porosities read from a file are those of these strips.
  bool valid() const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(porosity_);
  }

private:
  std::size_t upstream() const { return volume_.size() - neck_strips_; }
  double upstream_end() const { return start_ + length_ * static_cast<double>(upstream()); }
  void require_fluid(std::size_t strip) const;

  double start_ = 0, length_ = 1;  // of the first edge, of a strip [m]
  double neck_end_ = 0;            // [m]
  int neck_strips_ = 0;            // one, or none
  std::vector<double> volume_;     // [m3]
  std::vector<double> porosity_;   // [-]
  std::string remedy_ = "raise contact.youngs_modulus";
};

}  // namespace clogflow
