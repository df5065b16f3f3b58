// Do values that follow each other depend on their place, or on the one before? Several sequences together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace clogflow::postprocess {

/// One a seed, each in order of time.
using Sequences = std::vector<std::vector<double>>;

struct PermutationTest {
  double value = 0;    ///< correlation, -1 ... 1; 0 where nothing varies
  double p_value = 1;  ///< share of the permutations, the data among them, that are as far from 0 as the data
};

/// Spearman's correlation of value and place within each sequence, over all sequences:
///   rho = sum (k - <k>)(r - <r>) / sqrt(sum (k - <k>)^2 sum (r - <r>)^2)
/// k the place, r the rank of the value in its sequence (ties share their mean), means of the sequence. The p-value
/// comes from permutations within the sequences, so that differences between them are no trend.
/// \param replicates number of permutations, > 0
/// \source Spearman 1904; Phipson & Smyth 2010, Stat. Appl. Genet. Mol. Biol. 9:39 (the data among the permutations)
PermutationTest trend_within(const Sequences& sequences, std::size_t replicates, std::uint64_t seed);

/// Autocorrelation of successive values over all sequences:
///   r_1 = sum (x_k - m)(x_{k+1} - m) / sum (x_k - m)^2 * N/P, m the mean of all values, N values, P pairs
/// Sequences that differ from each other show as a memory, as they should: values of one are then no independent ones.
/// The p-value comes from permutations of all values.
PermutationTest memory_of(const Sequences& sequences, std::size_t replicates, std::uint64_t seed);

/// r_1 alone; NaN without a pair, or where nothing varies.
double successive_correlation(const Sequences& sequences);

}  // namespace clogflow::postprocess
