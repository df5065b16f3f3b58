// What one run contributes to the statistics of its ensemble, without its bulky parts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "coupling/files/run_file.hpp"
#include "coupling/scene/scene.hpp"
#include "postprocess/events/bursts.hpp"
#include "postprocess/events/first_burst.hpp"
#include "postprocess/events/lapses.hpp"

namespace clogflow::postprocess {

/// Times that decide what a clog is.
struct ClogScale {
  double tau = 0;        ///< Stokes time d/v of the scene [s]
  double threshold = 0;  ///< T_min: a longer lapse is a clog [s]
};

/// \param threshold T_min [s]; absent: tau/2 \throws Error for a scene without a flow if it is absent too
ClogScale clog_scale(const Scene& scene, std::optional<double> threshold, const std::string& where);

/// Means over the second half of the window: the packed state.
struct SteadyState {
  double particles = 0;          ///< in the domain [-]
  double packing_fraction = 0;   ///< of the channel upstream [-]
  std::vector<double> porosity;  ///< one a strip, in the direction of flow [-]
  std::size_t samples = 0;       ///< rows of the series it rests on; 0: the rest is NaN
};

/// Of the passages in the window that say their size: none where all particles are equal.
struct PassedSizes {
  std::vector<double> of_species;  ///< passages of each
  double diameters = 0;            ///< their sum [m]
};

struct SeedRecord {
  std::uint64_t seed = 0;
  std::filesystem::path file;
  Window window;
  UnclogProtocol protocol = UnclogProtocol::none;
  std::size_t passages = 0;   ///< in the window, those while friction was off included
  std::size_t while_off = 0;  ///< passages while friction was off
  std::size_t releases = 0;
  PassedSizes sizes;
  std::vector<Lapse> lapses;
  std::vector<Burst> bursts;  ///< as the scene's unclog.protocol defines them
  FirstBurst first_burst;
  std::optional<bool> start_flowed;  ///< whether a flowing start passed its strain, if the solver says so
  SteadyState steady;
  double filling_time = 0;  ///< measured (start = "empty"), or as the solver says (start = "filled" or
                            ///< "flowing"), NaN if it does not [s]
  double wall_time = std::numeric_limits<double>::quiet_NaN();  ///< if the solver says so [s]

  /// Without its file, see coupling/base/archive.hpp.
  template <class Archive>
  void exchange(Archive& archive) {
    archive(seed, window, protocol, passages, while_off, releases, sizes.of_species, sizes.diameters, lapses, bursts,
            first_burst, start_flowed, steady.particles, steady.packing_fraction, steady.porosity, steady.samples,
            filling_time, wall_time);
  }
};

/// The run with the passages of one neck alone: releases, series and end are those of all.
RunData through_neck(const RunData& run, std::int64_t neck);

SeedRecord record_of(const RunData& run, const Scene& scene, const ClogScale& scale);

/// When the channel is full: 0 for start = "filled" and "flowing"; for start = "empty" the first time at which
/// the number of particles reaches 95 % of its median over the second half of the run.
double end_of_filling(const RunData& run, const Scene& scene);

}  // namespace clogflow::postprocess
