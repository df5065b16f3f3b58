// Scenes at the edge of sense: no particle, one too large, an inlet without room, a field that is no field.
#include <sys/stat.h>

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "dem/protocol/clog_watch.hpp"
#include "dem/state/initial_particles.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/faults/small_channel.hpp"

namespace clogflow::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(NoParticle, ALaboratoryWithoutAnyRuns) {
  Scene scene = laboratory_scene({}, 1e-4);
  set_floor(scene, 1);
  scene.time.end = 0.01;
  const RunData run = Simulation(scene, nullptr, 1).run();
  EXPECT_EQ(run.snapshots.back().id.size(), 0u);
  EXPECT_NEAR(run.end_time, 0.01, 1e-9);
}

TEST(NoParticle, AnEmptyChannelAndATinyEnd) {
  const Scene scene = small_channel({"inlet.start=empty", "time.end=1 us"});
  const FlowGrid flow = synthetic_flow(scene);
  const RunData run = Simulation(scene, &flow, 1).run();
  EXPECT_TRUE(run.passages.time.empty());
  EXPECT_GT(run.end_time, 0);
}

TEST(NoParticle, AnEmptyFileIsRefused) {
  for (const char* text : {"", "\n\n", "x,y,z\n", "# nothing\n"}) {
    const ScratchFile file(text);
    Scene scene = laboratory_scene({}, 1e-4);
    scene.particles.initial = file.name();
    EXPECT_THAT(refusal([&] { read_initial_particles(scene); }), HasSubstr("holds no particle"));
  }
}

TEST(TooLarge, AParticleForTheNeckIsRefused) {
  for (const char* diameter : {"100 um", "101 um", "1 m"})
    EXPECT_THAT(refusal([&] { small_channel({fmt::format("particles.diameter={}", diameter)}); }),
                AllOf(HasSubstr("must be smaller than geometry.neck_width"), HasSubstr("no particle fits through")));
}

// The slab of the inlet has room for two or three; attempts are bounded and those refused are counted.
TEST(FullInlet, EndsAndIsCounted) {
  const Scene scene = small_channel({"particles.diameter=95 um", "time.end=5 ms", "geometry.channel_width=110 um"});
  const FlowGrid flow = synthetic_flow(scene);
  const RunData run = Simulation(scene, &flow, 1).run();
  EXPECT_GT(run.record.insertions_refused.value(), 0);
  EXPECT_GT(run.record.inserted.value(), 0);
}

// One sphere fills the whole channel and cannot leave in this time: no second ever finds room.
TEST(FullInlet, ThatCanInsertNothingSaysSoAndEnds) {
  const Scene scene = small_channel({"particles.diameter=95 um", "time.end=2 ms", "geometry.channel_width=100 um",
                                     "geometry.channel_length=96 um", "unclog.protocol=none"});
  const FlowGrid flow = synthetic_flow(scene);
  Simulation simulation(scene, &flow, 1);
  std::vector<std::string> notes;
  simulation.on_note([&](const std::string& note) { notes.push_back(note); });
  const RunData run = simulation.run();
  EXPECT_THAT(notes, testing::Contains(HasSubstr("the inlet found no room for any particle in ")));
  EXPECT_GT(run.record.insertions_refused.value(), 0);
}

// A channel shorter than the slab of the inlet: nothing may stand in the slanted walls.
TEST(FullInlet, OfAShortChannelKeepsOutOfTheNarrowing) {
  const Scene scene = small_channel(
      {"particles.diameter=60 um", "geometry.channel_length=65 um", "inlet.start=empty", "time.end=10 us"});
  const FlowGrid flow = synthetic_flow(scene);
  const RunData run = Simulation(scene, &flow, 1).run();
  ASSERT_GT(run.record.inserted.value(), 0);
  EXPECT_LE(*std::max_element(run.series.largest_overlap.begin(), run.series.largest_overlap.end()), 0.002 * 60e-6);
}

// A pack is at rest below a share of the flow's speed, whatever the flow comes from: without that a filled start never
// ended.
TEST(UniformFlow, TellsWhatRestIsAndFillsAChannel) {
  const Scene scene = small_channel({"flow.source=uniform", "flow.velocity=5 mm/s", "time.end=1 ms"});
  EXPECT_DOUBLE_EQ(scene.flow_speed(), 5e-3);
  EXPECT_DOUBLE_EQ(rest_speed(scene), rest_speed(small_channel({"flow.mean_velocity=5 mm/s"})));
  EXPECT_GT(Simulation(scene, nullptr, 1).run().record.fill_time.value(), 0);
}

TEST(UniformFlow, AloneFillsAChannelAndEndsClogs) {
  const Overrides pushed = {"flow.source=none", "body_force=[\"1 nN\", \"0 N\", \"0 N\"]", "unclog.after=1 ms",
                            "output.series_interval=1 ms", "porosity.update_interval=1 ms"};
  const auto with = [&](const char* more) {
    Overrides all = pushed;
    all.push_back(more);
    return refusal([&] { small_channel(all); });
  };
  EXPECT_THAT(with("unclog.protocol=none"), AllOf(HasSubstr("inlet.start"), HasSubstr("a flow must fill the channel")));
  EXPECT_THAT(with("inlet.start=empty"), AllOf(HasSubstr("unclog.protocol"), HasSubstr("needs a flow")));
}

TEST(Steps, MoreThanCanBeCountedAreRefused) {
  Scene scene = small_channel({"flow.source=uniform", "flow.velocity=5 mm/s"});
  for (const auto& [end, step] : {std::pair{1e300, 0.0}, {0.02, 1e-300}}) {
    scene.time.end = end, scene.time.step = step;
    EXPECT_THAT(refusal([&] { Simulation(scene, nullptr, 1); }), AllOf(HasSubstr("time.end"), HasSubstr(" steps of ")));
  }
}

TEST(PassagePlane, OutsideTheChannelIsRefused) {
  for (const char* plane : {"1 m", "-1 m"})
    EXPECT_THAT(refusal([&] { small_channel({fmt::format("passages.plane={}", plane)}); }),
                AllOf(HasSubstr("passages.plane"), HasSubstr("must be in the channel, from ")));
}

TEST(FlowFile, IsNeverPutInThePlaceOfADevice) {
  const ScratchFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0666), 0);
  EXPECT_THAT(refusal([&] { write_flow_grid(synthetic_flow(small_channel()), pipe); }), HasSubstr("cannot be written"));
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(FlowFile, WithNaNIsNeitherWrittenNorRead) {
  const ScratchFolder folder;
  FlowGrid flow = synthetic_flow(small_channel());
  flow.velocity[flow.velocity.size() / 3] = std::nanf("");
  EXPECT_THAT(refusal([&] { write_flow_grid(flow, folder.path() / "flow.h5"); }), HasSubstr("holds NaN or infinity"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "flow.h5"));
}

TEST(FlowFile, OfAnotherGeometryIsRefusedByName) {
  const Scene scene = small_channel();
  for (const char* other : {"geometry.neck_width=120 um", "geometry.channel_length=300 um",
                            "geometry.half_angle=45 deg", "fluid.viscosity=1 mPa s"}) {
    const FlowGrid flow = synthetic_flow(small_channel({other}));
    const std::string key(other, std::string(other).find('='));
    EXPECT_THAT(refusal([&] { Simulation(scene, &flow, 1); }),
                AllOf(HasSubstr("another scene"), HasSubstr(key.substr(key.find('.') + 1))));
  }
}

}  // namespace
}  // namespace clogflow::test
