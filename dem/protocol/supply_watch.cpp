#include "dem/protocol/supply_watch.hpp"

#include "dem/protocol/clog_watch.hpp"

namespace clogflow {

namespace {

/// Of the packing fraction at time 0.
constexpr double low_share = 0.5;

/// tau until a low packing is no gap that closes again.
constexpr double closing_time = 10;

}  // namespace

SupplyWatch::SupplyWatch(const Scene& scene)
    : enabled_(scene.inlet.enabled && scene.inlet.start != InletStart::empty && scene.porosity.strips > 0),
      look_interval_(look_interval(scene)),
      patience_(closing_time * scene.stokes_time()) {}

void SupplyWatch::note(double time, double packing) {
  if (at_start_ < 0) at_start_ = packing;
  if (packing >= low_share * at_start_) {
    low_since_ = -1;
    return;
  }
  if (low_since_ < 0) low_since_ = time;
  drained_ = time - low_since_ >= patience_;
}

}  // namespace clogflow
