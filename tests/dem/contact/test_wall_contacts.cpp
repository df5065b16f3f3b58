// Forces and springs of a sphere that moves over edges and corners: nothing jumps, nothing is lost.
#include <gtest/gtest.h>

#include "dem/contact/wall_contacts.hpp"
#include "dem/physics/contact_laws.hpp"
#include "tests/dem/contact/wall_shapes.hpp"
#include "tests/dem/laboratory.hpp"

namespace clogflow::test {
namespace {

constexpr double r = 0.1, skin = 0.02;
constexpr Material glass{1.5e6, 0.25};

/// A sphere against walls, placed by hand, lists made anew at every place or kept.
class Probe {
public:
  explicit Probe(const Walls& walls, const Friction& friction = {}) : walls_(walls, r, {skin, 0}) {
    laws_.contact = make_contact_law("hertz", "luding", {.own = glass, .other = glass},
                                     {friction.sliding, friction.rolling, friction.torsion});
    laws_.terms = {true, true, true};
    laws_.dt = 1;
    p_.add({.radius = r, .mass = 1, .inertia = 1});
  }

  void rebuild() {
    walls_.rebuild(p_, {0}, {skin / 2});
    walls_.sort(p_, skin, laws_.lubrication);
  }

  Vec3 force(const Vec3& centre, const Vec3& velocity = Vec3::Zero()) {
    p_[0].x = centre.x, p_[0].y = centre.y, p_[0].z = centre.z;
    p_[0].vx = velocity.x, p_[0].vy = velocity.y, p_[0].vz = velocity.z;
    const Kernels& kernels = select_kernels();
    p_.clear_loads();
    contacts_ = walls_.collide_planes(p_, kernels, laws_).contacts;
    contacts_ += walls_.collide_corners(p_, laws_).contacts;
    return {p_[0].fx, p_[0].fy, p_[0].fz};
  }

  Vec3 force_with_new_lists(const Vec3& centre) {
    p_[0].x = centre.x, p_[0].y = centre.y, p_[0].z = centre.z;
    rebuild();
    return force(centre);
  }

  std::vector<WallContacts::Touch> touches() { return walls_.touches(p_); }
  std::int64_t contacts() const { return contacts_; }

