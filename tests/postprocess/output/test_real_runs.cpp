// What the solver writes is what the statistics read: names and meanings, with no fixture between.
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "coupling/base/child_process.hpp"
#include "coupling/base/source_folder.hpp"
#include "coupling/files/record_json.hpp"
#include "coupling/files/run_file.hpp"
#include "tests/scratch.hpp"

namespace clogflow::postprocess {
namespace {

using nlohmann::json;

std::vector<std::string> small_channel() {
  return {"flow.source=uniform", "flow.velocity=5 mm/s",           "particles.diameter=50 um",
          "inlet.taps=1",        "geometry.channel_length=200 um", "time.rotational_inertia_scale=5",
          "time.mass_scale=10",  "time.step_fraction=0.04"};
}

/// What the program printed.
std::string run(std::vector<std::string> words, const std::vector<std::string>& overrides) {
  words.insert(words.begin(), CLOG_PROGRAM);
  for (const std::string& each : overrides) words.insert(words.end(), {"--set", each});
  const ChildResult result = run_program(words);
  EXPECT_EQ(result.status, 0) << result.output;
  return result.output;
}

/// A channel of some ten particles in a uniform flow, filled behind a gate and released: a second of computing.
class RealRun : public testing::Test {
protected:
  static void SetUpTestSuite() {
    here_ = scratch_folder() / "clog_real_run";
    std::filesystem::remove_all(here_);
    auto overrides = small_channel();
    overrides.insert(overrides.end(),
                     {"time.end=20 ms", "unclog.after=3 ms", "inlet.start=filled", "unclog.protocol=release"});
    run({"run", source_folder() / "scenes" / "paper.toml", "--out", here_, "--seeds", "1"}, overrides);
    run({"stats", here_, "--out", here_ / "stats", "--p-value", "10"}, {});
    group_ = json::parse(std::ifstream(here_ / "stats" / "stats.json"))["groups"][0];
    data_ = read_run_file(here_ / run_file_name(1));
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(here_); }

  static inline std::filesystem::path here_;
  static inline json group_;
  static inline RunData data_;
};

TEST_F(RealRun, records_every_name_that_is_read_again) {
  for (const auto entry :
       {&RunRecord::wall_time, &RunRecord::processor_time, &RunRecord::fill_time, &RunRecord::time_step,
        &RunRecord::contact_limit, &RunRecord::particle_steps, &RunRecord::particle_steps_per_s})
    EXPECT_GT((data_.record.*entry).value_or(0), 0) << entry_name(entry);
  EXPECT_TRUE(data_.record.inputs_hash);
}

TEST_F(RealRun, statistics_carry_its_record) {
  const json& run = group_.at("runs").at(0);
  EXPECT_EQ(run.at("filling_time"), data_.record.fill_time.value());
  EXPECT_GT(run.at("filling_time").get<double>(), 0);
  EXPECT_EQ(run.at("wall_time"), data_.record.wall_time.value());
  EXPECT_EQ(run.at("end"), data_.end_time);
  EXPECT_EQ(run.at("passages"), data_.passages.time.size());
  EXPECT_EQ(run.at("releases"), data_.releases.off.size());
  EXPECT_EQ(group_.at("provenance"), record_json(data_.record));
}

TEST_F(RealRun, statistics_carry_its_series) {
  EXPECT_GT(group_.at("steady").at("particles").at("value").get<double>(), 0);
  EXPECT_GT(group_.at("steady").at("packing_fraction").at("value").get<double>(), 0.1);
  EXPECT_EQ(group_.at("steady").at("porosity").size(), data_.series.porosity.front().size());
}

TEST_F(RealRun, becomes_a_report) {
  run({"report", here_ / "stats"}, {});
  EXPECT_TRUE(std::filesystem::exists(here_ / "stats" / "report" / "report.html"));
}

// Seeds 2 and 3 flow before time 0 and then clog; the run says so, and everything downstream agrees with it.
TEST(RealStop, ends_at_its_first_clog_and_becomes_a_first_burst) {
  const auto here = scratch_folder() / "clog_real_stop";
  auto overrides = small_channel();
  overrides.insert(overrides.end(),
                   {"time.end=200 ms", "inlet.start=flowing", "inlet.strain=1", "unclog.protocol=stop"});
  run({"run", source_folder() / "scenes" / "paper.toml", "--out", here, "--seeds", "2-3"}, overrides);
  const std::string said = run({"stats", here, "--out", here / "stats", "--p-value", "0"}, {});
  EXPECT_THAT(said, testing::HasSubstr(" passages until the first clog, 2 seeds, 0 cut by the end; geometric law "));
  EXPECT_THAT(said, testing::HasSubstr("; packing near the neck 0."));
  const json group = json::parse(std::ifstream(here / "stats" / "stats.json"))["groups"][0];
  const json& first = group.at("first_burst");
  EXPECT_EQ(group.at("protocol"), "stop");
  EXPECT_EQ(first.at("clogged"), 2);
  std::size_t passages = 0;
  for (const std::uint64_t seed : {2, 3}) {
    const RunData data = read_run_file(here / run_file_name(seed));
    EXPECT_EQ(data.record.clogged_at, data.end_time);
    EXPECT_TRUE(data.record.start_flowed.value_or(false));
    passages += data.passages.time.size();
  }
  EXPECT_GT(passages, 0U);
  EXPECT_EQ(first.at("passages"), passages);
  EXPECT_EQ(first.at("mean").at("value"), 0.5 * static_cast<double>(passages));
  EXPECT_EQ(first.at("clog_places").at("known"), 2);
  EXPECT_EQ(first.at("jammed_starts"), 0);
  run({"report", here / "stats"}, {});
  EXPECT_TRUE(std::filesystem::exists(here / "stats" / "report" / "first_burst.png"));
  std::filesystem::remove_all(here);
}

}  // namespace
}  // namespace clogflow::postprocess
