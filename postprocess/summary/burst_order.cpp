#include "postprocess/summary/burst_order.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "coupling/scene/unclog_protocol.hpp"
#include "postprocess/laws/counting_interval.hpp"

namespace clogflow::postprocess {
namespace {

constexpr std::size_t permutations = 1999;
constexpr double real_below = 0.05;

Sequences whole_bursts(const RunGroup& group) {
  Sequences all;
  for (const SeedRecord& record : group.records) {
    all.emplace_back();
    for (const Burst& burst : record.bursts)
      if (burst.kind == BurstKind::whole) all.back().push_back(static_cast<double>(burst.size));
  }
  return all;
}

/// Number and sum of the bursts of one seed in a fifth.
struct Part {
  double bursts = 0, passages = 0;
};

Part part_of(const std::vector<double>& sizes, std::size_t fifth) {
  Part part;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (5 * k / sizes.size() != fifth) continue;
    ++part.bursts;
    part.passages += sizes[k];
  }
  return part;
}

Fifth fifth_of(const Sequences& sequences, std::size_t fifth, const Resampling& resampling) {
  std::vector<Part> parts;
  double bursts = 0;
  for (const auto& sizes : sequences) {
    parts.push_back(part_of(sizes, fifth));
    bursts += parts.back().bursts;
  }
  const Estimate mean = bootstrap_over_seeds(
      parts.size(),
      [&](const std::vector<std::size_t>& drawn) {
        Part sum;
        for (const std::size_t k : drawn) {
          sum.bursts += parts[k].bursts;
          sum.passages += parts[k].passages;
        }
        return sum.passages / sum.bursts;
      },
      resampling);
  return {static_cast<std::size_t>(bursts), is_spread_missing(mean) ? without_interval(mean) : mean};
}

Estimate memory_over_seeds(const Sequences& sequences, const Resampling& resampling) {
  return bootstrap_over_seeds(
      sequences.size(),
      [&](const std::vector<std::size_t>& drawn) {
        Sequences again;
        for (const std::size_t k : drawn) again.push_back(sequences[k]);
        return successive_correlation(again);
      },
      resampling);
}

std::string in_words(const BurstOrder& order) {
  if (!order.depends)
    return fmt::format("no trend (p = {:.2g}), no memory (p = {:.2g})", order.trend.p_value, order.memory.p_value);
  return fmt::format(
      "bursts are not independent: trend with their number {:.2f} (p = {:.2g}), correlation of successive ones {:.2f} "
      "(p = {:.2g})",
      order.trend.value, order.trend.p_value, order.memory.value, order.memory.p_value);
}

std::vector<Totals> blocks_of(const RunGroup& group) {
  std::vector<Totals> blocks;
  for (const SeedRecord& record : group.records) {
    const auto length = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(record.bursts.size()))));
    for (std::size_t k = 0; k < record.bursts.size(); ++k) {
      if (k % length == 0) blocks.emplace_back();
      blocks.back() = blocks.back() + totals_of(record.bursts[k], record.protocol);
    }
  }
  return blocks;
}

}  // namespace

std::optional<BurstOrder> burst_order(const RunGroup& group, const Resampling& resampling) {
  if (!clears_clogs(group.scene.unclog.protocol)) return {};
  const Sequences sequences = whole_bursts(group);
  BurstOrder order;
  for (const auto& sizes : sequences) order.bursts += sizes.size();
  if (order.bursts < fewest_ordered_bursts) return {};
  for (std::size_t k = 0; k < order.fifths.size(); ++k) order.fifths[k] = fifth_of(sequences, k, resampling);
  order.trend = trend_within(sequences, permutations, resampling.seed);
  order.memory = memory_of(sequences, permutations, resampling.seed);
  order.memory_interval = memory_over_seeds(sequences, resampling);
  order.depends = std::min(order.trend.p_value, order.memory.p_value) < real_below;
  order.words = in_words(order);
  return order;
}

Estimate dependent_estimate(const Quantity& quantity, const RunGroup& group, const Resampling& resampling) {
  std::vector<Totals> seeds;
  for (const SeedRecord& record : group.records) seeds.push_back(totals_of({record}, group.scale));
  Estimate known = wider(resampled(quantity, {seeds, resampling}), resampled(quantity, {blocks_of(group), resampling}));
  known.note = "bursts are not independent: the wider interval of resampled seeds and of blocks of successive bursts";
  return known;
}

}  // namespace clogflow::postprocess
