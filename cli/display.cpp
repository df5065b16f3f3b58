#include "cli/display.hpp"

#include <fmt/format.h>

#include "cli/output.hpp"

namespace clogflow::cli {

namespace {

/// Between two lines on a terminal, since a person reads no faster, and in a log [s]
constexpr double renew_every = 0.5, say_every = 60;

/// What is too short to tell the time left from [s]
constexpr double too_early = 2;

std::string seeds_of(const Standing& all) {
  return all.jobs > 0 ? fmt::format("{:.0f} of {:.0f} seeds", all.done, all.jobs)
                      : fmt::format("{:.0f} seeds", all.done);
}

}  // namespace

std::string standing_line(const Standing& all, double seconds) {
  std::string line = seeds_of(all);
  if (const double at_work = all.filling + all.flowing + all.clogged; at_work > 0)
    line += fmt::format(", {:.0f} at work ({:.0f} filling, {:.0f} flowing, {:.0f} clogged), {:.3g} particle-steps/s",
                        at_work, all.filling, all.flowing, all.clogged, all.particle_steps);
  line += fmt::format(", {:.0f} passages", all.passages);
  const double behind = all.done + all.share;
  if (seconds > too_early && behind > 0 && all.jobs > 0)
    line += fmt::format(", {:.0f} s left", seconds * (all.jobs - behind) / behind);
  return line;
}

Display::Display(const Launch& launch)
    : speaks_(launch.rank == 0), is_terminal_(can_renew()), is_alone_(launch.count == 1) {}

std::string Display::run_line(const Progress& now, double passed) {
  if (now.steps < last_.steps || now.filling != last_.filling) {
    rate_ = share_rate_ = 0;
  } else {
    rate_ = (now.particle_steps - last_.particle_steps) / passed;
    share_rate_ = (now.time - last_.time) / now.end / passed;
  }
  if (now.filling)
    return fmt::format("filling {:7.2f} ms  {:5d} particles  {:.3g} particle-steps/s", -1e3 * now.time, now.particles,
                       rate_);
  const double share = now.time / now.end;
  return fmt::format("{:8.2f} ms  {:3.0f} %  {:.3g} particle-steps/s  {} passages  {}  {:.0f} s left", 1e3 * now.time,
                     100 * share, rate_, now.passages, now.clogged ? "clogged" : "flowing",
                     share_rate_ > 0 ? (1 - share) / share_rate_ : 0.0);
}

void Display::show(const Progress& run, const Standing& all) {
  if (!speaks_ || (!is_terminal_ && is_alone_)) return;
  const auto now = Clock::now();
  const double passed = std::chrono::duration<double>(now - last_time_).count();
  if (passed < (is_terminal_ ? renew_every : say_every)) return;
  const std::string line = !is_alone_      ? standing_line(all, std::chrono::duration<double>(now - begin_).count())
                           : all.jobs != 1 ? seeds_of(all) + "  " + run_line(run, passed)
                                           : run_line(run, passed);
  last_ = run;
  last_time_ = now;
  if (is_terminal_)
    renew(line);
  else
    print_note(line);
}

void Display::clear() { wipe(); }

}  // namespace clogflow::cli
