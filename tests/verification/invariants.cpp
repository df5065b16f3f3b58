// Momentum, and independence of the frame in which a scene is written down.
#include "tests/dem/contact/wall_shapes.hpp"
#include "tests/dem/kernels/clouds.hpp"
#include "tests/verification/check.hpp"

namespace clogflow::verification {

using test::Laboratory;

namespace {

struct Momentum {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  double linear_scale = 0, angular_scale = 0;  ///< sums of magnitudes
};

/// x_n x v_(n-1/2): both are changed by the same forces at x_n, so leapfrog keeps the sum exactly.
Momentum momentum_of(const Particles& p) {
  Momentum sum;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 x(p[i].x, p[i].y, p[i].z), v(p[i].vx, p[i].vy, p[i].vz), w(p[i].wx, p[i].wy, p[i].wz);
    const Vec3 spin = p[i].inertia * w;
    sum.linear += p[i].mass * v;
    sum.angular += p[i].mass * cross(x, v) + spin;
    sum.linear_scale += p[i].mass * v.norm();
    sum.angular_scale += p[i].mass * cross(x, v).norm() + spin.norm();
  }
  return sum;
}

}  // namespace

Group momentum() {
  Group group{"Momentum of an isolated cloud",
              "400 spheres of many sizes, all contact terms and lubrication, 2000 steps with many list rebuilds; "
              "change over the sum of the magnitudes. Limit: rounding, 2000 steps.",
              {}};
  Laboratory lab(test::crowd_scene(1e-7), test::polydisperse_cloud(0.05));
  const Momentum before = momentum_of(lab->particles());
  for (int k = 0; k < 2000; ++k) lab.step();
  const Momentum after = momentum_of(lab->particles());
  group.checks.push_back({"linear", 0, (after.linear - before.linear).norm() / before.linear_scale, 1e-13, false});
  group.checks.push_back({"angular", 0, (after.angular - before.angular).norm() / before.angular_scale, 1e-12, false});
  return group;
}

namespace {

/// Rodrigues' formula.
Vec3 turned(const Vec3& v, double angle, const Vec3& axis) {
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1 - std::cos(angle)) * dot(axis, v) * axis;
}

Vec3 rotated(const Vec3& v) { return turned(turned(v, -1.9, {0, 1, 0}), 0.7, Vec3(1, 2, -1).normalized()); }

const Vec3 shift(3e-4, -2e-4, 1e-4);

Vec3 moved(const Vec3& x) { return rotated(x) + shift; }

std::vector<Particle> moved(std::vector<Particle> particles) {
  for (Particle& p : particles) {
    const Vec3 x = moved(Vec3(p.x, p.y, p.z)), v = rotated(Vec3(p.vx, p.vy, p.vz)), w = rotated(Vec3(p.wx, p.wy, p.wz));
    p.x = x.x, p.y = x.y, p.z = x.z;
    p.vx = v.x, p.vy = v.y, p.vz = v.z;
    p.wx = w.x, p.wy = w.y, p.wz = w.z;
  }
  return particles;
}

std::string as_stl(const Walls& walls) {
  std::string text = "solid walls\n";
  for (const Triangle& t : walls) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Vec3& c : t.corner) text += fmt::format("vertex {} {} {}\n", c.x, c.y, c.z);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid walls\n";
}

/// Largest difference of position (in diameters) and force (over the largest) after some steps.
struct Difference {
  double position = 0, force = 0;
};

Difference compare(Laboratory& here, Laboratory& there, std::size_t count, int steps) {
  for (int k = 0; k < steps; ++k) here.step(), there.step();
  here->compute_forces(), there->compute_forces();
  Difference difference;
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto id = static_cast<std::int64_t>(i);
    difference.position =
        std::max(difference.position, (moved(here.position(id)) - there.position(id)).norm() / test::crowd_diameter);
    difference.force = std::max(difference.force, (rotated(here.force(id)) - there.force(id)).norm());
    largest = std::max(largest, here.force(id).norm());
  }
  difference.force /= largest;
  return difference;
}

}  // namespace

Group frames() {
  Group group{"Frame of reference",
              "The same scene rotated by two arbitrary angles and shifted: cells, order of pairs and all components "
              "differ, the motion must not. A free cloud, and the pack in its box: plain walls against the "
              "same walls turned, from an STL file. Limit: rounding (1e-12 of an overlap), amplified by collisions for "
              "200 steps.",
              {}};
  {
    const auto cloud = test::polydisperse_cloud(0.02);
    Laboratory here(test::crowd_scene(1e-7), cloud), there(test::crowd_scene(1e-7), moved(cloud));
    const Difference difference = compare(here, there, cloud.size(), 200);
    group.checks.push_back({"cloud: position / d", 0, difference.position, 1e-10, false});
    group.checks.push_back({"cloud: force / largest", 0, difference.force, 1e-7, false});
  }
  Scene plain = test::crowd_scene(1e-7), turned = plain;
  plain.box.present = true;
  plain.box.max = test::packed_box_size;
  Walls walls = make_model(plain, nullptr, {}).walls;
  for (Triangle& t : walls)
    for (Vec3& corner : t.corner) corner = moved(corner);
  const test::ScratchFile stl(as_stl(walls), ".stl");
  turned.geometry.present = true;
  turned.geometry.stl = stl.name();
  const auto pack = test::packed_box(1e-3);
  Laboratory here(plain, pack), there(turned, moved(pack));
  const Difference difference = compare(here, there, pack.size(), 200);
  group.checks.push_back({"pack and walls: position / d", 0, difference.position, 1e-10, false});
  group.checks.push_back({"pack and walls: force / largest", 0, difference.force, 1e-7, false});
  return group;
}

}  // namespace clogflow::verification
