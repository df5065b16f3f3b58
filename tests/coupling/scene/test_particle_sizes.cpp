// Distributions of diameters: the mean and spread asked for are those given; files, mixtures, and what is refused.
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "coupling/scene/particle_sizes.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/coupling/scene/scene_texts.hpp"
#include "tests/scratch.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;

constexpr SizeDistribution drawn[] = {SizeDistribution::uniform, SizeDistribution::normal, SizeDistribution::lognormal};

/// Mean of d^k, by adding up quantiles.
double counted_moment(const SizeClass& sizes, int k) {
  constexpr int count = 20000;
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += std::pow(sizes.quantile((i + 0.5) / count), k);
  return sum / count;
}

TEST(ParticleSizes, HaveTheMeanAndSpreadAskedFor) {
  for (const SizeDistribution kind : drawn)
    for (const double spread : {0.03, 0.25}) {
      const SizeClass sizes(kind, 2, spread);
      const double mean = counted_moment(sizes, 1), square = counted_moment(sizes, 2);
      EXPECT_NEAR(mean, 2, 2e-5);
      EXPECT_NEAR(std::sqrt(square - mean * mean) / mean, spread, 1e-4 * spread);
    }
}

TEST(ParticleSizes, KnowTheirMoments) {
  for (const SizeDistribution kind : drawn)
    for (int k = 1; k <= 3; ++k) {
      const SizeClass sizes(kind, 2, 0.25);
      EXPECT_NEAR(sizes.moment(k) / counted_moment(sizes, k), 1, 5e-5) << static_cast<int>(kind) << ", " << k;
    }
}

TEST(ParticleSizes, EndWhereTheyAreCut) {
  const double root = std::sqrt(3.0);
  EXPECT_DOUBLE_EQ(SizeClass(SizeDistribution::uniform, 2, 0.1).smallest(), 2 - root * 0.2);
  EXPECT_DOUBLE_EQ(SizeClass(SizeDistribution::uniform, 2, 0.1).largest(), 2 + root * 0.2);
  // A Gauss curve within 3 of its deviations has 0.986578 of its deviation left: 3 x 0.2 / 0.986578.
  EXPECT_NEAR(SizeClass(SizeDistribution::normal, 2, 0.1).largest(), 2 + 0.608163, 2e-6);
  EXPECT_NEAR(SizeClass(SizeDistribution::normal, 2, 0.1).smallest(), 2 - 0.608163, 2e-6);
  // Six deviations of the logarithm apart, which are about the spread where that is small.
  const SizeClass wide(SizeDistribution::lognormal, 2, 0.01);
  EXPECT_NEAR(std::log(wide.largest() / wide.smallest()), 6 * 0.01 / 0.986578, 2e-5);
}

TEST(ParticleSizes, TellWhatShareIsSmaller) {
  for (const SizeDistribution kind : drawn) {
    const SizeClass sizes(kind, 2, 0.2);
    for (const double share : {0.0, 0.01, 0.3, 0.5, 0.99, 1.0})
      EXPECT_NEAR(sizes.share_up_to(sizes.quantile(share)), share, 1e-12);
  }
}

Scene::Particles mixture() {
  Scene::Particles p;
  p.diameter = 1.2, p.density = 5;
  p.species = {{1, 0.5, 0}, {1.4, 0.5, 7}};
  return p;
}

TEST(ParticleSizes, OfAMixture) {
  const ParticleSizes sizes(mixture());
  EXPECT_FALSE(sizes.equal());
  EXPECT_FALSE(sizes.one_density());
  EXPECT_EQ(sizes.smallest(), 1);
  EXPECT_EQ(sizes.largest(), 1.4);
  EXPECT_DOUBLE_EQ(sizes.moment(1), 1.2);
  // (1 + 1.4^3) / (1 + 1.4^2)
  EXPECT_NEAR(sizes.sauter_mean(), 3.744 / 2.96, 1e-15);
  EXPECT_NEAR(sizes.mean_volume(), M_PI / 6 * 3.744 / 2, 1e-15);
  EXPECT_EQ(sizes.density(0), 5);
  EXPECT_EQ(sizes.density(1), 7);
  EXPECT_EQ(sizes.draw(0.49, 0.3).species, 0);
  EXPECT_EQ(sizes.draw(0.51, 0.3).species, 1);
  EXPECT_EQ(sizes.draw(0.51, 0.3).diameter, 1.4);
}

TEST(ParticleSizes, AreEqualWhereNothingIsSaid) {
  const Scene scene = parse_scene(channel, "scene");
  const ParticleSizes sizes(scene.particles);
  EXPECT_TRUE(sizes.equal());
  EXPECT_EQ(sizes.smallest(), scene.particles.diameter);
  EXPECT_EQ(sizes.sauter_mean(), scene.particles.diameter);
}

