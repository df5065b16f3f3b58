// A run that goes on to a later end has the bits of one in one go; what decides nothing may change
// on the way.
#include <gmock/gmock.h>

#include "coupling/scene/scene_difference.hpp"
#include "dem/run/checkpoint.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/faults/small_channel.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

struct Case {
  const char* name;
  Overrides overrides;
  double step = 0;  // given instead of a share of the contact time [s]
};

class Lengthened : public testing::TestWithParam<Case> {
protected:
  static Scene scene(const std::string& end, const Overrides& more = {}) {
    Overrides all = GetParam().overrides;
    all.push_back("time.end=" + end);
    all.insert(all.end(), more.begin(), more.end());
    Scene scene = small_channel(all);
    if (GetParam().step > 0) scene.time.step = GetParam().step, scene.time.step_fraction = 0;
    return scene;
  }
};

/// Over again from what a run left behind, as through its file.
RunData go_on(const Scene& scene, const FlowGrid* flow, const RunData& done) {
  const ScratchFolder folder;
  write_run_file(done, folder.path() / "run.h5");
  Simulation simulation(scene, flow, 3);
  simulation.lengthen(read_run_file(folder.path() / "run.h5"), read_end_state(folder.path() / "run.h5"));
  return simulation.run();
}

TEST_P(Lengthened, TwiceItIsTheRunInOneGo) {
  const Scene whole = scene("14 ms");
  const FlowGrid flow = synthetic_flow(whole);
  const RunData in_one_go = Simulation(whole, &flow, 3).run();
  // Ends between two steps, two series, in the middle of a release or not: several of them.
  const RunData shortest = Simulation(scene("0.001 ms"), &flow, 3).run();
  for (const char* end : {"4.21 ms", "7.3 ms", "10 ms"}) {
    const RunData part = go_on(scene(end), &flow, shortest);
    EXPECT_TRUE(result_bytes(go_on(whole, &flow, part)) == result_bytes(in_one_go)) << end;
  }
}

TEST_P(Lengthened, AStoppedOneGoesOnToALaterEndOrAnEarlierOneNotYetReached) {
  const Scene whole = scene("14 ms");
  const FlowGrid flow = synthetic_flow(whole);
  const std::string in_one_go = result_bytes(Simulation(whole, &flow, 3).run());
  std::vector<std::string> states;
  for (const char* other : {"9 ms", "99 ms"}) {
    Simulation stopped(scene(other), &flow, 3);
    refusal([&] {
      stopped.run([&](const Progress& progress) {
        if (progress.steps % 1024 == 0 || progress.filling) states.push_back(stopped.save());
        require(progress.filling || progress.time < 0.008, "stopped");
      });
    });
  }
  ASSERT_GE(states.size(), 6u);
  for (std::size_t k = 0; k < states.size(); k += 1 + states.size() / 4) {
    Simulation resumed(whole, &flow, 3);
    resumed.resume(states[k]);
    EXPECT_TRUE(result_bytes(resumed.run()) == in_one_go) << "state " << k;
  }
}

TEST_P(Lengthened, OtherIntervalsChangeWhatIsWrittenDownFromThereOnAndNothingElse) {
  const Scene whole = scene("14 ms", {"output.series_interval=0.37 ms", "output.snapshot_interval=1.7 ms"});
  const FlowGrid flow = synthetic_flow(whole);
  const RunData fine = Simulation(whole, &flow, 3).run();
  const RunData coarse =
      Simulation(scene("6 ms", {"output.series_interval=2 ms", "output.snapshot_interval=0 s"}), &flow, 3).run();
  const RunData changed = go_on(whole, &flow, coarse);
  EXPECT_EQ(changed.passages.time, fine.passages.time);
  EXPECT_EQ(changed.passages.y, fine.passages.y);
  EXPECT_EQ(changed.releases.off, fine.releases.off);
  EXPECT_EQ(changed.releases.on, fine.releases.on);
  EXPECT_EQ(changed.snapshots.back().position, fine.snapshots.back().position);
  EXPECT_EQ(changed.snapshots.back().force, fine.snapshots.back().force);
  // From the change on the rows are those of the run that had these intervals from the start.
  const auto later = [](const RunData& run) {
    std::vector<std::pair<double, double>> rows;
    for (std::size_t k = 0; k < run.series.time.size(); ++k)
      if (run.series.time[k] > 0.006) rows.emplace_back(run.series.time[k], run.series.dissipated[k]);
    return rows;
  };
  EXPECT_GT(later(fine).size(), 15u);
  EXPECT_EQ(later(changed), later(fine));
  std::vector<double> times;
  for (const auto& snapshot : changed.snapshots) times.push_back(snapshot.time);
  EXPECT_TRUE(std::ranges::is_sorted(times));
  EXPECT_EQ(times.size(), 1 + std::ranges::count_if(fine.snapshots, [](const auto& s) { return s.time > 0.006; }));
}

