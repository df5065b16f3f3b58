#include "cli/progress.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "cli/output.hpp"

namespace clogflow::cli {

namespace {

/// Seconds between two lines; a person reads no faster.
constexpr double renew_every = 0.5;

}  // namespace

void ProgressLine::show(const Progress& now) {
  if (!shown_) return;
  const std::chrono::duration<double> passed = Clock::now() - last_time_;
  const bool new_run = now.steps < last_.steps || now.filling != last_.filling;
  if (!new_run && passed.count() < renew_every) return;
  if (new_run) {
    rate_ = share_rate_ = 0;
  } else {
    rate_ = (now.particle_steps - last_.particle_steps) / passed.count();
    share_rate_ = (now.time - last_.time) / now.end / passed.count();
  }
  last_ = now;
  last_time_ = Clock::now();
  drawn_ = true;
  if (now.filling) {
    put(stderr, fmt::format("\r\033[Kfilling {:7.2f} ms  {:5d} particles  {:.3g} particle-steps/s", -1e3 * now.time,
                            now.particles, rate_));
  } else {
    const double share = now.time / now.end;
    put(stderr, fmt::format("\r\033[K{:8.2f} ms  {:3.0f} %  {:.3g} particle-steps/s  {} passages  {}  {:.0f} s left",
                            1e3 * now.time, 100 * share, rate_, now.passages, now.clogged ? "clogged" : "flowing",
                            share_rate_ > 0 ? (1 - share) / share_rate_ : 0.0));
  }
}

void ProgressLine::clear() {
  if (drawn_) put(stderr, "\r\033[K");
  drawn_ = false;
}

}  // namespace clogflow::cli
