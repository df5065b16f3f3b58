#include "dem/state/initial_particles.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>

#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "dem/physics/porosity.hpp"
#include "dem/state/particle_table.hpp"

namespace clogflow {

namespace {

/// Beyond, masses and moments of inertia leave the range of a number, and no suspension is known [m].
constexpr double least_radius = 1e-9, largest_radius = 1e3;

double number(const std::string& field, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  require(error == std::errc() && end == field.data() + field.size() && std::isfinite(value),
          "{}: \"{}\" is not a finite number{}", where, field,
          field.find(',') == std::string::npos ? "" : " (decimals are written with a point)");
  return value;
}

Particle read_particle(const std::vector<std::string>& fields, const ParticleTable& table, const std::string& where,
                       double usual_radius) {
  require(fields.size() == table.columns.size(), "{}: {} fields where the header has {}", where, fields.size(),
          table.columns.size());
  Particle particle;
  particle.radius = usual_radius;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const ParticleColumn& column = table.columns[k];
    if (!column.member) continue;
    const double value = number(fields[k], where);
    // "100" in um is read as "100 um" is: the same double as 100e-6.
    particle.*column.member =
        column.factor * (column.unit.empty() ? value : parse_quantity(fields[k] + " " + column.unit).si);
  }
  require(particle.radius > 0, "{}: radius = {} (must be positive)", where, particle.radius);
  require(particle.radius >= least_radius && particle.radius <= largest_radius,
          "{}: radius = {} m (must be from {} to {} m): a unit is given in the header, as in \"x [um],y [um],z "
          "[um],radius [um]\"",
          where, particle.radius, least_radius, largest_radius);
  return particle;
}

std::string note_on(const ParticleTable& table, const std::string& file) {
  if (table.left_out.empty()) return {};
  std::string names;
  for (const std::string& name : table.left_out) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", name);
  return fmt::format("{}: columns that say nothing to this program are left out: {}", file, names);
}

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

}  // namespace

InitialParticles read_initial_file(const Scene& scene) {
  const std::string& file = scene.particles.initial;
  if (file.empty()) return {};
  std::ifstream stream(file);
  require(stream.good(), "{}: cannot be read: give particles.initial an existing file", file);
  InitialParticles read;
  ParticleTable table;
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    if (line_number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string where = fmt::format("{}:{}", file, line_number);
    const bool comment = line[0] == '#', headed = !table.columns.empty();
    const std::string_view text =
        std::string_view(line).substr(comment ? std::min(line.find_first_not_of("# \t"), line.size()) : 0);
    if (comment && (headed || !is_particle_header(text))) continue;
    // A header in a comment may be followed by the same without one.
    if (!headed || (read.particles.empty() && is_particle_header(text))) {
      table = read_particle_header(text, where);
      continue;
    }
    read.particles.push_back(
        read_particle(split_fields(line, table.separator), table, where, scene.particles.diameter / 2));
    read.lines.push_back(line_number);
  }
  require(!read.particles.empty(), "{}: holds no particle (a header line and one line a particle)", file);
  read.note = note_on(table, file);
  return read;
}

std::vector<Particle> read_initial_particles(const Scene& scene) { return read_initial_file(scene).particles; }

Particle particle_at_rest(const Scene& scene, double radius) {
  return particle_at_rest(scene, radius, scene.particles.density);
}

Particle particle_at_rest(const Scene& scene, double radius, double density) {
  Particle p;
  p.radius = radius;
  p.mass = density * sphere_volume(radius) * scene.time.mass_scale;
  p.inertia = 0.4 * p.mass * radius * radius * scene.time.rotational_inertia_scale;
  return p;
}

}  // namespace clogflow
