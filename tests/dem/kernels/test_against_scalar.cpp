// The fast solver against the slow one: cells, lists, kernels and remembered springs, all at once, for
// every instruction set that this processor has.
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/dem/kernels/clouds.hpp"
#include "tests/dem/kernels/scalar_reference.hpp"

namespace clogflow::test {
namespace {

constexpr double d = crowd_diameter;
constexpr double step = 2e-7;  // [s]

/// Largest difference of any load, over the largest load.
void expect_same_loads(Laboratory& lab, const Loads& expected, int number, double rounding) {
  double largest_force = 0, largest_torque = 0;
  for (const auto& f : expected.force) largest_force = std::max(largest_force, std::sqrt(dot(f, f)));
  for (const auto& t : expected.torque) largest_torque = std::max(largest_torque, std::sqrt(dot(t, t)));
  const Particles& p = lab->particles();
  ASSERT_EQ(p.size(), expected.force.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto &f = expected.force[p.id[i]], &t = expected.torque[p.id[i]];
    ASSERT_NEAR(p[i].fx, f.x, rounding * largest_force) << "step " << number << " particle " << p.id[i];
    ASSERT_NEAR(p[i].fy, f.y, rounding * largest_force);
    ASSERT_NEAR(p[i].fz, f.z, rounding * largest_force);
    ASSERT_NEAR(p[i].tx, t.x, rounding * largest_torque) << "step " << number << " particle " << p.id[i];
    ASSERT_NEAR(p[i].ty, t.y, rounding * largest_torque);
    ASSERT_NEAR(p[i].tz, t.z, rounding * largest_torque);
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
void compare(const Scene& scene, const std::vector<Particle>& particles, int steps, double rounding = 1e-11) {
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
  Scene s = crowd_scene(step);
  s.box.present = true;
  s.box.max = packed_box_size;
  compare(s, packed_box(1e-3), 15);
}

TEST_P(AgainstScalar, PolydisperseCloudAcrossManyListRebuilds) {
  if (!has(GetParam())) GTEST_SKIP() << "this processor lacks " << GetParam();
  const ForcedIsa isa(GetParam());
  // Fast enough for a rebuild every few steps: the skin is 0.1 d, a step 0.01 d.
  compare(crowd_scene(step), polydisperse_cloud(0.2), 60);
}

/// Every third of another species, one of them without friction, one that only walls rub.
void set_species(Scene& scene, std::vector<Particle>& particles) {
  scene.lubrication.enabled = false;
  scene.particles.species = {{d, 0.3, 0}, {d, 0.3, 0, {0.1, 0.4, 0}, {0.7, 0.2, 0.1}}, {d, 0.4, 0, {}, {0, 0.6, 0}}};
  for (std::size_t k = 0; k < particles.size(); ++k) particles[k].species = static_cast<int>(k % 3);
}

TEST_P(AgainstScalar, FrictionOfSpecies) {
  if (!has(GetParam())) GTEST_SKIP() << "this processor lacks " << GetParam();
  const ForcedIsa isa(GetParam());
  Scene loose = crowd_scene(step), packed = loose;
  auto cloud = polydisperse_cloud(0.2), pack = packed_box(1e-3);
  set_species(loose, cloud);
  compare(loose, cloud, 60);
  packed.box.present = true;
  packed.box.max = packed_box_size;
  set_species(packed, pack);
  compare(packed, pack, 15);
}

TEST_P(AgainstScalar, DimersThatChangePlacesInTheOrderOfTheLists) {
  // Two spheres in one cell stand in order of id, in two cells in order of cells: a dimer that flies
  // along x, larger id ahead or behind, is listed now this way, now that, with all its springs wound.
  if (!has(GetParam())) GTEST_SKIP() << "this processor lacks " << GetParam();
  const ForcedIsa isa(GetParam());
  Scene s = crowd_scene(step);
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

TEST(SelectKernels, TakesTheWidestVectorsUnlessAsked) {
  const ForcedIsa none("");
  EXPECT_STREQ(select_kernels().name, has("avx512") ? "avx512" : has("avx2") ? "avx2" : "x86_64");
  if (has("avx2")) {
    EXPECT_STREQ(select_kernels("avx2").name, "avx2");
  }
}

TEST(SelectKernels, RefusesAnUnknownInstructionSet) {
  const ForcedIsa isa("mmx");
  EXPECT_THROW(select_kernels(), Error);
  EXPECT_STREQ(select_kernels("x86_64").name, "x86_64");
}

}  // namespace
}  // namespace clogflow::test
