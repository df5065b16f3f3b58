// When a burst is due for a snapshot: often at first, ever rarer the longer it lasts.
#pragma once

#include <cmath>

namespace clogflow {

/// A burst begins with a passage, with a release and with its end, and is over when nothing has passed for a while. Its
/// first 50 snapshots are one interval apart, the next 25 two intervals, the next 25 four, ...: a burst of n intervals
/// has n + 1, or about 50 + 25 log2(n / 50) where n is larger. So a film has frames enough of any burst, and a run that
/// never clogs stays small.
class BurstClock {
public:
  /// \param interval  [s]; 0: no snapshots
  /// \param quiet     without a passage, that ends a burst [s]
  BurstClock(double interval, double quiet) : interval_(interval), quiet_(quiet) {}

  bool on() const { return interval_ > 0; }

  /// A passage, or a release that begins or ends.
  void flows(double now) {
    if (!flowing(now)) begun_ = 1, taken_ = 0, spacing_ = interval_, next_ = now;
    last_ = now;
  }

  bool due(double now) const { return on() && flowing(now) && now >= next_; }

  /// The snapshot that was due.
  void took() {
    next_ += spacing_;
    if (++taken_ >= at_first && (taken_ - at_first) % at_each_spacing == 0) spacing_ *= 2;
  }

  /// What comes next is another burst.
  void restart() { begun_ = 0; }

  bool is_valid() const {
    return (begun_ == 0 || begun_ == 1) && taken_ >= 0 && spacing_ >= 0 && last_ >= 0 && next_ >= 0 &&
           std::isfinite(last_ + next_ + spacing_);
  }

  template <class Archive>
  void exchange(Archive& archive) {
    archive(begun_, taken_, spacing_, next_, last_);
  }

private:
  static constexpr int at_first = 50, at_each_spacing = 25;

  bool flowing(double now) const { return begun_ == 1 && now - last_ < quiet_; }

  double interval_, quiet_;
  int begun_ = 0, taken_ = 0;
  double spacing_ = 0, next_ = 0, last_ = 0;  // of the snapshots, when due, of the last passage [s]
};

}  // namespace clogflow
