// What a pack is taken to be like before it has been simulated.
#pragma once

namespace clogflow {

/// Porosity of a pack at rest (the paper: about 0.5; packs at rest of this program 0.52 to 0.61).
inline constexpr double pack_porosity = 0.55;

/// An arch carries the drag of about this many particles behind it: the flow's load on the pack over
/// a few neck widths, shared by the arch's few contacts. An assumption, not a measurement.
inline constexpr double arch_load = 20;

}  // namespace clogflow
