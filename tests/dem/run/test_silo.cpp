// A silo: particles fall through the channel, nothing flows. What speeds and times are then counted in, when a grain
// passes, filling behind the gate, clogs and what clears them.
#include <cmath>
#include <numbers>
#include <string_view>

#include <gtest/gtest.h>

#include "dem/plan/plan.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

/// A slot of 20 mm in a flat bottom of 2 mm, 60 mm x 20 mm x 80 mm above it.
Scene silo(const Overrides& overrides = {}) {
  return parse_scene(R"(
gravity = ["9.81 m/s2", "0 m/s2", "0 m/s2"]
[geometry]
neck_width = "20 mm"
channel_width = "60 mm"
channel_length = "80 mm"
neck_length = "2 mm"
half_angle = "90 deg"
[particles]
diameter = "8 mm"
density = "2500 kg/m3"
[contact]
youngs_modulus = "10 MPa"
poisson_ratio = 0.2
restitution = 0.6
friction.sliding = 0.5
[time]
end = "3 s"
step_fraction = 0.04
)",
                     "silo", overrides);
}

TEST(Silo, CountsSpeedsInThatOfAFallThroughHalfTheOrifice) {
  const Scene s = silo();
  EXPECT_DOUBLE_EQ(s.speed_scale(), std::sqrt(9.81 * 0.02));
  EXPECT_DOUBLE_EQ(s.stokes_time(), 0.008 / std::sqrt(9.81 * 0.02));
  EXPECT_EQ(s.flow_speed(), 0);
  // Against the axis, across it, or in a flow, nothing falls through the channel.
  EXPECT_EQ(silo({R"(gravity=["-9.81 m/s2", "0 m/s2", "0 m/s2"])"}).speed_scale(), 0);
  EXPECT_EQ(silo({R"(gravity=["0 m/s2", "0 m/s2", "9.81 m/s2"])"}).speed_scale(), 0);
  EXPECT_DOUBLE_EQ(silo({"flow.source=uniform", "flow.velocity=5 mm/s"}).speed_scale(), 5e-3);
  // Buoyancy and a heavier mass slow the fall: a quarter of the weight, of four times the mass.
  EXPECT_DOUBLE_EQ(silo({"fluid.density=1875 kg/m3", "time.mass_scale=4"}).speed_scale(), s.speed_scale() / 4);
  EXPECT_EQ(silo({"fluid.density=2500 kg/m3"}).speed_scale(), 0);
}

TEST(Silo, LetsAGrainPassAfterTheTimeOfItsFall) {
  Scene s = silo({"time.end=0.2 s"});
  Laboratory lab(s, {{.radius = 0.004, .x = -0.05, .z = 0.01}});
  const RunData run = lab->run();
  ASSERT_EQ(run.passages.time.size(), 1u);
  // Within a step the way is taken for straight: g dt^2 / 8 of it at most.
  const double dt = lab->model().dt, speed = std::sqrt(2 * 9.81 * 0.051);
  EXPECT_NEAR(run.passages.time[0], std::sqrt(2 * 0.051 / 9.81), 9.81 * dt * dt / speed);
  EXPECT_EQ(lab->particles().size(), 0u);
}

TEST(Silo, IsPlanned) {
  const Scene s = silo({"inlet.start=filled", "unclog.protocol=poke"});
  const Plan plan = make_plan(s);
  const auto value = [&](std::string_view term) {
    for (const PlannedTerm& t : plan.terms)
      if (t.term == term) return t.value;
    return 0.0;
  };
  EXPECT_DOUBLE_EQ(value("gravity"), s.speed_scale());
  // Hertz: twenty weights press on a contact of E* = 10 MPa / (2 (1 - 0.04)) and R* = 2 mm.
  const double load = 20 * 2500 * std::numbers::pi / 6 * 0.008 * 0.008 * 0.008 * 9.81;
  const double overlap = std::pow(3 * load / (4 * 1e7 / 1.92 * std::sqrt(0.002)), 2.0 / 3);
  EXPECT_NEAR(value("particle stiffness"), 0.008 / overlap, 1e-9 * 0.008 / overlap);
  EXPECT_GT(plan.filling_steps, 0);
  EXPECT_TRUE(std::isfinite(plan.filling_steps));
}

TEST(Silo, FillsBehindItsGateClogsAndGoesOn) {
  const Scene s = silo({"inlet.start=filled", "unclog.protocol=poke", "particles.diameter=9.5 mm"});
  Simulation simulation(s, nullptr, 1);
  const RunData run = simulation.run();
  EXPECT_GT(run.record.fill_time.value(), std::sqrt(2 * 0.04 / 9.81));
  EXPECT_TRUE(run.record.fill_at_rest.value_or(false));
  EXPECT_GT(run.passages.time.size(), 20u);
  EXPECT_GE(run.releases.off.size(), 2u);
  EXPECT_GT(run.passages.time.back(), run.releases.off.front());
  // The level is kept.
  EXPECT_GT(run.series.count.back(), 0.8 * static_cast<double>(run.series.count.front()));
}

TEST(Silo, StopsAtItsFirstClog) {
  const Scene s = silo({"inlet.start=filled", "unclog.protocol=stop", "particles.diameter=9.5 mm", "time.end=20 s"});
  const RunData run = Simulation(s, nullptr, 2).run();
  EXPECT_LT(run.end_time, 20);
  // Without a fluid a pack trembles for long: it may be waited for instead of proved, four times unclog.after.
  const double still = run.end_time - run.passages.time.back();
  EXPECT_GE(still, s.unclog.after / 10);
  EXPECT_LE(still, 4 * s.unclog.after + 2 * s.stokes_time());
}

TEST(Silo, MayRestartWithoutFriction) {
  const Scene s = silo({"inlet.start=flowing", "inlet.strain=1", "unclog.protocol=restart", "unclog.strain=1",
                        "particles.diameter=9.5 mm", "time.end=2 s"});
  const RunData run = Simulation(s, nullptr, 1).run();
  EXPECT_TRUE(run.record.start_flowed.value_or(false));
  EXPECT_GT(run.passages.time.size(), 20u);
}

}  // namespace
}  // namespace clogflow::test
