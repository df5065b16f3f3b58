#include "postprocess/summary/size_statistics.hpp"

#include <cmath>

#include "coupling/scene/particle_sizes.hpp"

namespace clogflow::postprocess {
namespace {

/// Sum over seeds, as often as each occurs, of one number over another.
template <class Above, class Below>
Estimate ratio_over_seeds(const RunGroup& group, const Resampling& resampling, const Above& above, const Below& below) {
  const auto& records = group.records;
  const Estimate estimate = bootstrap_over_seeds(
      records.size(),
      [&](const std::vector<std::size_t>& seeds) {
        double numerator = 0, denominator = 0;
        for (const std::size_t k : seeds) numerator += above(records[k].sizes), denominator += below(records[k].sizes);
        return numerator / denominator;
      },
      resampling);
  return is_spread_missing(estimate) ? without_interval(estimate) : estimate;
}

double counted(const PassedSizes& sizes) {
  double sum = 0;
  for (const double each : sizes.of_species) sum += each;
  return sum;
}

}  // namespace

std::optional<SizeStatistics> size_statistics(const RunGroup& group, const Resampling& resampling) {
  const ParticleSizes sizes(group.scene.particles);
  double passages = 0;
  for (const SeedRecord& record : group.records) passages += counted(record.sizes);
  if (sizes.equal() || passages == 0) return {};
  SizeStatistics all;
  all.feed_diameter = sizes.moment(1);
  all.feed_spread = std::sqrt(std::max(0.0, sizes.moment(2) / (sizes.moment(1) * sizes.moment(1)) - 1));
  all.passage_diameter = ratio_over_seeds(
      group, resampling, [](const PassedSizes& s) { return s.diameters; }, counted);
  for (std::size_t k = 0; k < sizes.species(); ++k) {
    SpeciesStatistics one{sizes.of(k).moment(1), sizes.density(k), sizes.share(k), 0, {}};
    const auto of_this = [k](const PassedSizes& s) { return k < s.of_species.size() ? s.of_species[k] : 0; };
    for (const SeedRecord& record : group.records) one.passages += of_this(record.sizes);
    one.passage_share = ratio_over_seeds(group, resampling, of_this, counted);
    all.species.push_back(one);
  }
  return all;
}

}  // namespace clogflow::postprocess
