// What a study takes from runs and compares, on made-up numbers and a written run file.
#include <algorithm>

#include <gmock/gmock.h>

#include "coupling/files/run_file.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/faults/small_channel.hpp"
#include "trade/observables.hpp"
#include "trade/sample.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;
using namespace clogflow::trade;

/// Twenty pieces with 10 bursts each, of sizes that waver by `spread` around `mean`.
Sample bursts_of(double mean, double spread) {
  Sample sample;
  for (int k = 0; k < 20; ++k) {
    Piece piece;
    piece.seed = 1 + k / 5, piece.number = k % 5;
    piece.sizes.assign(10, mean + (k % 2 ? spread : -spread));
    sample.pieces.push_back(piece);
  }
  return sample;
}

const Observable& named(const std::string& key) { return *std::ranges::find(observables(), key, &Observable::key); }

double value(const char* key, const Pieces& pieces, double usual = 0) {
  return named(key).value(named(key), pieces, usual);
}

TEST(TradeCompare, ProvesEqualityByAnIntervalAlone) {
  const Difference clear = compare(named("mean_burst"), bursts_of(8, 1), bursts_of(10, 1));
  EXPECT_DOUBLE_EQ(clear.reference, 8);
  EXPECT_DOUBLE_EQ(clear.value, 10);
  EXPECT_NEAR(clear.difference, 0.25, 1e-12);
  EXPECT_TRUE(clear.real());
  EXPECT_LT(clear.low, 0.25);
  EXPECT_GT(clear.high, 0.25);
  EXPECT_EQ(clear.within(), clear.high);
  // Pieces out of step: the differences of the pairs are +-4 around a mean of 0.2.
  Sample noisy = bursts_of(8.2, -2);
  const Difference unclear = compare(named("mean_burst"), bursts_of(8, 2), noisy);
  EXPECT_NEAR(unclear.difference, 0.025, 1e-12);
  EXPECT_FALSE(unclear.real());
  EXPECT_GT(unclear.within(), 0.1);  // nothing is seen, and nothing near equality is proved
  EXPECT_EQ((Difference{.low = -0.04, .high = 0.01}).within(), 0.04);
  EXPECT_TRUE(std::isinf(compare(named("mean_burst"), Sample{}, Sample{}).within()));
}

TEST(TradeCompare, ObservesWhatUsersPublish) {
  Piece one, two;
  one.totals.arrests = 5, one.totals.censored = 1, one.totals.log_exposure = 6;
  two.totals.arrests = 3, two.totals.censored = 1, two.totals.log_exposure = 6;
  EXPECT_EQ(value("alpha", {&one, &two}), 1.5);
  EXPECT_EQ(value("share_censored", {&one, &two}), 0.25);
  EXPECT_TRUE(std::isnan(value("mean_burst", {&one, &two})));
  one.sizes = {0, 4, 9}, two.sizes = {7}, two.totals.cut_off_escaped = 4;
  EXPECT_EQ(value("mean_burst", {&one, &two}), 24 / 4.0);
  EXPECT_EQ(value("early_clogs", {&one, &two}, 4), 0.5);
  one.contacts_at_rest = {9, 2}, two.contacts_at_rest = {3, 1};
  EXPECT_EQ(value("coordination", {&one, &two}), 4);
  two.packing_while_flowing = {0.8, 2};
  EXPECT_EQ(value("packing_near_neck", {&one, &two}), 0.4);
  EXPECT_EQ(usual_burst({.pieces = {one, two}}), 7);
}

TEST(TradeCompare, UsesAllOfBothAndDrawsPairsTogether) {
  Sample half = bursts_of(10, 0);
  half.pieces.resize(5);
  half.pieces[0].sizes.assign(10, 6);
  const Difference d = compare(named("mean_burst"), bursts_of(8, 1), half);
  EXPECT_DOUBLE_EQ(d.reference, 8);
  EXPECT_DOUBLE_EQ(d.value, (4 * 100 + 60) / 50.0);
  EXPECT_TRUE(std::isnan(compare(named("mean_burst"), bursts_of(8, 0), Sample{}).difference));
  // The same waver in both cancels where pairs are drawn together: a tenth more stays exactly a tenth more.
  const Difference paired = compare(named("mean_burst"), bursts_of(10, 5), bursts_of(11, 5.5));
  EXPECT_NEAR(paired.low, 0.1, 1e-12);
  EXPECT_NEAR(paired.high, 0.1, 1e-12);
  // The error of a mean of 20 independent pieces that are 1 off: 1/sqrt(20), of its logarithm a mean-th of that.
  EXPECT_NEAR(spread_of(named("mean_burst"), bursts_of(8, 1), 0).error, 1 / std::sqrt(20) / 8, 0.002);
}

