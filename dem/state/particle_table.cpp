#include "dem/state/particle_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"

namespace clogflow {

namespace {

struct Meaning {
  double Particle::*member;
  Dimension dimension;
  double factor = 1;
};

constexpr Dimension length = dimension::length, velocity = dimension::velocity, rate = dimension::rate;

const std::map<std::string, Meaning> meanings = {{"x", {&Particle::x, length}},
                                                 {"y", {&Particle::y, length}},
                                                 {"z", {&Particle::z, length}},
                                                 {"points:0", {&Particle::x, length}},
                                                 {"points:1", {&Particle::y, length}},
                                                 {"points:2", {&Particle::z, length}},
                                                 {"radius", {&Particle::radius, length}},
                                                 {"diameter", {&Particle::radius, length, 0.5}},
                                                 {"vx", {&Particle::vx, velocity}},
                                                 {"vy", {&Particle::vy, velocity}},
                                                 {"vz", {&Particle::vz, velocity}},
                                                 {"velocity:0", {&Particle::vx, velocity}},
                                                 {"velocity:1", {&Particle::vy, velocity}},
                                                 {"velocity:2", {&Particle::vz, velocity}},
                                                 {"wx", {&Particle::wx, rate}},
                                                 {"wy", {&Particle::wy, rate}},
                                                 {"wz", {&Particle::wz, rate}},
                                                 {"spin:0", {&Particle::wx, rate}},
                                                 {"spin:1", {&Particle::wy, rate}},
                                                 {"spin:2", {&Particle::wz, rate}},
                                                 {"omegax", {&Particle::wx, rate}},
                                                 {"omegay", {&Particle::wy, rate}},
                                                 {"omegaz", {&Particle::wz, rate}}};

/// Lengths' units that may stand after a line, the longest name first.
constexpr std::array<std::string_view, 5> short_units{"um", "nm", "mm", "cm", "m"};

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\"'"), last = text.find_last_not_of(" \t\r\"'");
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

/// A column's name and its unit, empty for SI.
struct Title {
  std::string name, unit;
};

Title read_title(const std::string& text) {
  const auto open = text.find_first_of("[(");
  if (open != std::string::npos && open > 0 && (text.back() == ']' || text.back() == ')'))
    return {lower(trimmed(text.substr(0, open))), trimmed(text.substr(open + 1, text.size() - open - 2))};
  const auto line = text.rfind('_');
  if (line == std::string::npos) return {lower(text), ""};
  const std::string name = lower(text.substr(0, line)), unit = text.substr(line + 1);
  if (std::find(short_units.begin(), short_units.end(), unit) != short_units.end() && meanings.contains(name))
    return {name, unit};
  return {lower(text), ""};
}

char separator_of(std::string_view line) {
  for (const char c : {';', ',', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

void check_unit(const Title& title, const Meaning& meaning, const std::string& where) {
  if (title.unit.empty()) return;
  require(parse_quantity("1 " + title.unit).dimension == meaning.dimension,
          "{}: column \"{}\" has the unit \"{}\" (must be that of {})", where, title.name, title.unit,
          quantity_words(meaning.dimension).name);
}

/// x, y and z must all be there, in one unit.
void check_coordinates(const ParticleTable& table, const std::string& where) {
  const std::pair<const char*, double Particle::*> wanted[] = {
      {"x", &Particle::x}, {"y", &Particle::y}, {"z", &Particle::z}};
  const ParticleColumn* first = nullptr;
  for (const auto& each : wanted) {
    const char* name = each.first;
    const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                     [&](const ParticleColumn& c) { return c.member == each.second; });
    require(column != table.columns.end(), "{}: there is no column {} (a header must name x, y and z)", where, name);
    if (!first) first = &*column;
    require(column->unit == first->unit, "{}: x is in \"{}\" and {} in \"{}\": give all coordinates in one unit", where,
            first->unit.empty() ? "m" : first->unit, name, column->unit.empty() ? "m" : column->unit);
  }
}

}  // namespace

bool is_particle_header(std::string_view line) {
  const auto fields = split_fields(line, separator_of(line));
  return std::count_if(fields.begin(), fields.end(),
                       [](const std::string& field) { return meanings.contains(read_title(field).name); }) >= 2;
}

ParticleTable read_particle_header(std::string_view line, const std::string& where) {
  ParticleTable table;
  table.separator = separator_of(line);
  for (const std::string& field : split_fields(line, table.separator)) {
    const Title title = read_title(field);
    const auto known = meanings.find(title.name);
    if (known == meanings.end()) {
      require(title.name != "mass" && title.name != "density",
              "{}: column \"{}\" (masses follow from particles.density): leave it out", where, field);
      table.columns.push_back({});
      table.left_out.push_back(field);
      continue;
    }
    const Meaning& meaning = known->second;
    check_unit(title, meaning, where);
    require(std::none_of(table.columns.begin(), table.columns.end(),
                         [&](const ParticleColumn& c) { return c.member == meaning.member; }),
            "{}: column \"{}\" says again what another column says: leave one of them out", where, field);
    table.columns.push_back({meaning.member, meaning.factor, title.unit});
  }
  check_coordinates(table, where);
  return table;
}

std::vector<std::string> split_fields(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end =
        std::min(separator == ' ' ? line.find_first_of(" \t\r", at) : line.find(separator, at), line.size());
    // Any number of blanks is one separator.
    if (separator != ' ' || end > at) fields.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  return fields;
}

}  // namespace clogflow
