#include "ensemble/pulse.hpp"

#include <algorithm>

#include "ensemble/nap.hpp"

namespace clogflow {

namespace {

/// Between two sums: a share of the time so far, so that short calls end soon and long ones are not disturbed.
constexpr double pause_share = 0.005, shortest_pause = 0.02, longest_pause = 1;  // [-] [s] [s]

constexpr std::chrono::milliseconds longest_settling{2}, longest_finishing{20};

}  // namespace

bool Pulse::is_due() const {
  const double now = watch_.seconds();
  return ranks_.count() == 1 || now - last_ > std::clamp(pause_share * now, shortest_pause, longest_pause);
}

void Pulse::begin(const Standing& mine) {
  const auto numbers = mine.numbers();
  std::vector<double> all(numbers.begin(), numbers.end());
  for (EnoughSeeds* decision : decisions_) decision->add_rows(all);
  ranks_.begin_sum(std::move(all));
  under_way_ = true;
}

/// \return whether it says anything new of the decisions
bool Pulse::take(const std::vector<double>& sum) {
  under_way_ = false;
  last_ = watch_.seconds();
  std::array<double, Standing::size> numbers;
  std::copy_n(sum.begin(), numbers.size(), numbers.begin());
  all_ = Standing::of(numbers);
  std::span<const double> rows = std::span(sum).subspan(numbers.size());
  bool is_new = false;
  for (EnoughSeeds* decision : decisions_) is_new |= decision->take_rows(rows);
  is_last_ = all_.finished == ranks_.count() && !is_new;
  return is_new;
}

void Pulse::beat(const Standing& mine) {
  ranks_.serve();
  if (!under_way_ && !is_last_ && is_due()) begin(mine);
  if (!under_way_) return;
  if (const auto sum = ranks_.ended_sum()) take(*sum);
}

void Pulse::settle(const Standing& mine) {
  for (bool is_new = true; is_new;) {
    if (!under_way_) begin(mine);
    for (Nap nap(longest_settling);; nap()) {
      ranks_.serve();
      const auto sum = ranks_.ended_sum();
      if (!sum) continue;
      is_new = take(*sum);
      break;
    }
  }
}

void Pulse::finish(Standing mine, const std::function<void()>& meanwhile) {
  mine.finished = 1;
  for (Nap nap(longest_finishing);; nap()) {
    beat(mine);
    meanwhile();
    if (is_last_) return;
  }
}

}  // namespace clogflow
