// Spheres in hollows made of facets, and walls that lie in each other: one contact for what is one
// touch.
#include <numbers>

#include <gtest/gtest.h>

#include "coupling/geometry/stl.hpp"
#include "tests/dem/contact/wall_shapes.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

using std::numbers::pi;

constexpr double r = 16.5e-6;

Scene scene_of(const std::string& stl, double step) {
  Scene scene = laboratory_scene({3e6, 0.35, 1062, 2 * r}, step);
  scene.geometry.present = true;
  scene.geometry.stl = stl;
  scene.contact.restitution = 0.7;
  return scene;
}

/// A sphere that is let fly at walls, without friction.
struct Rebound {
  double restitution;  ///< along the impulse [-]
  Vec3 impulse;        ///< its direction
};

Rebound drop(Laboratory& lab) {
  const Vec3 before = lab.velocity(0);
  bool met = false;
  for (int k = 0; k < 200000; ++k) {
    lab.step();
    const bool touches = lab->wall_tally().contacts > 0;
    EXPECT_LE(lab->wall_tally().contacts, 1);
    if (met && !touches) break;
    met = met || touches;
  }
  EXPECT_TRUE(met);
  const Vec3 after = lab.velocity(0), impulse = (after - before).normalized();
  return {-dot(after, impulse) / dot(before, impulse), impulse};
}

Rebound drop(const Walls& walls, const Vec3& from, const Vec3& velocity) {
  const ScratchFile stl(stl_text({{"walls", walls}}, 1), ".stl");
  Laboratory lab(
      scene_of(stl.name(), 5e-9),
      {{.radius = r, .x = from.x, .y = from.y, .z = from.z, .vx = velocity.x, .vy = velocity.y, .vz = velocity.z}});
  return drop(lab);
}

struct Pore {
  double radius;  ///< over that of the sphere [-]
  double speed;   ///< [m/s]
};

class RoundPore : public testing::TestWithParam<Pore> {};

TEST_P(RoundPore, GivesTheRestitutionOfAPlaneWhateverItsFacets) {
  const Pore pore = GetParam();
  const double room = (pore.radius - 1) * r;
  for (const int facets : {14, 16, 64, 256, 1024})
    // On the middle of a facet, on the edge between two, and somewhere between.
    for (const double turn : {0.0, 1.0, 0.37}) {
      const Vec3 way = around(turn * pi / facets, 1, 0);
      const Rebound rebound = drop(round_pore(pore.radius * r, facets, 60e-6),
                                   (room - 0.002 * r) * way + Vec3(0, 3e-6, 0), pore.speed * way);
      EXPECT_NEAR(rebound.restitution, 0.7, 0.007) << facets << " facets, turned by " << turn;
      // Straight back, but for the slant of the facets that are met.
      EXPECT_LE((rebound.impulse + way).norm(), (turn == 0.37 ? 1 : 0) * pi / facets + 1e-5);
    }
}

INSTANTIATE_TEST_SUITE_P(Over, RoundPore,
                         testing::Values(Pore{1.05, 5e-3}, Pore{18 / 16.5, 5e-3}, Pore{18 / 16.5, 0.1}, Pore{3, 5e-3}));

TEST(RoundPore, KeepsTheEnergyOfAnElasticBounce) {
  // Slanting, at and beside the edge between two facets.
  for (const int facets : {16, 64, 256}) {
    const ScratchFile stl(stl_text({{"walls", round_pore(18e-6, facets, 60e-6)}}, 1), ".stl");
    const Vec3 way = around(pi / facets, 1, 0), side = around(pi / facets + pi / 2, 1, 0);
    for (const double beside : {0.0, 0.01e-6, 0.05e-6, 0.1e-6}) {
      Scene scene = scene_of(stl.name(), 1e-8);
      scene.contact.restitution = 1;
      const Vec3 from = 1.45e-6 * way + beside * side, v = 6e-3 * way + 2e-3 * side;
      Laboratory lab(scene, {{.radius = r, .x = from.x, .z = from.z, .vx = v.x, .vz = v.z}});
      drop(lab);
      EXPECT_NEAR(lab.velocity(0).squaredNorm() / v.squaredNorm(), 1, 0.02) << facets << " facets, beside " << beside;
    }
  }
}

/// A floor in a box, and in its plane a plate turned by 0.5 rad.
class TurnedPlate : public testing::TestWithParam<Vec3> {};

TEST_P(TurnedPlate, InThePlaneOfAnotherWallCountsOnce) {
  Walls plate;
  add_quad(plate, around(0.5, 40e-6, 0), around(0.5 + pi / 2, 40e-6, 0), around(0.5 + pi, 40e-6, 0),
           around(0.5 - pi / 2, 40e-6, 0));
  for (Triangle& t : plate)
    for (Vec3& corner : t.corner) corner = {corner.x, corner.z, 0};
  const ScratchFile stl(stl_text({{"plate", plate}}, 1), ".stl");
  Scene scene = scene_of(stl.name(), 5e-9);
  set_floor(scene, 400e-6);
  const Vec3 at = GetParam();
  Laboratory lab(scene, {{.radius = r, .x = at.x, .y = at.y, .z = 1.001 * r, .vz = -5e-3}});
  const Rebound rebound = drop(lab);
  EXPECT_NEAR(rebound.restitution, 0.7, 0.002);
  EXPECT_LT((rebound.impulse - Vec3(0, 0, 1)).norm(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(At, TurnedPlate,
                         testing::Values(Vec3(0, 0, 0), Vec3(34e-6, 18e-6, 0), Vec3(38e-6, 18e-6, 0),
                                         Vec3(4e-6, 28e-6, 0)));

}  // namespace
}  // namespace clogflow::test
