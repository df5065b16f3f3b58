// States that pass their checksum and yet are none of ours: refused in one line, or the run goes on with
// them to its end or to a line; never a crash. tests/fuzz/fuzz_resume.cpp tries the same at random.
#include <cstring>
#include <optional>

#include <gmock/gmock.h>

#include "tests/coupling/refusal.hpp"
#include "tests/faults/small_channel.hpp"

namespace clogflow::test {
namespace {

using testing::HasSubstr;

class ForgedStates : public testing::Test {
protected:
  ForgedStates() : scene_(small_channel({"time.end=2 ms"})), flow_(synthetic_flow(scene_)) {
    int looks = 0;
    Simulation simulation(scene_, &flow_, 1);
    simulation.run([&](const Progress& progress) {
      if (++looks == 3) filling_ = simulation.save();
      if (!progress.filling && flowing_.empty()) flowing_ = simulation.save();
    });
  }

  /// Resumes and goes on for some hundred steps. \return the refusal, or an empty text
  std::string go_on(const std::string& state) {
    Simulation simulation(scene_, &flow_, 1);
    int looks = 0;
    const std::string message = refusal([&] {
      simulation.resume(state);
      simulation.run([&](const Progress&) { require(++looks < 2, "long enough"); });
    });
    return message == "long enough" ? "" : message;
  }

  Scene scene_;
  FlowGrid flow_;
  std::string filling_, flowing_;
};

template <class T>
std::string replaced(std::string state, std::size_t at, T value) {
  std::memcpy(state.data() + at, &value, sizeof value);
  return state;
}

TEST_F(ForgedStates, TheTrueOnesAreTaken) {
  EXPECT_EQ(go_on(filling_), "");
  EXPECT_EQ(go_on(flowing_), "");
}

TEST_F(ForgedStates, NoNumberThatIsReplacedEndsTheProgram) {
  int refused = 0, tried = 0;
  for (const std::string& state : {filling_, flowing_})
    for (std::size_t at = 0; at + 8 <= state.size(); at += 92) {
      const std::string message = tried % 3 == 0   ? go_on(replaced(state, at, std::nan("")))
                                  : tried % 3 == 1 ? go_on(replaced(state, at, std::int64_t{-7}))
                                                   : go_on(replaced(state, at, 1e18));
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      refused += !message.empty();
      ++tried;
    }
  EXPECT_GT(refused, tried / 4);
}

TEST_F(ForgedStates, CutShortOrTooLongIsRefused) {
  for (std::size_t length = 0; length < flowing_.size(); length += 997)
    EXPECT_THAT(go_on(flowing_.substr(0, length)), HasSubstr("a saved state")) << length;
  EXPECT_THAT(go_on(flowing_ + "x"), HasSubstr("longer than it should be"));
}

TEST_F(ForgedStates, OfAnotherSeedIsRefused) {
  Simulation simulation(scene_, &flow_, 2);
  EXPECT_THAT(refusal([&] { simulation.resume(flowing_); }),
              HasSubstr("a saved state is damaged (of another scene or seed)"));
}

// Unlimited space: the places of particles are held in lists of cells whose numbers must fit an int.
TEST(FarAway, ParticlesInFreeFlightNeedNoMoreCells) {
  Laboratory lab(laboratory_scene({}, 1e-4), {{.radius = 0.01, .x = -1e200},
                                              {.radius = 0.01, .x = 1e200},
                                              {.radius = 0.01, .x = 0},
                                              {.radius = 0.01, .x = 0.0199}});
  lab.step();
  EXPECT_EQ(lab->pair_tally().contacts, 1);
}

/// A state of a run that rewinds, with the clog there: the next step puts the kept column back.
std::string about_to_go_back(Simulation& simulation) {
  simulation.fill({});
  while (!simulation.state().clog_watch.goes_back() && simulation.time() < simulation.model().scene.time.end) {
    simulation.compute_forces();
    simulation.record();
    simulation.advance();
  }
  return simulation.state().clog_watch.goes_back() ? simulation.save() : "";
}

TEST(ForgedColumns, AreRefusedOrGoneOnFrom) {
  const Scene scene = small_channel(
      {"inlet.start=flowing", "inlet.strain=0.5", "unclog.protocol=rewind", "unclog.strain=0.1", "time.end=60 ms"});
  const FlowGrid flow = synthetic_flow(scene);
  Simulation simulation(scene, &flow, 1);
  const std::string state = about_to_go_back(simulation);
  ASSERT_FALSE(state.empty()) << "no clog";
  const auto go_on = [&](const std::string& bytes) {
    return refusal([&] {
      Simulation resumed(scene, &flow, 1);
      resumed.resume(bytes);
      for (int step = 0; step < 3; ++step) resumed.compute_forces(), resumed.record(), resumed.advance();
      throw Error("long enough");
    });
  };
  EXPECT_EQ(go_on(state), "long enough");
  int of_column = 0;
  for (std::size_t at = 0; at + 8 <= state.size(); at += 92)
    of_column +=
        go_on(replaced(state, at, std::nan(""))).find("a saved state is damaged (kept column)") != std::string::npos;
  EXPECT_GT(of_column, 0);
}

}  // namespace
}  // namespace clogflow::test
