#include "trade/observables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "postprocess/laws/confidence.hpp"

namespace clogflow::trade {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

double of_totals(const Observable& observable, const Pieces& pieces, double) {
  postprocess::Totals totals;
  for (const Piece* piece : pieces) totals += piece->totals;
  return observable.quantity->value(totals);
}

double of_rows(const Observable& observable, const Pieces& pieces, double) {
  RowMean all;
  for (const Piece* piece : pieces) {
    const RowMean& mean = piece->*observable.rows;
    all.sum += mean.sum, all.rows += mean.rows;
  }
  return all.sum / all.rows;
}

/// All clogs count, those that end a first burst and those after a burst that the end of the run did not cut.
double mean_size(const Observable&, const Pieces& pieces, double) {
  double escaped = 0, clogs = 0;
  for (const Piece* piece : pieces) {
    for (const double size : piece->sizes) escaped += size;
    escaped += piece->totals.cut_off_escaped;
    clogs += static_cast<double>(piece->sizes.size());
  }
  return clogs > 0 ? escaped / clogs : undefined;
}

double share_of_early(const Observable&, const Pieces& pieces, double usual) {
  double early = 0, clogs = 0;
  for (const Piece* piece : pieces)
    for (const double size : piece->sizes) {
      early += size <= usual ? 1 : 0;
      ++clogs;
    }
  return clogs > 0 ? early / clogs : undefined;
}

Pieces all_of(const Sample& sample) {
  Pieces pieces;
  for (const Piece& piece : sample.pieces) pieces.push_back(&piece);
  return pieces;
}

}  // namespace

const std::vector<Observable>& observables() {
  using postprocess::find_quantity;
  static const std::vector<Observable> all{
      {"mean_burst", "<s>, passages a clog", false, false, 1, mean_size},
      {"early_clogs", "share of the clogs after no more passages than the reference's median", true, false, 1,
       share_of_early},
      {"flow_rate_flowing", "passages per second within bursts", false, false, 1, of_totals,
       find_quantity("flow_rate_flowing")},
      {"packing_near_neck", "of the strip next to the narrowing, while particles pass", false, false, 1, of_rows,
       nullptr, &Piece::packing_while_flowing},
      {"coordination", "contacts of a particle with others, in a clog", false, false, 0.5, of_rows, nullptr,
       &Piece::contacts_at_rest},
      {"alpha", "exponent of T >= tau/2, censored arrests included", false, true, 1, of_totals,
       find_quantity("alpha_fixed")},
      {"share_censored", "share of the arrests that no passage ended", true, true, 1, of_totals,
       find_quantity("share_censored")},
  };
  return all;
}

double usual_burst(const Sample& sample) {
  std::vector<double> sizes;
  for (const Piece& piece : sample.pieces) sizes.insert(sizes.end(), piece.sizes.begin(), piece.sizes.end());
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

double Difference::within() const {
  const double bound = std::max(std::abs(low), std::abs(high));
  return std::isnan(low) || std::isnan(high) ? std::numeric_limits<double>::infinity() : bound;
}

Difference compare(const Observable& observable, const Sample& reference, const Sample& sample) {
  if (reference.pieces.empty() || sample.pieces.empty()) return {undefined, undefined, undefined, undefined, undefined};
  std::map<std::pair<std::uint64_t, int>, std::array<const Piece*, 2>> units;
  for (const Piece& piece : reference.pieces) units[{piece.seed, piece.number}][0] = &piece;
  for (const Piece& piece : sample.pieces) units[{piece.seed, piece.number}][1] = &piece;
  std::vector<std::array<const Piece*, 2>> pairs;
  for (const auto& [place, unit] : units) pairs.push_back(unit);
  const double usual = usual_burst(reference);
  const auto value = [&](const std::vector<std::size_t>& drawn, int which) {
    Pieces pieces;
    for (const std::size_t k : drawn)
      if (pairs[k][which]) pieces.push_back(pairs[k][which]);
    return observable.value(observable, pieces, usual);
  };
  const auto difference = [&](const std::vector<std::size_t>& drawn) {
    const double before = value(drawn, 0), after = value(drawn, 1);
    return observable.is_share ? after - before : (after - before) / before;
  };
  const postprocess::Estimate e = postprocess::bootstrap_over_seeds(pairs.size(), difference, {});
  std::vector<std::size_t> all(pairs.size());
  std::iota(all.begin(), all.end(), 0);
  return {value(all, 0), value(all, 1), e.value, e.low, e.high};
}

Spread spread_of(const Observable& observable, const Sample& sample, double usual) {
  const Pieces all = all_of(sample);
  const auto value = [&](const Pieces& pieces) { return observable.value(observable, pieces, usual); };
  if (all.empty()) return {undefined, undefined};
  const auto scale = [&](double v) { return observable.is_share ? v : std::log(v); };
  std::vector<double> replicates(2000);
  postprocess::draw_seeds(all.size(), {.replicates = replicates.size()},
                          [&](std::size_t k, const std::vector<std::size_t>& drawn) {
                            Pieces pieces;
                            for (const std::size_t index : drawn) pieces.push_back(all[index]);
                            replicates[k] = scale(value(pieces));
                          });
  double sum = 0, squares = 0;
  for (const double v : replicates) sum += v;
  const double mean = sum / static_cast<double>(replicates.size());
  for (const double v : replicates) squares += (v - mean) * (v - mean);
  return {value(all), std::sqrt(squares / static_cast<double>(replicates.size() - 1))};
}

}  // namespace clogflow::trade