  double hertz(double overlap) const {
    return hertz_stiffness(effective_modulus(glass, glass), std::sqrt(r * overlap)) * overlap;
  }

private:
  Particles p_;
  WallContacts walls_;
  WallLaws laws_;
  std::int64_t contacts_ = 0;
};

/// No jump beyond this share of the force: rounding of an overlap of 1e-2 r.
constexpr double no_jump = 1e-9;
constexpr double overlap = 1e-2 * r;

/// Where the centre is after rolling the way s at constant depth over an edge of the given angle, and
/// the direction of the force there.
struct Pose {
  Vec3 centre, normal;
};

Pose over_edge(double s, double angle) {
  const double height = r - overlap, arc = height * angle;
  if (s < 0) return {{s, 0.013, height}, {0, 0, 1}};
  const double turned = std::min(s / height, angle);
  const Vec3 normal(std::sin(turned), 0, std::cos(turned));
  const double beyond = std::max(s - arc, 0.0);
  return {height * normal + beyond * Vec3(std::cos(angle), 0, -std::sin(angle)) + Vec3(0, 0.013, 0), normal};
}

TEST(WallForce, IsConstantWhenASphereRollsOverAConvexEdge) {
  // 60 degrees: the neck's edge. Lists are made anew at each place: both lists take their turns.
  for (const double angle : {M_PI / 3, M_PI / 2, 0.05}) {
    Probe probe(bent_plate(-angle, 1));
    const double expected = probe.hertz(overlap);
    for (double s = -0.08; s < 0.2; s += 1.3e-4) {
      const Pose pose = over_edge(s, angle);
      const Vec3 force = probe.force_with_new_lists(pose.centre);
      ASSERT_LT((force - expected * pose.normal).norm(), no_jump * expected) << s;
    }
  }
}

TEST(WallForce, IsConstantOverCoplanarEdges) {
  Probe probe(cut_in_four(cut_in_four(floor_plate(1))));
  const double expected = probe.hertz(overlap);
  // Along a diagonal, along an edge, over corners where six triangles meet, and at a slant.
  for (const Vec3& way : {Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(1, 0.37, 0)})
    for (double s = -0.6; s < 0.6; s += 1.7e-3) {
      const Vec3 force = probe.force_with_new_lists(s * way + Vec3(0, 0, r - overlap));
      ASSERT_LT((force - Vec3(0, 0, expected)).norm(), no_jump * expected) << s;
    }
}

/// The floor, half of it coarse, half of it fine: the fine half's corners hang on the coarse one's edge.
Walls floor_with_hanging_corners() {
  Walls walls, fine;
  add_quad(walls, {-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0});
  add_quad(fine, {0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, 0});
  for (const Triangle& t : cut_in_four(cut_in_four(fine))) walls.push_back(t);
  return walls;
}

TEST(WallForce, IsConstantOverHangingCorners) {
  Probe probe(floor_with_hanging_corners());
  const double expected = probe.hertz(overlap);
  // Along the line on which they hang, across it, and at a slant.
  for (const Vec3& way : {Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(1, 0.37, 0)})
    for (double s = -0.6; s < 0.6; s += 1.7e-3) {
      const Vec3 force = probe.force_with_new_lists(s * way + Vec3(0, 0, r - overlap));
      ASSERT_EQ(probe.contacts(), 1) << s;
      ASSERT_LT((force - Vec3(0, 0, expected)).norm(), no_jump * expected) << s;
    }
}

TEST(WallForce, IsConstantOverAConvexEdgeWithHangingCorners) {
  const double angle = M_PI / 3;
  Walls walls = bent_plate(-angle, 1);
  const Walls fine = cut_in_four(cut_in_four({walls.begin() + 2, walls.end()}));
  walls.resize(2);
  walls.insert(walls.end(), fine.begin(), fine.end());
  Probe probe(walls);
  const double expected = probe.hertz(overlap);
  for (double s = -0.08; s < 0.2; s += 1.3e-4) {
    const Pose pose = over_edge(s, angle);
    ASSERT_LT((probe.force_with_new_lists(pose.centre) - expected * pose.normal).norm(), no_jump * expected) << s;
  }
}

TEST(WallForce, IsConstantAlongAReentrantCorner) {
  // In the corner of floor and slope, deep in both: two contacts, on through all triangle borders.
  const double angle = M_PI / 3, height = r - overlap;
  const Walls walls = cut_in_four(cut_in_four(bent_plate(angle, 1)));
  // Equal distance to both planes: on the bisector.
  const double x = -height * std::tan(angle / 2);
  Probe probe(walls);
  const Vec3 expected = probe.hertz(overlap) * (Vec3(0, 0, 1) + Vec3(-std::sin(angle), 0, std::cos(angle)));
  for (double y = -0.6; y < 0.6; y += 1.7e-3) {
    const Vec3 force = probe.force_with_new_lists({x, y, height});
    ASSERT_EQ(probe.contacts(), 2) << y;
    ASSERT_LT((force - expected).norm(), no_jump * expected.norm()) << y;
  }
}

TEST(WallForce, GrowsFromNothingIntoAReentrantCorner) {
  const double angle = M_PI / 3, height = r - overlap;
  Probe probe(bent_plate(angle, 1));
  const Vec3 slope(-std::sin(angle), 0, std::cos(angle));
  for (double x = -0.2; x < -0.05; x += 1e-4) {
    const double into = r - dot(Vec3(x, 0, height), slope);
    const Vec3 expected = Vec3(0, 0, probe.hertz(overlap)) + (into > 0 ? probe.hertz(into) : 0) * slope;
    ASSERT_LT((probe.force_with_new_lists({x, 0.1, height}) - expected).norm(), no_jump * expected.norm());
  }
}

TEST(WallForce, AtTheEndOfAnEdgeHasBothContacts) {
  // The neck's edge standing on the floor: the sphere leans on the edge and lies on the floor.
  Walls walls = floor_plate(1);
  const Vec3 up(0, 0, 1);
  const auto upright = [&](const Vec3& a, const Vec3& b) { add_quad(walls, a, b, b + up, a + up); };
  upright({0, 0, 0}, {0, 1, 0});  // faces -x
  upright({1, 0, 0}, {0, 0, 0});  // faces -y
  Probe probe(walls);
  const double height = r - overlap;
  for (double turn = 0.01; turn < M_PI / 2; turn += 0.01) {
    const Vec3 away(-std::cos(turn), -std::sin(turn), 0);
    const Vec3 expected = probe.hertz(overlap) * (away + up);
    const Vec3 force = probe.force_with_new_lists(height * (away + up));
    ASSERT_LT((force - expected).norm(), no_jump * expected.norm()) << turn;
    ASSERT_EQ(probe.contacts(), 2);
  }
}

/// The longest jump of the force, over the force, on a way in so many steps, lists made anew at each place.
double force_jump(const Walls& walls, const std::function<Vec3(double)>& way, int steps) {
  Probe probe(walls);
  double worst = 0, largest = 0;
  Vec3 last = Vec3::Zero();
  for (int k = 0; k <= steps; ++k) {
    const Vec3 force = probe.force_with_new_lists(way(static_cast<double>(k) / steps));
    if (k > 0) worst = std::max(worst, (force - last).norm());
    largest = std::max(largest, force.norm());
    last = force;
  }
  return worst / largest;
}

/// A jump does not become smaller with the step; a steep rise does.
void expect_continuous(const Walls& walls, const std::function<Vec3(double)>& way) {
  const double coarse = force_jump(walls, way, 4000), fine = force_jump(walls, way, 40000);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, 0.3 * coarse);
}

TEST(WallForce, DoesNotJumpFromFacetToFacet) {
  for (const int facets : {12, 13, 16, 64})
    for (const double deep : {1e-2 * r, 1e-1 * r}) {
      const double pore = 1.09 * r;
      expect_continuous(round_pore(pore, facets, 3 * r), [&](double s) -> Vec3 {
        return around(0.2 + 1.3 * s, pore - r + deep * (1 + 0.3 * std::sin(20 * s)), 0.1 * r);
      });
    }
}

TEST(WallForce, DoesNotJumpWhereAThirdFacetComesBetweenTwo) {
  // Two sides of a gutter, 50 degrees apart, hold the sphere; then it meets the bottom between them.
  const double side = 0.4 * std::tan(25 * M_PI / 180);
  const Walls walls = gutter({{-0.415, 0, side}, {-0.015, 0, 0}, {0.015, 0, 0}, {0.415, 0, side}}, 1);
  expect_continuous(walls, [](double s) { return Vec3(0.002 * s, 0.1, 0.105 - 0.007 * s); });
  Probe probe(walls);
  probe.force_with_new_lists({0, 0.1, 0.1001});
  EXPECT_EQ(probe.contacts(), 2);
}

TEST(WallForce, OfACurvedWallIsThatOfItsNearestFacet) {
  const double pore = 1.05 * r;
  for (const int facets : {14, 64, 1024}) {
    Probe probe(round_pore(pore, facets, 3 * r));
    const Vec3 force = probe.force_with_new_lists({pore - r + overlap, 0, 0});
    EXPECT_EQ(probe.contacts(), 1);
    EXPECT_LT((force + Vec3(probe.hertz(overlap), 0, 0)).norm(), 0.005 * probe.hertz(overlap)) << facets;
  }
}

/// Slides a sphere along a way in small steps, lists made anew now and then, and returns the longest
/// change of its spring beyond what the steps explain.
double spring_jump(const Walls& walls, const std::function<Vec3(double)>& way, double from, double to) {
  Probe probe(walls, {.sliding = 1e5});  // never slips: the spring is the way itself
  const double step = 1e-4;
  double worst = 0, last = 0;
  probe.force(way(from));
  probe.rebuild();
  int k = 0;
  for (double s = from; s < to; s += step, ++k) {
    const Vec3 centre = way(s), velocity = way(s + step) - centre;
    probe.force(centre, velocity);
    const auto touches = probe.touches();
    if (k % 37 == 0) probe.rebuild();
    EXPECT_EQ(touches.size(), 1u) << s;
    if (touches.size() != 1) return 1;
    const auto& spring = touches[0].springs.sliding;
    const double length = std::sqrt(dot(spring, spring));
    if (s > from) worst = std::max(worst, std::abs(length - last - step));
    last = length;
  }
  return worst;
}

TEST(WallSprings, SurviveRebuildsAndCoplanarEdges) {
  const Walls walls = cut_in_four(cut_in_four(floor_plate(1)));
  const auto way = [](double s) { return Vec3(s, 0.37 * s, r - overlap); };
  // Each step is as long as the way itself, sqrt(1 + 0.37^2).
  EXPECT_LT(spring_jump(
                walls, [&](double s) { return way(s / std::hypot(1, 0.37)); }, -0.3, 0.3),
            1e-12);
}

TEST(WallSprings, SurviveAConvexEdge) {
  // The centre's chord is shorter than the arc by 1e-7, and the spring turns with the normal.
  EXPECT_LT(spring_jump(
                bent_plate(-M_PI / 3, 1), [](double s) { return over_edge(s, M_PI / 3).centre; }, -0.1, 0.2),
            2e-6);
}

TEST(WallSprings, SurviveFromFacetToFacet) {
  for (const int facets : {14, 64, 1024}) {
    const double pore = 1.09 * r, height = pore - r + overlap;
    // Each step goes on by its length; where the facets turn, the spring turns with the normal.
    EXPECT_LT(spring_jump(
                  round_pore(pore, facets, 3 * r), [&](double s) { return around(s / height, height, 0.1 * r); }, 0,
                  0.5 * height),
              2e-5)
        << facets;
  }
}

TEST(WallSprings, OfAContactLostAreForgotten) {
  Probe probe(floor_plate(1), {.sliding = 10});
  probe.force({0, 0, r - overlap});
  probe.rebuild();
  probe.force({0, 0, r - overlap}, {1e-4, 0, 0});
  ASSERT_GT(std::abs(probe.touches()[0].springs.sliding.x), 0);
  probe.force({0, 0, r + overlap});
  probe.force({0, 0, r - overlap});
  EXPECT_EQ(probe.touches()[0].springs.sliding.x, 0);
}

}  // namespace
}  // namespace clogflow::test
