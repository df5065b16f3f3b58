#include "postprocess/summary/stopping_rule.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <regex>

#include "coupling/base/require.hpp"
#include "postprocess/laws/counting_interval.hpp"

namespace clogflow::postprocess {
namespace {

struct Count {
  const char* name;
  double Totals::*member;
};
constexpr Count counts[] = {{"bursts", &Totals::bursts},
                            {"arrests", &Totals::arrests},
                            {"passages", &Totals::passages},
                            {"releases", &Totals::releases}};

std::string names_of_quantities() {
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities()) names.push_back(quantity.key);
  return fmt::format("{}", fmt::join(names, ", "));
}

double parse_bound(const std::string& text, const std::string& rule) {
  double bound = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bound);
  require(error == std::errc() && end == text.data() + text.size() && std::isfinite(bound) && bound > 0,
          "--until {} (its bound must be a positive number)", rule);
  return bound;
}

/// How well the counts alone can be known, however alike the seeds happen to be.
Estimate limit_of_counts(const Quantity& quantity, const Totals& sum, double level) {
  const bool has_bound = quantity.key == "mean_burst" || quantity.key == "mean_burst_memoryless" ||
                         quantity.key == "first_burst_mean" || quantity.key == "first_burst_hazard";
  return has_bound ? quantity.counted(sum, level) : Estimate{NAN, NAN, NAN};
}

}  // namespace

StoppingRule::StoppingRule(std::string text) : text_(std::move(text)) {
  static const std::regex form(R"(\s*([a-z_]+)(?:\(\s*([a-z_]+)\s*\))?\s*([<>]=)\s*(\S+)\s*)");
  std::smatch part;
  require(std::regex_match(text_, part, form),
          "--until {} (must be like 'bursts>=1000' or 'relative_error(mean_burst)<=0.05')", text_);
  const std::string name = part[1], inner = part[2], direction = part[3];
  bound_ = parse_bound(part[4], text_);
  if (name == "relative_error") {
    quantity_ = find_quantity(inner);
    require(quantity_, "--until {} (relative_error is that of one of: {})", text_, names_of_quantities());
    require(direction == "<=", "--until {} (a relative error is bounded with <=)", text_);
    statistic_ = fmt::format("relative_error({})", inner);
    return;
  }
  for (const Count& each : counts)
    if (inner.empty() && name == each.name) count_ = each.member;
  require(count_, "--until {} (must bound bursts, arrests, passages, releases or relative_error(...))", text_);
  require(direction == ">=", "--until {} (a number of events is bounded with >=)", text_);
  statistic_ = name;
}

double StoppingRule::value(const std::vector<Totals>& seeds) const {
  if (count_) return sum_of(seeds).*count_;
  if (seeds.size() < fewest_seeds) return std::numeric_limits<double>::quiet_NaN();
  const Resampling resampling;
  const Estimate interval =
      wider(estimate(*quantity_, {seeds, resampling}), limit_of_counts(*quantity_, sum_of(seeds), resampling.level));
  return 0.5 * (interval.high - interval.low) / std::abs(interval.value);
}

bool StoppingRule::met(const std::vector<Totals>& seeds) const {
  const double now = value(seeds);
  return count_ ? now >= bound_ : now <= bound_;  // NaN meets nothing
}

}  // namespace clogflow::postprocess
