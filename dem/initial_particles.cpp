#include "dem/initial_particles.hpp"

#include <cmath>
#include <charconv>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "coupling/require.hpp"

namespace clog {

namespace {

/// Beyond, masses and moments of inertia leave the range of a number, and no suspension is known [m].
constexpr double least_radius = 1e-9, largest_radius = 1e3;

const std::map<std::string, double Particle::*> columns = {
    {"x", &Particle::x},   {"y", &Particle::y},   {"z", &Particle::z},
    {"vx", &Particle::vx}, {"vy", &Particle::vy}, {"vz", &Particle::vz},
    {"wx", &Particle::wx}, {"wy", &Particle::wy}, {"wz", &Particle::wz},
    {"radius", &Particle::radius}};

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) {
    const auto first = field.find_first_not_of(" \t\r");
    const auto last = field.find_last_not_of(" \t\r");
    fields.push_back(first == std::string::npos ? "" : field.substr(first, last - first + 1));
  }
  return fields;
}

double number(const std::string& field, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  require(error == std::errc() && end == field.data() + field.size() && std::isfinite(value),
          "{}: \"{}\" is not a finite number", where, field);
  return value;
}

}  // namespace

std::vector<Particle> read_initial_particles(const Scene& scene) {
  const std::string& file = scene.particles.initial;
  if (file.empty()) return {};
  std::ifstream stream(file);
  require(stream.good(), "{}: cannot be read: give particles.initial an existing file", file);
  std::vector<Particle> particles;
  std::vector<double Particle::*> members;
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    if (line.empty() || line[0] == '#' || line == "\r") continue;
    const std::string where = fmt::format("{}:{}", file, line_number);
    const auto fields = split(line);
    if (members.empty()) {
      for (const std::string& field : fields) {
        require(columns.contains(field),
                "{}: unknown column \"{}\" (must be among x,y,z,radius,vx,vy,vz,wx,wy,wz)", where,
                field);
        members.push_back(columns.at(field));
      }
      continue;
    }
    require(fields.size() == members.size(), "{}: {} fields where the header has {}", where,
            fields.size(), members.size());
    Particle particle;
    particle.radius = scene.particles.diameter / 2;
    for (std::size_t k = 0; k < fields.size(); ++k)
      particle.*members[k] = number(fields[k], where);
    require(particle.radius > 0, "{}: radius = {} (must be positive)", where, particle.radius);
    require(particle.radius >= least_radius && particle.radius <= largest_radius,
            "{}: radius = {} m (must be from {} to {} m)", where, particle.radius, least_radius, largest_radius);
    particles.push_back(particle);
  }
  require(!particles.empty(), "{}: holds no particle (a header line and one line a particle)", file);
  return particles;
}

}  // namespace clog
