#include "dem/fluid/oscillation.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/base/text_file.hpp"
#include "coupling/base/units.hpp"
#include "coupling/geometry/channel_shape.hpp"
#include "dem/state/particle_table.hpp"

namespace clogflow {

namespace {

/// Unit of the times, from "time" or "time [ms]".
std::string time_unit(const std::string& header, const std::string& where) {
  const std::vector<std::string> names = split_fields(header, ',');
  const bool plain = names.size() == 2 && names[0] == "time";
  const bool with_unit = names.size() == 2 && names[0].starts_with("time [") && names[0].ends_with("]");
  require((plain || with_unit) && names[1] == "factor",
          "{}: \"{}\" (the header of a table of the flow is time,factor or time [ms],factor)", where,
          shown_text(header));
  if (plain) return "s";
  const std::string unit = names[0].substr(6, names[0].size() - 7);
  require(parse_quantity("1 " + unit).dimension == dimension::time, "{}: [{}] (must be a unit of time, e.g. [ms])",
          where, shown_text(unit));
  return unit;
}

double finite_number(const std::string& field, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  require(error == std::errc() && end == field.data() + field.size() && std::isfinite(value),
          "{}: \"{}\" is not a finite number", where, shown_text(field));
  return value;
}

}  // namespace

Oscillation::Oscillation(const Scene& scene)
    : amplitude_(scene.flow.oscillation.amplitude),
      frequency_(scene.flow.oscillation.frequency),
      phase_(scene.flow.oscillation.phase),
      square_(scene.flow.oscillation.shape == OscillationShape::square) {
  if (!scene.flow.oscillation.table.empty()) table_ = read_table(scene.flow.oscillation.table);
}

std::vector<Oscillation::Row> Oscillation::read_table(const std::string& file) {
  std::istringstream in(read_text_file(file));
  std::vector<Row> rows;
  std::string unit;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    if (line.find_first_not_of(" \t") == std::string::npos || line.starts_with('#')) continue;
    const std::string where = fmt::format("{}:{}", file, number);
    if (unit.empty()) {
      unit = time_unit(line, where);
      continue;
    }
    const std::vector<std::string> fields = split_fields(line, ',');
    require(fields.size() == 2, "{}: {} fields (must be two: a time and a factor)", where, fields.size());
    finite_number(fields[0], where);
    const Row row{parse_quantity(fields[0] + " " + unit).si, finite_number(fields[1], where)};
    require(!rows.empty() || row.time == 0, "{}: the first time is {} s (must be 0)", where, row.time);
    require(rows.empty() || row.time > rows.back().time, "{}: time {} s (must be later than the row before, {} s)",
            where, row.time, rows.empty() ? 0 : rows.back().time);
    rows.push_back(row);
  }
  require(!rows.empty(), "{}: no row (needs a header time,factor and at least one row)", file);
  return rows;
}

double Oscillation::factor(double time) const {
  if (table_.empty()) {
    const double turns = frequency_ * time + phase_, part = turns - std::floor(turns);
    const double wave = square_ ? (part < 0.5 ? 1 : -1) : std::sin(2 * std::numbers::pi * part);
    return 1 + amplitude_ * wave;
  }
  const auto after = std::ranges::upper_bound(table_, time, {}, &Row::time);
  if (after == table_.begin()) return table_.front().factor;
  if (after == table_.end()) return table_.back().factor;
  const Row &from = *std::prev(after), &to = *after;
  return from.factor + (to.factor - from.factor) * ((time - from.time) / (to.time - from.time));
}

double Oscillation::largest() const {
  if (table_.empty()) return 1 + amplitude_;
  double most = 0;
  for (const Row& row : table_) most = std::max(most, std::abs(row.factor));
  return most;
}

double Oscillation::least() const {
  if (table_.empty()) return 1 - amplitude_;
  return std::ranges::min(table_, {}, &Row::factor).factor;
}

bool Oscillation::reverses() const { return least() < 0; }

bool Oscillation::is_steady(double time) const { return !on() || (!table_.empty() && time >= table_.back().time); }

double Oscillation::longest_return() const {
  if (!reverses()) return 0;
  if (table_.empty()) {
    if (square_) return (amplitude_ - 1) / (2 * frequency_);
    const double turn = std::asin(1 / amplitude_);
    return (2 * amplitude_ * std::cos(turn) - (std::numbers::pi - 2 * turn)) / (2 * std::numbers::pi * frequency_);
  }
  if (table_.back().factor < 0) return std::numeric_limits<double>::infinity();
  double longest = 0, now = 0;
  for (std::size_t k = 1; k < table_.size(); ++k) {
    const double a = table_[k - 1].factor, b = table_[k].factor, time = table_[k].time - table_[k - 1].time;
    if (a >= 0) now = 0;
    // The triangle of a row's negative part, or the whole trapezium.
    if (a < 0 && b < 0)
      now -= time * (a + b) / 2;
    else if (a < 0 || b < 0)
      now += time * (std::min(a, b) * std::min(a, b)) / std::abs(b - a) / 2;
    longest = std::max(longest, now);
  }
  return longest;
}

double Oscillation::frequency() const {
  if (table_.empty()) return frequency_;
  double steepest = 0;
  for (std::size_t k = 1; k < table_.size(); ++k)
    steepest =
        std::max(steepest, std::abs(table_[k].factor - table_[k - 1].factor) / (table_[k].time - table_[k - 1].time));
  return largest() > 0 ? steepest / largest() / (2 * std::numbers::pi) : 0;
}

void check_return(const Scene& s, const Oscillation& oscillation) {
  if (!s.geometry.present || !oscillation.reverses()) return;
  const auto& o = s.flow.oscillation;
  const std::string key = o.table.empty() ? fmt::format("flow.oscillation.amplitude = {}", o.amplitude)
                                          : fmt::format("flow.oscillation.table = {}", o.table);
  require(
      s.geometry.stl.empty() && s.geometry.expansion_width > 0,
      "{} (the flow goes back, but particles that left at the end of the neck are gone: give the channel behind it, "
      "geometry.expansion_width and expansion_length, or keep the factor at 0 or above)",
      key);
  require(!s.flow.balances(), "{} (the flow goes back: that is for flow.drive = \"rate\" without flow.compliance)",
          key);
  require(s.unclog.protocol == UnclogProtocol::none,
          "{} (the flow goes back, which clears the neck by itself): set unclog.protocol = \"none\"", key);
  require(s.inlet.concentration == 0,
          "{} (the flow goes back through the inlet, which cannot give inlet.concentration then): leave that out", key);
  const double back = oscillation.longest_return() * channel_flow_rate(s.geometry, s.flow.mean_velocity);
  const double behind = channel_volume(s.geometry, s.geometry.neck_length, channel_end(s.geometry));
  require(
      back <= returning_share * behind,
      "{} (at most {:.3g} m3 would go back without a pause, more than half of the {:.3g} m3 behind the neck, beyond "
      "which particles are gone): raise geometry.expansion_length or the frequency",
      key, back, behind);
}

}  // namespace clogflow
