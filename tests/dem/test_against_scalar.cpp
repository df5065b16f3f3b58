// The fast solver against the slow one: cells, lists, kernels and remembered springs, all at once, for
// every instruction set that this processor has.
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/dem/laboratory.hpp"
#include "tests/dem/scalar_reference.hpp"

namespace clog::test {
namespace {

constexpr double d = 33e-6;

Scene busy_scene() {
  Scene s = laboratory_scene({3e6, 0.35, 1062, d}, 2e-7);
  s.contact.restitution = 0.6;
  s.fluid.viscosity = 1.8e-3;
  s.lubrication.enabled = true;
  s.lubrication.cutoff = d / 2;
  set_friction(s, {.sliding = 0.5, .rolling = 0.3, .torsion = 0.2});
  s.contact.wall_friction.sliding = 0.4;
  return s;
}

/// Everything moves, so that every term acts: about 1 mm/s, rad/s to match.
void stir(std::vector<Particle>& particles, std::mt19937& random) {
  std::normal_distribution<double> speed(0, 1e-3), spin(0, 60);
  for (Particle& p : particles) {
    p.vx = speed(random), p.vy = speed(random), p.vz = speed(random);
    p.wx = spin(random), p.wy = spin(random), p.wz = spin(random);
  }
}

std::vector<Particle> packed_box() {
  std::ifstream file(CLOG_TEST_DATA "/packed_box_1000.txt");
  std::vector<Particle> particles;
  for (std::string line; std::getline(file, line);) {
    if (line[0] == '#') continue;
    Particle p{.radius = d / 2};
    std::istringstream(line) >> p.x >> p.y >> p.z;
    particles.push_back(p);
  }
  std::mt19937 random(11);
  stir(particles, random);
  return particles;
}

/// Spheres of sizes 1 to 4, many of them overlapping a little; cells sized by the largest.
std::vector<Particle> polydisperse_cloud() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Particle> cloud;
  while (cloud.size() < 400) {
    Particle p{.radius = d / 2 * (0.25 + 0.75 * share(random))};
    const double size = 8 * d;
    p.x = size * share(random), p.y = size * share(random), p.z = size * share(random);
    const bool deep = std::ranges::any_of(cloud, [&](const Particle& q) {
      return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) <
             p.radius + q.radius - 0.02 * std::min(p.radius, q.radius);
    });
    if (!deep) cloud.push_back(p);
  }
  stir(cloud, random);
  return cloud;
}

/// Largest difference of any load, over the largest load.
void expect_same_loads(Laboratory& lab, const Loads& expected, int step, double rounding) {
  double largest_force = 0, largest_torque = 0;
  for (const auto& f : expected.force) largest_force = std::max(largest_force, std::sqrt(dot(f, f)));
  for (const auto& t : expected.torque) largest_torque = std::max(largest_torque, std::sqrt(dot(t, t)));
  const Particles& p = lab->particles();
  ASSERT_EQ(p.size(), expected.force.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto &f = expected.force[p.id[i]], &t = expected.torque[p.id[i]];
    ASSERT_NEAR(p.fx[i], f.x, rounding * largest_force) << "step " << step << " particle " << p.id[i];
    ASSERT_NEAR(p.fy[i], f.y, rounding * largest_force);
    ASSERT_NEAR(p.fz[i], f.z, rounding * largest_force);
    ASSERT_NEAR(p.tx[i], t.x, rounding * largest_torque) << "step " << step << " particle " << p.id[i];
    ASSERT_NEAR(p.ty[i], t.y, rounding * largest_torque);
    ASSERT_NEAR(p.tz[i], t.z, rounding * largest_torque);
  }
  EXPECT_EQ(lab->pair_tally().contacts, expected.contacts);
  EXPECT_EQ(lab->wall_tally().contacts, expected.wall_contacts);
}

