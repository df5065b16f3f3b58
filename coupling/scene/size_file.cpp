// A file of sizes, as a sieve, a counter or a microscope gives them.
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "coupling/scene/particle_sizes.hpp"

namespace clogflow {

namespace {

std::string trimmed_field(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\"'"), last = text.find_last_not_of(" \t\r\"'");
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

/// The two fields of a line.
std::array<std::string, 2> two_fields(std::string_view line, const std::string& where) {
  const auto cut = line.find_first_of(",;\t");
  require(cut != std::string_view::npos && line.find_first_of(",;\t", cut + 1) == std::string_view::npos,
          "{}: two fields are wanted, a diameter and a share with a comma between", where);
  return {trimmed_field(line.substr(0, cut)), trimmed_field(line.substr(cut + 1))};
}

/// What the columns are.
struct SizeHeader {
  std::string unit;
  bool of_volume;
};

SizeHeader read_size_header(const std::array<std::string, 2>& titles, const std::string& where) {
  const auto open = titles[0].find('[');
  require(
      titles[0].starts_with("diameter") && open != std::string::npos && titles[0].ends_with("]") &&
          (titles[1] == "share" || titles[1] == "volume_share"),
      "{}: \"{},{}\" is no header (must be \"diameter [um],share\", or volume_share for shares of the solids' volume)",
      where, titles[0], titles[1]);
  const std::string unit = titles[0].substr(open + 1, titles[0].size() - open - 2);
  require(parse_quantity("1 " + unit).dimension == dimension::length,
          "{}: diameter has the unit \"{}\" (must be that of a length)", where, unit);
  return {unit, titles[1] == "volume_share"};
}

double share_in(const std::string& field, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  require(error == std::errc() && end == field.data() + field.size() && std::isfinite(value) && value >= 0,
          "{}: \"{}\" is no share (a number from 0 on, with a decimal point)", where, field);
  return value;
}

}  // namespace

std::vector<Species> read_size_file(const std::string& file) {
  std::ifstream stream(file);
  require(stream.good(), "{}: cannot be read: give particles.size_file an existing file", file);
  std::vector<Species> rows;
  SizeHeader header{};
  double sum = 0;
  int number = 0;
  bool headed = false;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (trimmed_field(line).empty() || line[0] == '#') continue;
    const std::string where = fmt::format("{}:{}", file, number);
    const auto fields = two_fields(line, where);
    if (!headed) {
      header = read_size_header(fields, where);
      headed = true;
      continue;
    }
    const double diameter = parse_quantity(fields[0] + " " + header.unit).si, share = share_in(fields[1], where);
    require(diameter > 0, "{}: diameter = {} {} (must be > 0)", where, fields[0], header.unit);
    if (share == 0) continue;  // an empty bin
    rows.push_back({diameter, header.of_volume ? share / (diameter * diameter * diameter) : share, 0});
    sum += rows.back().share;
    require(rows.size() <= most_species, "{}: more than {} sizes: put neighbouring ones together", where, most_species);
  }
  require(!rows.empty(), "{}: holds no size (a header \"diameter [um],share\" and one line a size)", file);
  for (Species& row : rows) row.share /= sum;
  return rows;
}

}  // namespace clogflow
