// How a flow came about and how good it is: the text /provenance/record of a flow file.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coupling/files/record_entry.hpp"

namespace clogflow {

/// Initial residuals of the last iteration. [-]
struct Residuals {
  double ux = 0, uy = 0, uz = 0, p = 0;

  static constexpr auto entries() {
    using R = Residuals;
    return std::tuple{RecordEntry{"Ux", "1", &R::ux}, RecordEntry{"Uy", "1", &R::uy}, RecordEntry{"Uz", "1", &R::uz},
                      RecordEntry{"p", "1", &R::p}};
  }
  bool operator==(const Residuals&) const = default;
};

/// A surface of the mesh and what flows through its faces.
struct SurfaceFlux {
  std::string surface;  ///< its name in the case
  double flux = 0;      ///< through the whole channel [m3/s]
  double error = 0;     ///< over the inlet's, less 1 [-]

  static constexpr auto entries() {
    using S = SurfaceFlux;
    return std::tuple{RecordEntry{"surface", "", &S::surface}, RecordEntry{"flux", "m3/s", &S::flux},
                      RecordEntry{"error", "1", &S::error}};
  }
  bool operator==(const SurfaceFlux&) const = default;
};

/// A cross-section of the grid and what flows through it.
struct PlaneFlux {
  double x = 0;      ///< of the plane [m]
  double flux = 0;   ///< along x [m3/s]
  double error = 0;  ///< over the flow rate of the scene, less 1 [-]

  static constexpr auto entries() {
    using P = PlaneFlux;
    return std::tuple{RecordEntry{"x", "m", &P::x}, RecordEntry{"flux", "m3/s", &P::flux},
                      RecordEntry{"error", "1", &P::error}};
  }
  bool operator==(const PlaneFlux&) const = default;
};

/// What two meshes tell of the solution: velocities over the neck's mean velocity. [-]
struct MeshError {
  std::vector<double> cells_per_neck;  ///< of the mesh, and of the coarser one
  bool extrapolated = false;           ///< the velocities and the pressure drop, from both
  double velocity_rms = 0, velocity_99_percent = 0, velocity_largest = 0;
  double pressure_drop = 0;  ///< over the pressure drop

  static constexpr auto entries() {
    using M = MeshError;
    return std::tuple{RecordEntry{"cells_per_neck", "1", &M::cells_per_neck},
                      RecordEntry{"extrapolated", "", &M::extrapolated},
                      RecordEntry{"velocity_rms", "1", &M::velocity_rms},
                      RecordEntry{"velocity_99_percent", "1", &M::velocity_99_percent},
                      RecordEntry{"velocity_largest", "1", &M::velocity_largest},
                      RecordEntry{"pressure_drop", "1", &M::pressure_drop}};
  }
  bool operator==(const MeshError&) const = default;
};

/// What reading the grid adds, over the neck's mean velocity: measured without walls, and expected in the neck with
/// them. [-]
struct ReadingError {
  double trilinear_rms = 0, nearest_rms = 0, trilinear_in_neck = 0, nearest_in_neck = 0;

  static constexpr auto entries() {
    using E = ReadingError;
    return std::tuple{RecordEntry{"trilinear_rms", "1", &E::trilinear_rms},
                      RecordEntry{"nearest_rms", "1", &E::nearest_rms},
                      RecordEntry{"trilinear_in_neck", "1", &E::trilinear_in_neck},
                      RecordEntry{"nearest_in_neck", "1", &E::nearest_in_neck}};
  }
  bool operator==(const ReadingError&) const = default;
};

/// That the flow was solved for another flow rate.
struct Rescaling {
  std::string from;   ///< hash of the flow that was solved
  double factor = 1;  ///< on the velocity [-]
  double error = 0;   ///< what that leaves out, over the neck's mean velocity [-]

  static constexpr auto entries() {
    using R = Rescaling;
    return std::tuple{RecordEntry{"from", "", &R::from}, RecordEntry{"factor", "1", &R::factor},
                      RecordEntry{"error", "1", &R::error}};
  }
  bool operator==(const Rescaling&) const = default;
};

/// Every entry may be missing: another program need not write it.
struct FlowRecord {
  std::optional<std::string> openfoam_version;
  std::optional<std::string> date;   ///< of the map
  std::optional<double> iterations;  ///< of the solver [-]
  std::optional<Residuals> residuals;
  std::optional<std::int64_t> cells;                  ///< of the mesh [-]
  std::optional<double> non_orthogonality;            ///< largest of the mesh [deg]
  std::optional<std::vector<SurfaceFlux>> mass_flux;  ///< inlet first
  std::optional<double> pressure_drop;                ///< from the inlet to the outlet of the mesh [Pa]
  std::optional<MeshError> mesh_error;                ///< if there was a coarser mesh
  std::optional<double> flow_rate_restored;           ///< largest error of the flow rate that was taken out [-]
  std::optional<double> points_lost_at_walls;         ///< share of the points between walls of an STL file [-]
  std::optional<std::vector<PlaneFlux>> grid_flux;    ///< before, along and behind the narrowing
  std::optional<double> grid_flux_largest_error;      ///< of all planes [-]
  std::optional<ReadingError> lookup_error;
  std::optional<Rescaling> rescaled;
  std::map<std::string, std::string> others;  ///< entries of another program: their JSON text, carried along

  static constexpr auto entries() {
    using F = FlowRecord;
    return std::tuple{RecordEntry{"openfoam_version", "", &F::openfoam_version},
                      RecordEntry{"date", "", &F::date},
                      RecordEntry{"iterations", "1", &F::iterations},
                      RecordEntry{"residuals", "", &F::residuals},
                      RecordEntry{"cells", "1", &F::cells},
                      RecordEntry{"non_orthogonality", "deg", &F::non_orthogonality},
                      RecordEntry{"mass_flux", "", &F::mass_flux},
                      RecordEntry{"pressure_drop", "Pa", &F::pressure_drop},
                      RecordEntry{"mesh_error", "", &F::mesh_error},
                      RecordEntry{"flow_rate_restored", "1", &F::flow_rate_restored},
                      RecordEntry{"points_lost_at_walls", "1", &F::points_lost_at_walls},
                      RecordEntry{"grid_flux", "", &F::grid_flux},
                      RecordEntry{"grid_flux_largest_error", "1", &F::grid_flux_largest_error},
                      RecordEntry{"lookup_error", "", &F::lookup_error},
                      RecordEntry{"rescaled", "", &F::rescaled}};
  }
  bool operator==(const FlowRecord&) const = default;
};

}  // namespace clogflow
