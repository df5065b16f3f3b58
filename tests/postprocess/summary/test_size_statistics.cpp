// Which particles passed: counts by hand, through run files and stats.json.
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "postprocess/output/statistics_files.hpp"
#include "postprocess/summary/size_statistics.hpp"
#include "tests/postprocess/synthetic_ensemble.hpp"
#include "tests/scratch.hpp"

namespace clogflow::postprocess {
namespace {

const SyntheticEnsemble mixed{.snapshot_interval = 0,
                              .overrides = {R"(particles.species=[{diameter="30 um",share=0.75},)"
                                            R"({diameter="42 um",share=0.25,density="1200 kg/m3"}])"}};

/// Of every five that pass, the last two are large.
RunData two_of_five(std::uint64_t seed) {
  RunData run = synthetic_run(mixed, seed);
  for (std::size_t i = 0; i < run.passages.time.size(); ++i) {
    run.passages.species.push_back(i % 5 < 3 ? 0 : 1);
    run.passages.radius.push_back(i % 5 < 3 ? 15e-6 : 21e-6);
  }
  return run;
}

TEST(SizeStatistics, CountThePassagesOfEachSpecies) {
  const ScratchFolder folder;
  std::size_t passages = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const RunData run = two_of_five(seed);
    passages += run.passages.time.size();
    write_run_file(run, folder.path() / run_file_name(seed));
  }
  const auto groups = gather({folder.path()}, {});
  const auto sizes = size_statistics(groups.at(0), {.replicates = 200});
  ASSERT_TRUE(sizes);
  EXPECT_DOUBLE_EQ(sizes->feed_diameter, 33e-6);
  // 30 and 42 um, three to one: variance 0.75 x 9 + 0.25 x 81 = 27 um2
  EXPECT_NEAR(sizes->feed_spread, std::sqrt(27.0) / 33, 1e-9);
  ASSERT_EQ(sizes->species.size(), 2u);
  EXPECT_EQ(sizes->species[0].feed_share, 0.75);
  EXPECT_EQ(sizes->species[1].density, 1200);
  EXPECT_EQ(sizes->species[0].passages + sizes->species[1].passages, static_cast<double>(passages));
  const Estimate& large = sizes->species[1].passage_share;
  EXPECT_NEAR(large.value, 0.4, 10.0 / static_cast<double>(passages));
  EXPECT_LE(large.low, large.value);
  EXPECT_NEAR(sizes->passage_diameter.value, 30e-6 + 12e-6 * large.value, 1e-12);
}

TEST(SizeStatistics, ReachStatsJson) {
  const ScratchFolder folder;
  for (const std::uint64_t seed : {1, 2}) write_run_file(two_of_five(seed), folder.path() / run_file_name(seed));
  StatisticsJob job{.folders = {folder.path()}, .out = folder.path() / "stats", .threshold = {}, .request = {}};
  job.request.p_value_replicates = 50;
  write_statistics(job);
  std::ifstream in(folder.path() / "stats" / "stats.json");
  const auto group = nlohmann::json::parse(in).at("groups").at(0);
  EXPECT_NEAR(group.at("sizes").at("species").at(1).at("passage_share").at("value").get<double>(), 0.4, 0.03);
  EXPECT_EQ(group.at("sizes").at("species").at(1).at("feed_share"), 0.25);
}

TEST(SizeStatistics, AreAbsentWhereParticlesAreEqual) {
  const ScratchFolder folder;
  write_run_file(synthetic_run({.snapshot_interval = 0}, 1), folder.path() / run_file_name(1));
  EXPECT_FALSE(size_statistics(gather({folder.path()}, {}).at(0), {.replicates = 200}));
}

TEST(SizeStatistics, RunFilesKeepSizesAndRefuseHalfOfThem) {
  const ScratchFolder folder;
  RunData run = two_of_five(1);
  write_run_file(run, folder.path() / "run_0001.h5");
  const RunData read = read_run_file(folder.path() / "run_0001.h5");
  EXPECT_EQ(read.passages.radius, run.passages.radius);
  EXPECT_EQ(read.passages.species, run.passages.species);
  run.passages.species.clear();
  EXPECT_THAT(fault(run), testing::HasSubstr("without the other"));
  run.passages.species.assign(3, 0);
  EXPECT_THAT(fault(run), testing::HasSubstr("/passages/species has 3 rows"));
}

}  // namespace
}  // namespace clogflow::postprocess
