// Pairs of unequal spheres: all that are within reach, each once, in an order that does not depend on how they were
// stored; and work in proportion to their number.
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "coupling/base/random_stream.hpp"
#include "dem/contact/neighbours.hpp"
#include "dem/contact/size_levels.hpp"

namespace clogflow::test {
namespace {

/// Half of the volume large, half small, at random places that may overlap; ids as they come.
Particles cloud(int large, double ratio, double edge) {
  RandomStream random(7);
  Particles p;
  const auto add = [&](double radius) {
    p.add({.id = static_cast<std::int64_t>(p.size()),
           .radius = radius,
           .mass = 1,
           .inertia = 1,
           .x = random.uniform(0, edge),
           .y = random.uniform(0, edge),
           .z = random.uniform(0, edge)});
  };
  for (int k = 0; k < large; ++k) add(ratio * random.uniform(0.9, 1));
  for (int k = 0; k < large * ratio * ratio * ratio; ++k) add(random.uniform(1, 1.1));
  return p;
}

std::set<std::pair<std::int64_t, std::int64_t>> by_looking_at_each(const Particles& p, const Reach& reach) {
  std::set<std::pair<std::int64_t, std::int64_t>> pairs;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 1; j < p.size(); ++j)
      if (std::hypot(p[i].x - p[j].x, p[i].y - p[j].y, p[i].z - p[j].z) < reach.of(p[i].radius, p[j].radius))
        pairs.insert(std::minmax(p.id[i], p.id[j]));
  return pairs;
}

TEST(SizeLevels, FindAllPairsOnce) {
  for (const double ratio : {2.5, 10.0})
    for (const double per_radius : {0.0, 1.5}) {
      const Reach reach{.skin = 0.3, .lubrication = 0.2, .per_radius = per_radius, .by_size = true};
      Particles p = cloud(ratio > 5 ? 3 : 60, ratio, 2.5 * ratio * std::cbrt(ratio > 5 ? 3 : 60));
      const auto wanted = by_looking_at_each(p, reach);
      Neighbours list;
      list.rebuild(p, {}, reach);
      std::set<std::pair<std::int64_t, std::int64_t>> found;
      int last = 0;
      std::size_t count = 0;
      list.for_each_pair([&](int i, int j) {
        EXPECT_LT(i, j);
        EXPECT_LE(last, i);
        last = i;
        ++count;
        found.insert(std::minmax(p.id[i], p.id[j]));
      });
      EXPECT_EQ(found.size(), count) << "a pair came twice";
      EXPECT_EQ(found, wanted);
      EXPECT_GT(wanted.size(), 100u);
    }
}

TEST(SizeLevels, DoNotDependOnHowParticlesWereStored) {
  const Reach reach{.skin = 0.3, .by_size = true};
  Particles p = cloud(3, 10, 40), q = p;
  std::vector<int> backwards(q.size());
  for (std::size_t k = 0; k < q.size(); ++k) backwards[k] = static_cast<int>(q.size() - 1 - k);
  q.reorder(backwards);
  Neighbours a, b;
  a.rebuild(p, {}, reach);
  b.rebuild(q, {}, reach);
  EXPECT_EQ(p.id, q.id);
  ASSERT_EQ(a.groups.size(), b.groups.size());
  for (std::size_t k = 0; k < a.groups.size(); ++k) {
    EXPECT_EQ(a.groups[k].first, b.groups[k].first);
    EXPECT_EQ(a.groups[k].second, b.groups[k].second);
  }
}

/// Pairs compared for each particle.
double compared(double ratio, int large) {
  const Reach reach{.skin = 0.2, .by_size = true};
  const Particles p = cloud(large, ratio, 2 * ratio * std::cbrt(large));
  std::size_t count = 0;
  SizeLevels(p, reach, std::max(ratio, 1.1), ratio > 1 ? 1 : 0.9).for_each_pair([&](int, int) { ++count; });
  return static_cast<double>(count) / static_cast<double>(p.size());
}

TEST(SizeLevels, CompareAsManyForEachParticleWhateverTheRatio) {
  const double equal = compared(1, 8000), threefold = compared(3, 300), tenfold = compared(10, 8);
  EXPECT_LT(threefold, 2 * equal);
  EXPECT_LT(tenfold, 2 * equal);
  EXPECT_NEAR(compared(3, 600) / threefold, 1, 0.25);
}

}  // namespace
}  // namespace clogflow::test