/// A run of ten Stokes times: three pass about 1 tau, then nothing until two pass about 6 tau, then nothing.
RunData ten_stokes_times() {
  const Scene scene = small_channel({"inlet.start=filled"});
  const double tau = scene.stokes_time();
  RunData run;
  run.seed = 3;
  run.scene_text = effective_scene(scene);
  run.end_time = 10 * tau;
  run.record.fill_time = 0;
  run.record.particle_steps = 1e6;
  run.record.processor_time = 4;
  run.record.time_step = 0.3, run.record.contact_limit = 0.5;
  for (const double t : {1.0, 1.2, 1.4, 6.0, 6.2}) {
    run.passages.time.push_back(t * tau);
    run.passages.id.push_back(static_cast<std::int64_t>(run.passages.id.size()));
    run.passages.y.push_back(0), run.passages.z.push_back(0), run.passages.friction_off.push_back(0);
  }
  // Before the first passage, flowing, too early in an arrest, late in it, flowing, late in the next.
  for (const double t : {0.5, 1.1, 3.0, 4.0, 6.1, 9.0}) {
    const auto k = static_cast<std::int64_t>(run.series.time.size());
    run.series.time.push_back(t * tau);
    run.series.count.push_back(10);
    run.series.contacts.push_back(10 + k);
    run.series.porosity.push_back({0.9, 0.9, 0.5 + 0.01 * static_cast<double>(k)});
    for (auto* column : {&run.series.packing_fraction, &run.series.kinetic_energy, &run.series.elastic_energy,
                         &run.series.largest_overlap, &run.series.drag_work, &run.series.dissipated,
                         &run.series.median_speed, &run.series.speed_q99})
      column->push_back(0);
    run.series.wall_contacts.push_back(0);
  }
  return run;
}

TEST(TradeSample, TakesPackingFromTheFlowAndContactsFromTheClog) {
  const ScratchFolder scratch;
  write_run_file(ten_stokes_times(), scratch.path() / "run_0003.h5");
  const Sample sample = read_sample(scratch.path());
  RowMean packing, contacts;
  double passages = 0;
  for (const Piece& piece : sample.pieces) {
    packing.sum += piece.packing_while_flowing.sum, packing.rows += piece.packing_while_flowing.rows;
    contacts.sum += piece.contacts_at_rest.sum, contacts.rows += piece.contacts_at_rest.rows;
    passages += piece.totals.passages;
  }
  EXPECT_EQ(passages, 5);
  EXPECT_EQ(packing.rows, 2);
  EXPECT_NEAR(packing.sum, (1 - 0.51) + (1 - 0.54), 1e-12);  // of the last strip
  EXPECT_EQ(contacts.rows, 2);
  EXPECT_NEAR(contacts.sum, 2 * 1.3 + 2 * 1.5, 1e-12);  // each contact is one of two particles
  EXPECT_EQ(sample.processor_seconds, 4);
  EXPECT_DOUBLE_EQ(sample.mean_step, 0.6);
  EXPECT_DOUBLE_EQ(sample.largest_step, 0.6);
}

TEST(TradeSample, SaysWhatARecordLacks) {
  const ScratchFolder scratch;
  RunData run = ten_stokes_times();
  run.record.processor_time.reset();
  write_run_file(run, scratch.path() / "run_0003.h5");
  EXPECT_THAT(refusal([&] { read_sample(scratch.path()); }),
              HasSubstr("run_0003.h5: its record has no processor_time_s (made by another program?)"));
}

}  // namespace
}  // namespace clogflow::test
