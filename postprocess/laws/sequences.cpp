#include "postprocess/laws/sequences.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "coupling/base/random_stream.hpp"
#include "coupling/base/require.hpp"
#include "postprocess/laws/parallel.hpp"

namespace clogflow::postprocess {
namespace {

/// Of sums in another order the last digits differ.
constexpr double rounding = 1e-12;

std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<double> ranks;
  for (const double x : values) {
    const auto below = std::ranges::count_if(values, [&](double y) { return y < x; });
    const auto equal = std::ranges::count(values, x);
    ranks.push_back(static_cast<double>(below) + 0.5 * static_cast<double>(equal + 1));
  }
  return ranks;
}

/// Values of all sequences, one behind the other, and where each ends.
struct Joined {
  std::vector<double> values;
  std::vector<std::size_t> lengths;
};

Joined joined(const Sequences& sequences) {
  Joined all;
  for (const auto& sequence : sequences) {
    all.values.insert(all.values.end(), sequence.begin(), sequence.end());
    all.lengths.push_back(sequence.size());
  }
  return all;
}

void shuffle(std::span<double> values, RandomStream& random) {
  for (std::size_t k = values.size(); k > 1; --k) std::swap(values[k - 1], values[random.below(k)]);
}

double rank_correlation(const Joined& ranks) {
  double product = 0, places = 0, squares = 0;
  std::size_t start = 0;
  for (const std::size_t n : ranks.lengths) {
    const double middle = 0.5 * (static_cast<double>(n) + 1);  // mean of places and of ranks
    for (std::size_t k = 0; k < n; ++k) {
      const double place = static_cast<double>(k) + 1 - middle, rank = ranks.values[start + k] - middle;
      product += place * rank;
      places += place * place;
      squares += rank * rank;
    }
    start += n;
  }
  return places * squares > 0 ? product / std::sqrt(places * squares) : 0;
}

double successive(const Joined& all) {
  const auto n = static_cast<double>(all.values.size());
  const double mean = std::accumulate(all.values.begin(), all.values.end(), 0.0) / n;
  double product = 0, squares = 0, pairs = 0;
  std::size_t start = 0;
  for (const std::size_t length : all.lengths) {
    for (std::size_t k = start; k < start + length; ++k) {
      squares += (all.values[k] - mean) * (all.values[k] - mean);
      if (k + 1 == start + length) continue;
      product += (all.values[k] - mean) * (all.values[k + 1] - mean);
      ++pairs;
    }
    start += length;
  }
  return product / squares * n / pairs;  // NaN for 0/0
}

/// \param shuffled draws a permutation of all \param statistic of one
template <class Shuffled, class Statistic>
PermutationTest test(const Joined& all, std::size_t replicates, const Shuffled& shuffled, const Statistic& statistic) {
  require(replicates > 0, "0 permutations: nothing to compare with");
  const double value = statistic(all);
  if (!std::isfinite(value)) return {};
  const auto far = on_all_cores(replicates, [&](std::size_t k) -> char {
    return std::abs(statistic(shuffled(k))) >= std::abs(value) - rounding ? 1 : 0;
  });
  const std::size_t as_far = std::accumulate(far.begin(), far.end(), std::size_t{1});
  return {value, static_cast<double>(as_far) / static_cast<double>(replicates + 1)};
}

}  // namespace

PermutationTest trend_within(const Sequences& sequences, std::size_t replicates, std::uint64_t seed) {
  Sequences ranks;
  for (const auto& sequence : sequences) ranks.push_back(ranks_of(sequence));
  const Joined all = joined(ranks);
  const auto shuffled = [&](std::size_t k) {
    RandomStream random(seed, k);
    Joined again = all;
    std::size_t start = 0;
    for (const std::size_t n : all.lengths) {
      shuffle(std::span(again.values).subspan(start, n), random);
      start += n;
    }
    return again;
  };
  return test(all, replicates, shuffled, rank_correlation);
}

PermutationTest memory_of(const Sequences& sequences, std::size_t replicates, std::uint64_t seed) {
  const Joined all = joined(sequences);
  const auto shuffled = [&](std::size_t k) {
    RandomStream random(seed, k);
    Joined again = all;
    shuffle(again.values, random);
    return again;
  };
  return test(all, replicates, shuffled, successive);
}

double successive_correlation(const Sequences& sequences) { return successive(joined(sequences)); }

}  // namespace clogflow::postprocess
