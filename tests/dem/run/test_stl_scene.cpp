// A channel from an STL file in the solver: where particles enter, where they leave, what closes it.
#include <gmock/gmock.h>

#include "coupling/base/source_folder.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "dem/run/inlet.hpp"
#include "dem/run/simulation.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

Scene pore(Overrides overrides = {}) {
  overrides.insert(overrides.begin(), {"flow.source=uniform", "time.end=1 ms", "inlet.start=empty"});
  return read_scene(source_folder() / "scenes" / "pore.toml", overrides);
}

TEST(StlScene, HasTheSameEndsGateAndStripsAsAChannelOfKeys) {
  const Scene scene = pore();
  const Model model = make_model(scene, nullptr, {});
  EXPECT_NEAR(model.domain.low.x, -480e-6, 1e-9);
  EXPECT_NEAR(model.domain.outlet, 100e-6, 1e-9);
  EXPECT_NEAR(model.domain.passage, 50e-6, 1e-9);
  EXPECT_TRUE(model.walls_note.empty()) << model.walls_note;
  ASSERT_EQ(model.gate.size(), 2u);
  for (const Triangle& t : model.gate)
    for (const Vec3& corner : t.corner) {
      EXPECT_EQ(corner.x, 0);
      EXPECT_NEAR(std::abs(corner.y), 50e-6, 1e-9);
    }
  // The straight part alone, by hand: 300 x 300 x 100 um3.
  EXPECT_NEAR(channel_volume(scene.geometry, -480e-6, -180e-6) / 9e-12, 1, 1e-6);
  const Fluid fluid = make_fluid(scene, nullptr);
  EXPECT_EQ(fluid.strips().porosity().size(), 3u);
}

/// A channel that was scattered full.
struct Filled {
  explicit Filled(const Scene& scene) : model(make_model(scene, nullptr, {})), inlet(model) {
    inlet.scatter(particles, random);
  }
  Model model;
  Inlet inlet;
  Particles particles;
  RandomStream random{3};
};

TEST(StlScene, ParticlesEnterBetweenTheWalls) {
  const Scene scene = pore();
  const Filled filled(scene);
  const Particles& p = filled.particles;
  EXPECT_GT(p.size(), 100u);
  const double r = scene.particles.diameter / 2;
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_GE(p[i].x - r, -480.001e-6);
    EXPECT_LE(p[i].x + r, -179.9e-6);
    EXPECT_LE(std::abs(p[i].y) + r, 150.001e-6);
  }
}

Scene shipped(const char* scene, Overrides overrides = {}) {
  overrides.insert(overrides.begin(), {"flow.source=uniform", "time.end=1 ms", "inlet.start=empty"});
  return read_scene(source_folder() / "scenes" / scene, overrides);
}

TEST(StlScene, AFlowRateIsThatOfTheRoundInlet) {
  // 10 uL/min through a circle of 300 um that has 48 sides, of area 24 r^2 sin(2 pi / 48).
  const Scene scene = shipped("pipe.toml", {"flow.rate=10 uL/min"});
  EXPECT_NEAR(scene.flow.mean_velocity * 24 * std::pow(150e-6, 2) * std::sin(M_PI / 24) / (1e-8 / 60), 1, 1e-3);
}

TEST(StlScene, ParticlesEnterARoundInletWithinItsCircle) {
  const Scene scene = shipped("pipe.toml", {"particles.diameter=30 um"});
  Filled filled(scene);
  Particles& p = filled.particles;
  // A third of the pipe's volume, not of the box around it.
  const double length = 500e-6, solids = static_cast<double>(p.size()) * M_PI / 6 * std::pow(30e-6, 3);
  EXPECT_NEAR(solids / (scene.geometry.inlet_area * length), 0.30, 0.01);
  p = {};
  const Fluid fluid = make_fluid(scene, nullptr);
  for (int k = 0; k < 200; ++k) filled.inlet.insert(p, fluid, filled.random, 0);
  ASSERT_GT(p.size(), 40u);
  for (std::size_t i = 0; i < p.size(); ++i)
    EXPECT_LE(std::hypot(p[i].y, p[i].z - 150e-6) + 15e-6, 150e-6 * std::cos(M_PI / 48) + 1e-9);
}