// NOLINTNEXTLINE(cert-err58-cpp)
INSTANTIATE_TEST_SUITE_P(
    Scenes, Lengthened,
    testing::Values(Case{"Release", {}}, Case{"StartEmpty", {"inlet.start=empty", "inlet.rate=2000 1/s"}},
                    Case{"GivenStep", {}, 0.7e-6},
                    Case{"ImplicitFluid", {"time.integrator=implicit_fluid", "lubrication.walls=true"}},
                    Case{"Noise",
                         {"drag.fluctuation.strength=0.8", "drag.fluctuation.time=0.5 ms",
                          "flow.pulsation.strength=0.3", "flow.pulsation.time=1 ms"}},
                    Case{"Compliance",
                         {"flow.compliance=1e-14 m3/Pa", "drag.velocity=mixture", "time.integrator=implicit_drag"}},
                    Case{"ShareOfTheLimit",
                         {"time.step_fraction=1", "time.contact_limit_share=0.3", "output.snapshot_interval=0 s"}}),
    [](const auto& info) { return info.param.name; });

TEST(LengthenedStop, AClogThatEndedARunEndsTheLongerOneToo) {
  const auto until = [](const char* end) {
    return small_channel(
        {"unclog.protocol=stop", "inlet.start=flowing", "inlet.strain=0.5", std::string("time.end=") + end});
  };
  const FlowGrid flow = synthetic_flow(until("200 ms"));
  const RunData whole = Simulation(until("200 ms"), &flow, 3).run();
  ASSERT_TRUE(whole.record.clogged_at.has_value());
  for (const char* end : {"1 ms", "150 ms"}) {
    const RunData longer = go_on(until("200 ms"), &flow, Simulation(until(end), &flow, 3).run());
    EXPECT_TRUE(result_bytes(longer) == result_bytes(whole)) << end;
    EXPECT_EQ(longer.record.clogged_at, whole.record.clogged_at) << end;
    EXPECT_EQ(longer.record.clog_position, whole.record.clog_position) << end;
  }
}

TEST(LengthenedRefusals, AStateBeyondTheEndAndOfAnotherScene) {
  const Scene whole = small_channel({"time.end=12 ms"});
  const FlowGrid flow = synthetic_flow(whole);
  std::string late;
  Simulation simulation(whole, &flow, 3);
  const RunData done = simulation.run([&](const Progress& progress) {
    if (!progress.filling) late = simulation.save();
  });
  const Scene earlier = small_channel({"time.end=5 ms"});
  EXPECT_THROW(Simulation(earlier, &flow, 3).resume(late), StateRefused);
  EXPECT_THAT(refusal([&] { Simulation(earlier, &flow, 3).lengthen(done, done.end_state); }),
              HasSubstr("beyond time.end = 0.005 s"));
  const Scene other = small_channel({"time.end=24 ms", "contact.friction.sliding=0.5"});
  EXPECT_THAT(refusal([&] { Simulation(other, &flow, 3).lengthen(done, done.end_state); }),
              HasSubstr("of another scene or seed"));
  RunData cut = done;
  cut.series.time.resize(3);
  const Scene longer = small_channel({"time.end=14 ms"});
  EXPECT_THAT(refusal([&] { Simulation(longer, &flow, 3).lengthen(cut, done.end_state); }),
              HasSubstr("not of what its run recorded"));
}

TEST(SceneDifferences, AreFoundByValueWhereverTheyStand) {
  const std::string one =
      "[particles]\ndiameter = \"3.3e-05 m\"\n\n[geometry]\nhalf_angle = \"1.0471975511965976 "
      "rad\"\n";
  EXPECT_TRUE(
      scene_differences(one, "[geometry]\nhalf_angle = \"60 deg\"\n\n[particles]\ndiameter = \"33 um\"\n").empty());
  const auto longer = scene_differences(one, one + "\n[time]\nend = \"1 s\"\n");
  ASSERT_EQ(longer.size(), 1u);
  EXPECT_EQ(longer[0].words(), "time.end = nothing, now \"1 s\"");
  EXPECT_EQ(scene_differences(one + "\n[time]\nend = \"1 s\"\n", one)[0].words(), "time.end = \"1 s\", now nothing");
  const auto wider =
      scene_differences(one, "[particles]\ndiameter = \"34 um\"\n\n[geometry]\nhalf_angle = \"60 deg\"\n");
  EXPECT_EQ(find_role(wider, KeyRole::trajectory)->words(), "particles.diameter = \"33 um\", now \"34 um\"");
  EXPECT_FALSE(find_role(wider, KeyRole::length));
  const auto wedge =
      scene_differences(one, "[particles]\ndiameter = \"33 um\"\n\n[geometry]\nhalf_angle = \"45 deg\"\n");
  ASSERT_EQ(wedge.size(), 1u);
  EXPECT_EQ(wedge[0].words(), "geometry.half_angle = \"60 deg\", now \"45 deg\"");
}

TEST(SceneDifferences, OfAnEarlierProgramAreNoneWhereALaterKeyHasTheValueOfThen) {
  const std::string before = "[contact]\nrestitution = 0.7\n";
  EXPECT_TRUE(scene_differences(before, "[contact]\nlaw = \"hertz\"\nrestitution = 0.7\n").empty());
  const auto other = scene_differences(before, "[contact]\nlaw = \"hooke\"\nrestitution = 0.7\n");
  ASSERT_EQ(other.size(), 1u);
  EXPECT_EQ(other[0].words(), "contact.law = nothing, now \"hooke\"");
}

}  // namespace
}  // namespace clogflow::test
