// A laboratory for tests: a few spheres, SI numbers, no flow; every step visible.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "coupling/base/require.hpp"
#include "coupling/scene/scene.hpp"
#include "dem/run/simulation.hpp"
#include "tests/scratch.hpp"

namespace clogflow::test {

/// What a scene of the laboratory cannot do without.
struct Substance {
  double youngs_modulus = 48e9;  ///< [Pa]
  double poisson_ratio = 0.2;    ///< [-]
  double density = 2800;         ///< [kg/m3]
  double diameter = 0.02;        ///< [m]
};

/// A scene without walls, flow or friction, elastic; change its members to taste.
inline Scene laboratory_scene(const Substance& s, double step) {
  Scene scene = parse_scene(fmt::format(R"(
[particles]
diameter = "{} m"
density = "{} kg/m3"
[contact]
youngs_modulus = "{} Pa"
poisson_ratio = {}
[time]
end = "1 s"
step = "{} s"
)",
                                        s.diameter, s.density, s.youngs_modulus, s.poisson_ratio, step),
                            "laboratory");
  scene.contact.restitution = 1;
  return scene;
}

inline void set_friction(Scene& scene, const Friction& friction) {
  scene.contact.friction = scene.contact.wall_friction = friction;
}

/// A wall z = 0 and far away ones: a box that is `size` wide, above the origin.
inline void set_floor(Scene& scene, double size) {
  scene.box.present = true;
  scene.box.min = {-size / 2, -size / 2, 0};
  scene.box.max = {size / 2, size / 2, size};
}

/// A file with the given text, gone with its owner.
class ScratchFile {
public:
  explicit ScratchFile(const std::string& text, const std::string& ending = ".csv") {
    static int number = 0;
    path_ = scratch_folder() / fmt::format("{}{}", ++number, ending);
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~ScratchFile() { std::filesystem::remove(path_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  std::string name() const { return path_.string(); }

private:
  std::filesystem::path path_;
};

inline std::string as_csv(const std::vector<Particle>& particles) {
  std::string text = "x,y,z,radius,vx,vy,vz,wx,wy,wz\n";
  for (const Particle& p : particles)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", p.x, p.y, p.z, p.radius, p.vx, p.vy, p.vz, p.wx, p.wy, p.wz);
  return text;
}

/// A simulation of the given particles; ids count from 0 in their order.
class Laboratory {
public:
  Laboratory(Scene scene, const std::vector<Particle>& particles, const FlowGrid* flow = nullptr)
      : file_(as_csv(particles)), simulation_(start(std::move(scene), particles, flow, file_.name())) {}

  Simulation& operator*() { return simulation_; }
  Simulation* operator->() { return &simulation_; }

  void step() {
    simulation_.compute_forces();
    simulation_.advance();
  }

  void run_until(double time) {
    while (simulation_.time() < time) step();
  }

  /// Where the particle of this id stands in the arrays: lists sort them in space.
  std::size_t at(std::int64_t id) const {
    const auto& ids = simulation_.particles().id;
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (ids[i] == id) return i;
    throw Error("no such particle");
  }

  Vec3 position(std::int64_t id) const { return get(&ParticleState::x, &ParticleState::y, &ParticleState::z, id); }
  Vec3 velocity(std::int64_t id) const { return get(&ParticleState::vx, &ParticleState::vy, &ParticleState::vz, id); }
  Vec3 spin(std::int64_t id) const { return get(&ParticleState::wx, &ParticleState::wy, &ParticleState::wz, id); }
  Vec3 force(std::int64_t id) const { return get(&ParticleState::fx, &ParticleState::fy, &ParticleState::fz, id); }
  Vec3 torque(std::int64_t id) const { return get(&ParticleState::tx, &ParticleState::ty, &ParticleState::tz, id); }

private:
  /// A file knows one species alone.
  static Simulation start(Scene scene, const std::vector<Particle>& particles, const FlowGrid* flow,
                          const std::string& file) {
    for (const Particle& p : particles)
      if (p.species > 0) return Simulation(scene, flow, 1, particles);
    scene.particles.initial = file;
    return Simulation(scene, flow, 1);
  }

  using Part = double ParticleState::*;
  Vec3 get(Part x, Part y, Part z, std::int64_t id) const {
    const ParticleState& p = simulation_.particles()[at(id)];
    return {p.*x, p.*y, p.*z};
  }

  ScratchFile file_;
  Simulation simulation_;
};

}  // namespace clogflow::test