TEST(StlScene, TheGateSpansAllNecksAndPassagesHaveTheirs) {
  const ScratchFile start("x,y,z\n40e-6,-75e-6,50e-6\n30e-6,75e-6,50e-6\n20e-6,70e-6,50e-6\n", ".csv");
  const Scene scene = shipped("two_necks.toml", {"inlet.enabled=false", "unclog.protocol=none", "time.end=8 ms",
                                                 "particles.diameter=5 um", "particles.initial=" + start.name()});
  EXPECT_EQ(make_model(scene, nullptr, {}).necks.size(), 2u);
  for (const Triangle& t : make_model(scene, nullptr, {}).gate)
    for (const Vec3& corner : t.corner) EXPECT_NEAR(std::abs(corner.y), 125e-6, 1e-9);
  Simulation simulation(scene, nullptr, 1);
  const RunData run = simulation.run();
  EXPECT_EQ(run.record.necks, 2);
  EXPECT_EQ(run.passages.neck, (std::vector<std::int64_t>{0, 1, 1}));
  // One neck has no such column.
  Simulation one(pore({"time.end=200 us"}), nullptr, 1);
  const RunData plain = one.run();
  EXPECT_FALSE(plain.record.necks || !plain.passages.neck.empty());
}

Scene laboratory(const char* stl, Overrides overrides = {}) {
  const auto folder = source_folder() / "tests" / "reference" / "cases";
  overrides.insert(overrides.begin(), fmt::format("geometry.stl={}", (folder / stl).string()));
  return read_scene(folder / "lab.toml", overrides);
}

TEST(StlScene, SeamsThatDifferInTheLastDigitAreClosed) {
  for (const char* stl : {"box_108_triangles_one_ulp_seams.stl", "stl/plain.stl"}) {
    const Model model = make_model(laboratory(stl), nullptr, {});
    EXPECT_EQ(model.walls_note, "") << stl;
    EXPECT_TRUE(open_rims(join_walls(model.walls, model.weld)).empty());
  }
  const auto tiny = (source_folder() / "tests" / "reference" / "cases" / "seams_tiny.stl").string();
  EXPECT_EQ(make_model(pore({"geometry.stl=" + tiny}), nullptr, {}).walls_note, "");
}

TEST(StlScene, SaysWhatIsLeftOut) {
  EXPECT_THAT(make_model(laboratory("degenerate.stl"), nullptr, {}).walls_note, testing::HasSubstr("without area"));
  EXPECT_THAT(make_model(laboratory("duplicate.stl"), nullptr, {}).walls_note,
              testing::HasSubstr("with the corners of another"));
  for (const char* stl : {"degenerate.stl", "duplicate.stl"})
    EXPECT_EQ(make_model(laboratory(stl), nullptr, {}).walls.size(), 12u) << stl;
  EXPECT_THAT(make_model(laboratory("open.stl"), nullptr, {}).walls_note, testing::HasSubstr("open along 1 rim"));
}

TEST(StlScene, AWrongUnitIsToldByTheExtent) {
  EXPECT_THAT(refusal([] { make_model(laboratory("mm.stl"), nullptr, {}); }),
              testing::AllOf(testing::HasSubstr("2e-07 x 2e-07 x 2e-07 m, counted in units of 1e-06 m"),
                             testing::HasSubstr("is geometry.stl_unit right?")));
  EXPECT_THAT(make_model(laboratory("stl/plain.stl", {"geometry.stl_unit=1 m"}), nullptr, {}).walls_note,
              testing::HasSubstr("200 x 200 x 200 m, counted in units of 1 m: is geometry.stl_unit right?"));
}

TEST(StlScene, APassagePlaneOutsideTheWallsIsRefused) {
  for (const char* plane : {"-1 um", "201 um"})
    EXPECT_THAT(refusal([&] {
                  make_model(laboratory("stl/plain.stl", {fmt::format("passages.plane={}", plane)}), nullptr, {});
                }),
                testing::HasSubstr("must be within the walls, from x = 0 to 0.0002 m"));
  EXPECT_EQ(make_model(laboratory("stl/plain.stl", {"passages.plane=50 um"}), nullptr, {}).domain.passage, 50e-6);
}

TEST(StlScene, SaysWhenWhatLeftWasNotCounted) {
  const ScratchFile one("x,y,z\n90e-6,0,50e-6\n", ".csv");
  Scene scene = pore({"inlet.enabled=false", "particles.initial=" + one.name(), "time.end=6 ms"});
  const auto notes_of = [&](double plane) {
    scene.passages.plane = plane;
    Simulation simulation(scene, nullptr, 1);
    std::string notes;
    simulation.on_note([&](const std::string& line) { notes += line + "\n"; });
    simulation.run();
    EXPECT_EQ(simulation.particles().size(), 0u);
    return notes;
  };
  EXPECT_THAT(notes_of(95e-6), testing::Not(testing::HasSubstr("none was counted")));
  // No scene is read with such a plane.
  EXPECT_THAT(notes_of(1e-3),
              testing::HasSubstr("warning: 1 particle left at the outlet, x = 0.0001 m, and none was counted"));
}

TEST(StlScene, RunsWithoutAFlowFile) {
  Simulation simulation(pore({"time.end=200 us"}), nullptr, 1);
  simulation.run();
  EXPECT_GT(simulation.particles().size(), 5u);
}

}  // namespace
}  // namespace clogflow::test
