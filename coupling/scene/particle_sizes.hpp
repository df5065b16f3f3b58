// How the diameters of a scene's particles are distributed.
#pragma once

#include <string>
#include <vector>

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// Normal and lognormal diameters end this many standard deviations from their middle: of the diameter, or of its
/// logarithm.
inline constexpr double size_cut = 3;

/// Largest over smallest diameter that is tried and tested; beyond, a scene is refused [-].
inline constexpr double largest_size_ratio = 10;

/// Diameters of one kind of particles, each between smallest() and largest(). Mean and standard deviation are those
/// asked for, of the distribution as it is cut:
///   uniform    within sqrt(3) standard deviations of the mean
///   normal     density of a Gauss curve, cut at size_cut of its standard deviations; that curve is 1.4 % wider than
///   asked lognormal  the same of ln d, whose two constants are solved for
/// \source moments of a cut Gauss curve: N. L. Johnson, S. Kotz & N. Balakrishnan, Continuous Univariate
///         Distributions 1 (1994), 10.1
class SizeClass {
public:
  /// \param mean [m];  \param spread  standard deviation over mean [-]; 0: all are equal
  SizeClass(SizeDistribution kind, double mean, double spread);

  double smallest() const { return quantile(0); }  ///< [m]
  double largest() const { return quantile(1); }   ///< [m]

  /// Diameter that a share of the particles does not exceed [m]
  double quantile(double share) const;

  /// Share of the particles up to a diameter [-]
  double share_up_to(double diameter) const;

  /// Mean of d^k, k = 1, 2, 3 [m^k]
  double moment(int k) const;

private:
  SizeDistribution kind_;
  double mean_, spread_;
  double middle_, width_;  // of what is uniform or Gauss: the diameter [m], or its logarithm
};

/// All particles of a scene, one kind or a mixture.
class ParticleSizes {
public:
  explicit ParticleSizes(const Scene::Particles& particles = {});

  /// Whether all have one size and one density, and nothing tells them apart.
  bool equal() const { return equal_; }
  bool one_density() const { return one_density_; }

  std::size_t species() const { return classes_.size(); }
  const SizeClass& of(std::size_t species) const { return classes_[species]; }
  double share(std::size_t species) const { return shares_[species]; }       ///< of the number [-]
  double density(std::size_t species) const { return densities_[species]; }  ///< [kg/m3]

  double smallest() const;  ///< [m]
  double largest() const;   ///< [m]

  /// Mean of d^k over the number of all particles [m^k]
  double moment(int k) const;

  /// <d^3> / <d^2>, Sauter's mean [m]
  double sauter_mean() const { return equal_ ? diameter_ : moment(3) / moment(2); }

  /// Of a particle, averaged over their number [m3]
  double mean_volume() const;

  struct Drawn {
    double diameter;  ///< [m]
    int species;
  };

  /// Two numbers of [0, 1), each uniform, into a particle.
  Drawn draw(double which, double size) const;

private:
  bool equal_, one_density_;
  double diameter_;
  std::vector<SizeClass> classes_;
  std::vector<double> shares_, densities_;
};

/// Over the number of particles [m]
double mean_diameter(const std::vector<Species>& species);

/// To four digits: "27.13 um".
std::string short_length(double length);

/// What is wrong with a spread of sizes, or nothing.
std::string spread_fault(const Scene::Particles& particles);

/// A row for each line of a file of sizes under the header "diameter [um],share": shares of the number, scaled to
/// add up to 1. \throws Error with file and line
std::vector<Species> read_size_file(const std::string& file);

}  // namespace clogflow
