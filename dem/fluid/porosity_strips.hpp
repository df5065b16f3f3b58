// Porosity strip by strip along the upstream channel.
#pragma once

#include <string>
#include <vector>

#include "dem/kernels/grid_place.hpp"
#include "dem/state/particles.hpp"

namespace clogflow {

/// Where the strips lie; without strips everything lies in number 0.
struct StripPlace {
  double start, per_length, last;

  int strip_at(double x) const { return static_cast<int>(place_within((x - start) * per_length, last)); }
};

/// Strips of equal length between the inlet and the neck's entrance; spheres are cut exactly at the
/// strips' edges, so a particle that sits on an edge cannot make the porosity flip.
///   eps_k = 1 - (solid volume in strip k) / (volume of strip k)
class PorosityStrips {
public:
  /// No strips: porosity 1 everywhere.
  PorosityStrips() = default;

  /// \param start, end  x of the first and of the last edge [m];  \param volumes  of the strips
  /// [m3]
  PorosityStrips(double start, double end, std::vector<double> volumes,
                 std::string remedy = "raise contact.youngs_modulus");

  /// Measures anew. \throws Error if a strip holds more solid than can be
  void update(const Particles& particles);

  /// Strip of a place; beyond the ends the nearest.
  int strip_at(double x) const { return place().strip_at(x); }
  StripPlace place() const { return {start_, 1 / length_, empty() ? 0.0 : static_cast<double>(volume_.size() - 1)}; }

  const std::vector<double>& porosity() const { return porosity_; }
  bool empty() const { return porosity_.empty(); }

  /// Solid volume over volume, all strips together [-].
  double packing_fraction() const;

  /// Whether porosities read from a file are those of these strips.
  bool valid() const;

  template <class Archive>
  void exchange(Archive& archive) {
    archive(porosity_);
  }

private:
  double start_ = 0, length_ = 1;  // of the first edge, of a strip [m]
  std::vector<double> volume_;     // [m3]
  std::vector<double> porosity_;   // [-]
  std::string remedy_ = "raise contact.youngs_modulus";
};

}  // namespace clogflow
