// Is there anything left at the neck that could clog it?
#pragma once

#include "coupling/scene/scene.hpp"

namespace clogflow {

/// A column that began full must stay so near the neck: bursts from a drained one are of another suspension. The last
/// porosity strip is looked at; where it holds less than half of what it held at time 0 for ten tau in a row, the run
/// ends and says so. Without strips, or from an empty start, nothing is watched.
class SupplyWatch {
public:
  explicit SupplyWatch(const Scene& scene);

  /// Packing fraction of the last strip at time t. \return whether the run ends now
  template <class Packing>
  bool drains(double time, const Packing& packing) {
    if (!enabled_ || drained_ || time < next_look_) return false;
    next_look_ = time + look_interval_;
    note(time, packing());
    return drained_;
  }

  bool drained() const { return drained_; }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(at_start_, low_since_, next_look_, drained_);
  }

private:
  void note(double time, double packing);

  bool enabled_;
  double look_interval_, patience_;        // [s]
  double at_start_ = -1;                   // packing fraction; -1: not looked yet
  double low_since_ = -1, next_look_ = 0;  // [s]; -1: it is not low
  bool drained_ = false;
};

}  // namespace clogflow