const char* const two_kinds =
    R"(particles.species=[{diameter="30 um",share=0.25},{diameter="34 um",share=0.75,density="1200 kg/m3"}])";

TEST(ParticleSizes, AMixtureSetsTheMeanDiameter) {
  const Scene scene = parse_scene(channel, "scene", {two_kinds});
  EXPECT_DOUBLE_EQ(scene.particles.diameter, 33e-6);
  EXPECT_EQ(scene.particles.species[1].density, 1200);
  const std::string text = effective_scene(scene);
  EXPECT_THAT(text, HasSubstr("species = [{diameter = \"3e-05 m\", share = 0.25}, {diameter = \"3.4e-05 m\", share = "
                              "0.75, density = \"1200 kg/m3\"}]"));
  EXPECT_EQ(effective_scene(parse_scene(text, "effective")), text);
}

std::string refused(const Overrides& overrides) {
  return refusal([&] { parse_scene(channel, "scene", overrides); });
}

TEST(ParticleSizes, RefuseWhatCannotBe) {
  EXPECT_THAT(refused({"particles.size_spread=0.6"}), HasSubstr("particles.size_spread = 0.6 (must be in [0, 0.5])"));
  EXPECT_THAT(
      refused({"particles.size_spread=0.3"}),
      HasSubstr("particles.size_spread = 0.3 (diameters would be from 2.896 um to 63.1 um: the smallest must be "
                "above 0, and the largest at most 10 times as large)"));
  EXPECT_THAT(refused({"particles.size_spread=0.45"}), HasSubstr("diameters would be from -12.16 um"));
  EXPECT_NO_THROW(
      parse_scene(channel, "scene", {"particles.size_distribution=lognormal", "particles.size_spread=0.3"}));
  EXPECT_THAT(refused({"particles.size_spread=0.25", "particles.diameter=70 um"}),
              HasSubstr("particles.size_spread = 0.25 (the largest has 123.2 um and must be smaller than "
                        "geometry.neck_width = 100 um, or no particle fits through)"));
  EXPECT_THAT(refused({"particles.size_distribution=file"}),
              HasSubstr("particles.size_distribution = \"file\" (needs particles.size_file too)"));
  EXPECT_THAT(refused({"particles.size_file=x.csv"}), HasSubstr("(is for particles.size_distribution = \"file\")"));
  EXPECT_THAT(
      refused({two_kinds, "particles.diameter=35 um"}),
      HasSubstr("particles.diameter = \"35 um\" (the mean over the number of particles.species is 33 um): leave "
                "it out"));
  EXPECT_THAT(refused({"particles.size_spread=0.2", "particles.roughness=4 um"}),
              HasSubstr("particles.roughness = \"4 um\" (must be smaller than a quarter of the smallest diameter = "));
  EXPECT_THAT(refused({"particles.size_spread=0.2", "lubrication.enabled=true", "lubrication.cutoff=0.5 um"}),
              HasSubstr("lubrication.cutoff = \"0.5 um\" (between the smallest particles "));
  EXPECT_THAT(refused({"particles.size_spread=0.2", "porosity.method=local", "porosity.width=20 um"}),
              HasSubstr("(must be at least half of the largest diameter = "));
}

TEST(ParticleSizes, RefuseMixturesThatCannotBe) {
  const auto kinds = [](const std::string& text) { return refused({"particles.species=" + text}); };
  EXPECT_THAT(kinds("[]"), HasSubstr("must be a list of kinds"));
  EXPECT_THAT(kinds("3"), HasSubstr("must be a list of kinds"));
  EXPECT_THAT(kinds("[3]"), HasSubstr("particles.species[0] = 3 (must be a kind of particles"));
  EXPECT_THAT(kinds("[{share=1.0}]"), HasSubstr("has no diameter"));
  EXPECT_THAT(kinds(R"([{diameter="30 um"}])"), HasSubstr("has no share"));
  EXPECT_THAT(kinds(R"([{diameter="30 um",share=0.5},{diameter="40 um",share=0.4}])"),
              HasSubstr("shares must add up to 1, these to 0.9"));
  EXPECT_THAT(kinds(R"([{diameter="30 um",share=-1}])"), HasSubstr("particles.species[0].share = -1 (must be > 0)"));
  EXPECT_THAT(kinds(R"([{diameter=30,share=1.0}])"), HasSubstr("a length needs a unit"));
  EXPECT_THAT(kinds(R"([{diameter="30 um",share=1.0,stiffness=0.5}])"),
              HasSubstr("particles.species[0].stiffness = 0.5 (unknown: a species has diameter, share, density, "
                        "friction and wall_friction; all else is common)"));
  EXPECT_THAT(kinds(R"([{diameter="5 um",share=0.5},{diameter="51 um",share=0.5}])"),
              HasSubstr("diameters would be from 5 um to 51 um"));
  EXPECT_NO_THROW(parse_scene(channel, "scene",
                              {R"(particles.species=[{diameter="5 um",share=0.5},{diameter="50 um",share=0.5}])"}));
}