/// CLOG_ISA for the lifetime of one test.
class ForcedIsa {
public:
  explicit ForcedIsa(const char* name) { setenv("CLOG_ISA", name, 1); }
  ~ForcedIsa() { unsetenv("CLOG_ISA"); }
};

bool has(const char* isa) {
  try {
    select_kernels(isa);
    return true;
  } catch (const Error&) {
    return false;
  }
}

class AgainstScalar : public testing::TestWithParam<const char*> {};

/// Overlaps of a pack are 1e-2 to 1e-4 of the coordinates, so their last digits are 1e-12 of the force.
void compare(const Scene& scene, const std::vector<Particle>& particles, int steps,
             double rounding = 1e-11) {
  Laboratory lab(scene, particles);
  ScalarReference reference;
  for (int k = 0; k < steps; ++k) {
    lab->compute_forces();
    // No spring grows before anything has moved.
    expect_same_loads(lab, reference.loads(*lab, k == 0 ? 0 : scene.time.step), k, rounding);
    if (testing::Test::HasFatalFailure()) return;
    lab->advance();
  }
}

TEST_P(AgainstScalar, PackedBoxForceByForce) {
  if (!has(GetParam())) GTEST_SKIP() << "this processor lacks " << GetParam();
  const ForcedIsa isa(GetParam());
  Scene s = busy_scene();
  s.box.present = true;
  s.box.max = {1.6e-3, 4e-4, 1e-4};
  compare(s, packed_box(), 15);
}

TEST_P(AgainstScalar, PolydisperseCloudAcrossManyListRebuilds) {
  if (!has(GetParam())) GTEST_SKIP() << "this processor lacks " << GetParam();
  const ForcedIsa isa(GetParam());
  std::vector<Particle> cloud = polydisperse_cloud();
  // Fast enough for a rebuild every few steps: the skin is 0.1 d, a step 0.01 d.
  for (Particle& p : cloud) p.vx *= 200, p.vy *= 200, p.vz *= 200;
  compare(busy_scene(), cloud, 60);
}

TEST_P(AgainstScalar, DimersThatChangePlacesInTheOrderOfTheLists) {
  // Two spheres in one cell stand in order of id, in two cells in order of cells: a dimer that flies
  // along x, larger id ahead or behind, is listed now this way, now that, with all its springs wound.
  if (!has(GetParam())) GTEST_SKIP() << "this processor lacks " << GetParam();
  const ForcedIsa isa(GetParam());
  Scene s = busy_scene();
  s.lubrication.enabled = false;
  s.contact.tangential_damping = 0.1;  // springs, not dashpots, must carry the torques
  s.contact.youngs_modulus = s.contact.wall_youngs_modulus = 3e4;
  const double ahead = 0.06 * d / s.time.step;  // beyond half a skin in every step
  const Particle left{.radius = d / 2, .vx = ahead, .wx = 5, .wy = 9, .wz = -7};
  Particle right = left;
  right.x = 0.995 * d, right.y = 0.05 * d, right.vy = 1e-4, right.wy = -8;
  std::vector<Particle> dimers{left, right, right, left};
  dimers[2].y += 5 * d, dimers[3].y += 5 * d;
  // Far ahead, so that the cells stay where they are.
  dimers.push_back({.radius = d / 2, .x = -3 * d});
  dimers.push_back({.radius = d / 2, .x = 40 * d, .y = 8 * d});
  // Contacts are followed until they part, where an overlap is little more than its rounding.
  compare(s, dimers, 120, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(On, AgainstScalar, testing::Values("x86_64", "avx2", "avx512"),
                         [](const auto& info) { return std::string(info.param); });

TEST(SelectKernels, RefusesAnUnknownInstructionSet) {
  const ForcedIsa isa("mmx");
  EXPECT_THROW(select_kernels(), Error);
  EXPECT_STREQ(select_kernels("x86_64").name, "x86_64");
}

}  // namespace
}  // namespace clog::test
