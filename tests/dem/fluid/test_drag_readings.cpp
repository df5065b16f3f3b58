// Whose rate the flow keeps: the drag of one sphere in a pack of porosity 0.5, by hand; and the neck as a strip.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "coupling/geometry/channel_shape.hpp"
#include "dem/fluid/fluid.hpp"
#include "dem/stability/pack_estimates.hpp"
#include "tests/dem/channel_scene.hpp"

namespace clogflow::test {
namespace {

constexpr double d = 0.2, eta = 0.5, flow_speed = 3;
const double stokes = 3 * std::numbers::pi * eta * d;
constexpr double half_full = 20.515165;  // f(0.5)

/// Force on the first of two spheres that fill half of the only strip, as it moves with `speed` [N].
double force(DragVelocity reading, double speed, const char* law = "hoef") {
  Scene scene = laboratory_scene({.diameter = d}, 1e-6);
  scene.fluid.viscosity = eta, scene.fluid.density = 100;
  scene.drag.enabled = true;
  scene.drag.velocity = reading;
  scene.drag.law = law;
  const double sphere = std::numbers::pi / 6 * d * d * d;
  Fluid fluid(scene, FlowField(std::array<double, 3>{flow_speed, 0, 0}), PorosityStrips(-1, 1, {4 * sphere}));
  Particles p;
  for (const double x : {-0.5, 0.5}) p.add({.radius = d / 2, .x = x, .vx = speed});
  fluid.update_porosity(p);
  fluid.evaluate(p);
  return fluid.drag_force(0, {speed, 0, 0}).x;
}

TEST(DragReadings, OfABedAtRest) {
  // f 3 pi eta d V0 / 0.5, and half of it without the mean pressure gradient's share.
  const double at_rest = half_full * stokes * flow_speed / 0.5;
  EXPECT_NEAR(force(DragVelocity::interstitial, 0) / at_rest, 1, 1e-7);
  EXPECT_NEAR(force(DragVelocity::mixture, 0) / at_rest, 1, 1e-7);
  EXPECT_NEAR(force(DragVelocity::superficial, 0) / at_rest, 0.5, 1e-7);
}

TEST(DragReadings, OfABedThatMoves) {
  // A mixture feels nothing at V0; the others go on to V0 / eps.
  EXPECT_EQ(force(DragVelocity::mixture, flow_speed), 0);
  EXPECT_EQ(force(DragVelocity::interstitial, flow_speed / 0.5), 0);
  EXPECT_EQ(force(DragVelocity::superficial, flow_speed / 0.5), 0);
  // At 1 m/s: f stokes (3 - 1) / 0.5, f stokes (3 / 0.5 - 1), and half of that.
  EXPECT_NEAR(force(DragVelocity::mixture, 1) / (half_full * stokes), 4, 1e-6);
  EXPECT_NEAR(force(DragVelocity::interstitial, 1) / (half_full * stokes), 5, 1e-6);
  EXPECT_NEAR(force(DragVelocity::superficial, 1) / (half_full * stokes), 2.5, 1e-6);
}

/// Of the small one of two spheres of 0.16 and 0.24, that fill half of a strip, over f 3 pi eta d_i V0 / 0.5.
double unequal_share(DragVelocity reading, const char* law, double size) {
  Scene scene = laboratory_scene({.diameter = d}, 1e-6);
  scene.fluid.viscosity = eta, scene.fluid.density = 100;
  scene.drag.enabled = true;
  scene.drag.velocity = reading;
  scene.drag.law = law;
  scene.particles.species = {{0.16, 0.5, 0}, {0.24, 0.5, 0}};
  const double spheres = std::numbers::pi / 6 * (std::pow(0.16, 3) + std::pow(0.24, 3));
  Fluid fluid(scene, FlowField(std::array<double, 3>{flow_speed, 0, 0}), PorosityStrips(-1, 1, {2 * spheres}));
  Particles p;
  p.add({.radius = size / 2, .x = -0.5});
  p.add({.radius = 0.2 - size / 2, .x = 0.5});
  fluid.update_porosity(p);
  fluid.evaluate(p);
  return fluid.drag_force(0, {0, 0, 0}).x / (3 * std::numbers::pi * eta * size * flow_speed / 0.5);
}

TEST(DragReadings, OfUnequalSpheres) {
  // Sauter's mean of one 0.16 and one 0.24: (0.004096 + 0.013824) / (0.0256 + 0.0576) = 0.2153846; y = 0.7428571 and
  // 1.1142857. At eps = 0.5: 0.5 y + 0.5 y^2 + 0.032 y^3 = 0.6604649 and 1.2222323.
  for (const DragVelocity reading : {DragVelocity::interstitial, DragVelocity::mixture}) {
    EXPECT_NEAR(unequal_share(reading, "hoef", 0.16), half_full * 0.6604649, 1e-5);
    EXPECT_NEAR(unequal_share(reading, "hoef", 0.24), half_full * 1.2222323, 1e-5);
  }
  // Without the pressure gradient's share: half of y + 0.064 y^3 = 0.7690930.
  EXPECT_NEAR(unequal_share(DragVelocity::superficial, "hoef", 0.16), half_full * 0.5 * 0.7690930, 1e-5);
  // A lone sphere's law asks for no neighbours.
  EXPECT_NEAR(unequal_share(DragVelocity::interstitial, "stokes", 0.16), 1, 1e-12);
  // Re is that of the mean: 100 x 3 x 0.2153846 / 0.5 = 129.23077.
  EXPECT_NEAR(unequal_share(DragVelocity::interstitial, "beetstra", 0.16),
              find_drag_law("beetstra").factor({0.5, 129.2307692}) * 0.6604649, 1e-4);
}

TEST(DragReadings, AreTheSameSlipForALawThatKnowsIt) {
  // At rest the superficial slip is V0 by every reading: Re = 100 x 3 x 0.2 / 0.5 = 120.
  const double f = find_drag_law("beetstra").factor({0.5, 120});
  for (const DragVelocity reading : {DragVelocity::interstitial, DragVelocity::mixture})
    EXPECT_NEAR(force(reading, 0, "beetstra") / (f * stokes * flow_speed / 0.5), 1, 1e-12);
  // A mixture that moves with 1 m/s has Re = 100 x 2 x 0.2 / 0.5 = 80.
  EXPECT_NEAR(force(DragVelocity::mixture, 1, "beetstra") / stokes, find_drag_law("beetstra").factor({0.5, 80}) * 4,
              1e-9);
}

TEST(DragReadings, AMixtureBrakesByItsLargerCoefficient) {
  const auto limit = [](const char* reading) {
    return expected_limits(make_model(short_channel_scene({std::string("drag.velocity=") + reading}), nullptr, {}), {})
        .drag;
  };
  EXPECT_NEAR(limit("mixture") / limit("interstitial"), pack_porosity, 1e-12);
}

TEST(NeckStrip, HasThePorosityOfWhatIsInTheNeck) {
  const Scene scene = short_channel_scene({"particles.diameter=50 um", "porosity.neck=true"});
  const FlowGrid flow = synthetic_flow(scene);
  Fluid fluid = make_fluid(scene, &flow);
  Particles p;
  p.add({.radius = 25e-6, .x = 50e-6, .z = 50e-6});
  fluid.update_porosity(p);
  // pi/6 50^3 um3 in a cube of 100 um
  ASSERT_EQ(fluid.strips().porosity().size(), 4u);
  EXPECT_NEAR(fluid.strips().porosity().back(), 0.93455, 1e-5);
  EXPECT_EQ(fluid.strips().packing_fraction(), 0);
  EXPECT_THAT(fluid.strips().upstream_porosity(), testing::ElementsAre(1, 1, 1));
  fluid.evaluate(p);
  const double eps = 0.93455015, f = 10 * (1 - eps) / (eps * eps) + eps * eps * (1 + 1.5 * std::sqrt(1 - eps));
  const double u = fluid.field().at(50e-6, 0, 50e-6)[0];
  EXPECT_NEAR(fluid.drag_force(0, {0, 0, 0}).x / (f * 3 * std::numbers::pi * 1.8e-3 * 50e-6 * u / eps), 1, 1e-6);
}

TEST(NeckStrip, SharesSpheresWithTheStripBefore) {
  PorosityStrips strips(-2, 0, {10, 10});
  strips.add_neck(1, 5);
  Particles p;
  for (const double x : {0.0, 1.0}) p.add({.radius = 0.4, .x = x});
  strips.update(p);
  // Half of one sphere before the neck; its other half and half of the second in it.
  const double half = 2.0 / 3 * std::numbers::pi * 0.064;
  EXPECT_NEAR(strips.porosity()[1], 1 - half / 10, 1e-14);
  EXPECT_NEAR(strips.porosity()[2], 1 - 2 * half / 5, 1e-14);
  EXPECT_NEAR(strips.packing_fraction(), half / 20, 1e-14);
  const std::pair<double, int> places[] = {{-9, 0}, {-1.001, 0}, {-0.999, 1}, {-1e-9, 1}, {0, 2}, {0.5, 2}, {77, 2}};
  for (const auto& [x, strip] : places) EXPECT_EQ(strips.strip_at(x), strip) << x;
}

TEST(NeckStrip, ARunRecordsTheStripsBeforeIt) {
  const Scene scene = short_channel_scene({"porosity.neck=true", "inlet.start=empty", "time.end=50 us"});
  const FlowGrid flow = synthetic_flow(scene);
  const RunData run = Simulation(scene, &flow, 1).run();
  ASSERT_FALSE(run.series.porosity.empty());
  EXPECT_EQ(run.series.porosity[0].size(), 3u);
}

}  // namespace
}  // namespace clogflow::test