TEST(ParticleSizes, RefuseFrictionThatIsNone) {
  const auto friction = [](const std::string& text) {
    return refused({R"(particles.species=[{diameter="30 um",share=1.0,)" + text + "}]"});
  };
  EXPECT_THAT(friction("friction=0.5"), HasSubstr("particles.species[0].friction = 0.5 (must be coefficients, e.g. "
                                                  "{sliding = 0.3, rolling = 0.1}; those left out are common)"));
  EXPECT_THAT(friction("wall_friction={}"),
              HasSubstr("particles.species[0].wall_friction = {...} (must be coefficients, e.g. "));
  EXPECT_THAT(friction("friction={sliding=-0.1}"),
              HasSubstr("particles.species[0].friction.sliding = -0.1 (must be >= 0)"));
  EXPECT_THAT(friction("friction={sliding=nan}"), HasSubstr("particles.species[0].friction.sliding = nan ("));
  EXPECT_THAT(friction(R"(friction={rolling="0.1"})"),
              HasSubstr("particles.species[0].friction.rolling = \"0.1\" (must be a pure number"));
  EXPECT_THAT(friction("wall_friction={twist=0.1}"),
              HasSubstr("particles.species[0].wall_friction.twist = 0.1 (unknown: friction has sliding, rolling and "
                        "torsion)"));
}

std::string refused_file(const std::string& text) {
  const ScratchFolder folder;
  const auto file = folder.path() / "sizes.csv";
  std::ofstream(file) << text;
  return refusal([&] { read_size_file(file.string()); });
}

TEST(ParticleSizes, FromAFile) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "sizes.csv") << "# counted\ndiameter [um],share\n30,1\n32, 0\n34,3\n";
  std::ofstream(folder.path() / "scene.toml") << channel;
  const Scene scene =
      read_scene(folder.path() / "scene.toml",
                 {"particles.size_distribution=file", "particles.size_file=" + (folder.path() / "sizes.csv").string()});
  // Counts are scaled to 1, an empty bin is none.
  EXPECT_EQ(scene.particles.species, (std::vector<Species>{{30e-6, 0.25, 0}, {34e-6, 0.75, 0}}));
  EXPECT_DOUBLE_EQ(scene.particles.diameter, 33e-6);
  // What is written needs the file no more.
  std::filesystem::remove(folder.path() / "sizes.csv");
  const std::string text = effective_scene(scene);
  EXPECT_EQ(effective_scene(parse_scene(text, "effective")), text);
}

TEST(ParticleSizes, FromSharesOfVolume) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "sizes.csv") << "diameter [um];volume_share\n10;0.5\n20;0.5\n";
  const auto read = read_size_file((folder.path() / "sizes.csv").string());
  // As much volume in eight times as many.
  EXPECT_NEAR(read[0].share, 8.0 / 9, 1e-15);
  EXPECT_NEAR(read[1].share, 1.0 / 9, 1e-15);
}

TEST(ParticleSizes, RefuseFilesThatSayNothing) {
  EXPECT_THAT(refused_file(""), HasSubstr("holds no size"));
  EXPECT_THAT(refused_file("diameter,share\n1,1\n"), HasSubstr("sizes.csv:1: \"diameter,share\" is no header"));
  EXPECT_THAT(refused_file("diameter [s],share\n1,1\n"), HasSubstr("must be that of a length"));
  EXPECT_THAT(refused_file("diameter [um],share\n1\n"), HasSubstr("sizes.csv:2: two fields are wanted"));
  EXPECT_THAT(refused_file("diameter [um],share\n1,x\n"), HasSubstr("sizes.csv:2: \"x\" is no share"));
  EXPECT_THAT(refused_file("diameter [um],share\n1,-1\n"), HasSubstr("\"-1\" is no share"));
  EXPECT_THAT(refused_file("diameter [um],share\n0,1\n"), HasSubstr("diameter = 0 um (must be > 0)"));
  std::string many = "diameter [um],share\n";
  for (int k = 0; k < 101; ++k) many += fmt::format("{},1\n", 10 + k);
  EXPECT_THAT(refused_file(many), HasSubstr("more than 100 sizes"));
}

}  // namespace
}  // namespace clogflow
