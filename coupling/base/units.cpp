// Quantities as text with a unit: a small table of symbols, decimal prefixes, and one exact rule:
// prefixes move the decimal exponent of the text, so "33 um" is the same double as 33e-6.
#include "coupling/base/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"

namespace clogflow {
namespace {

struct Symbol {
  std::string_view name;
  Dimension dimension;
  int exponent;    // of ten, to SI
  double divisor;  // what powers of ten cannot say is numerator / divisor, rounded once
  double numerator;
  bool prefixes;  // may carry a decimal prefix
  int angle = 0;
};

constexpr std::array symbols{
    Symbol{"1", {}, 0, 1, 1, false},
    Symbol{"m", dimension::length, 0, 1, 1, true},
    Symbol{"g", {0, 1, 0}, -3, 1, 1, true},
    Symbol{"s", dimension::time, 0, 1, 1, true},
    Symbol{"min", dimension::time, 0, 1, 60, false},
    Symbol{"h", dimension::time, 0, 1, 3600, false},
    Symbol{"Hz", dimension::rate, 0, 1, 1, true},
    Symbol{"N", dimension::force, 0, 1, 1, true},
    Symbol{"Pa", dimension::pressure, 0, 1, 1, true},
    Symbol{"bar", dimension::pressure, 5, 1, 1, true},
    Symbol{"J", {2, 1, -2}, 0, 1, 1, true},
    Symbol{"W", {2, 1, -3}, 0, 1, 1, true},
    Symbol{"P", dimension::viscosity, -1, 1, 1, true},
    Symbol{"L", {3, 0, 0}, -3, 1, 1, true},
    Symbol{"l", {3, 0, 0}, -3, 1, 1, true},
    Symbol{"rad", {}, 0, 1, 1, true, 1},
    Symbol{"deg", {}, 0, 180, std::numbers::pi, false, 1},
};

constexpr std::array<std::pair<std::string_view, int>, 10> prefixes{
    {{"p", -12}, {"n", -9}, {"u", -6}, {"m", -3}, {"c", -2}, {"d", -1}, {"h", 2}, {"k", 3}, {"M", 6}, {"G", 9}}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> spellings{
    {{"\u00b5", "u"}, {"\u03bc", "u"}, {"\u00b2", "2"}, {"\u00b3", "3"}, {"\u00b7", " "}, {"\u00b0", "deg"}}};

// A whole unit, as far as it has been read.
struct Unit {
  Dimension dimension;
  int exponent = 0;
  double numerator = 1;
  double divisor = 1;
  int angle = 0;

  void multiply(const Symbol& symbol, int prefix, int power) {
    dimension.length += symbol.dimension.length * power;
    dimension.mass += symbol.dimension.mass * power;
    dimension.time += symbol.dimension.time * power;
    exponent += (symbol.exponent + prefix) * power;
    for (int n = 0; n < std::abs(power); ++n) {
      numerator *= power > 0 ? symbol.numerator : symbol.divisor;
      divisor *= power > 0 ? symbol.divisor : symbol.numerator;
    }
    angle += symbol.angle * power;
  }
};

std::string plain_spelling(std::string text) {
  for (const auto& [special, plain] : spellings)
    for (auto at = text.find(special); at != std::string::npos; at = text.find(special))
      text.replace(at, special.size(), plain);
  return text;
}

const Symbol* find_symbol(std::string_view name) {
  for (const Symbol& symbol : symbols)
    if (symbol.name == name) return &symbol;
  return nullptr;
}

// The symbol as it stands comes first: "min" is a minute, "Pa" a pascal.
std::optional<std::pair<const Symbol*, int>> find_prefixed(std::string_view name) {
  if (const Symbol* symbol = find_symbol(name)) return {{symbol, 0}};
  for (const auto& [prefix, exponent] : prefixes) {
    if (!name.starts_with(prefix)) continue;
    const Symbol* symbol = find_symbol(name.substr(prefix.size()));
    if (symbol && symbol->prefixes) return {{symbol, exponent}};
  }
  return std::nullopt;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// One "symbol[^][-]power" of the product.
void read_factor(std::string_view factor, std::string_view whole, int sign, Unit& unit) {
  std::size_t end = factor == "1" ? 1 : 0;
  while (end < factor.size() && !is_digit(factor[end]) && factor[end] != '-' && factor[end] != '^') ++end;
  const std::string_view name = factor.substr(0, end);
  std::string_view power_text = factor.substr(end);
  if (power_text.starts_with('^')) power_text.remove_prefix(1);
  int power = 1;
  if (end < factor.size()) {
    const auto [stop, status] = std::from_chars(power_text.data(), power_text.data() + power_text.size(), power);
    require(
        status == std::errc{} && stop == power_text.data() + power_text.size() && power != 0 && std::abs(power) <= 9,
        "\"{}\" (\"{}\" is no unit: write a symbol and an integer power, e.g. \"m3\")", whole, factor);
  }
  const auto found = find_prefixed(name);
  for (std::size_t cut = name.size(); !found && cut-- > 1;)
    require(!find_prefixed(name.substr(0, cut)) || !find_prefixed(name.substr(cut)),
            "\"{}\" (unknown unit \"{}\": write a space between two units, \"{} {}\")", whole, name,
            name.substr(0, cut), factor.substr(cut));
  require(found.has_value(),
          "\"{}\" (unknown unit \"{}\": known are m g s min h Hz N Pa bar J W P L deg rad, with a "
          "prefix p n u m c k M G)",
          whole, name);
  unit.multiply(*found->first, found->second, sign * power);
}

Unit read_unit(std::string_view text, std::string_view whole) {
  Unit unit;
  const std::size_t slash = text.find('/');
  const std::string_view sides[2] = {text.substr(0, slash),
                                     slash == std::string_view::npos ? "" : text.substr(slash + 1)};
  require(sides[1].find('/') == std::string_view::npos,
          "\"{}\" (a unit has at most one \"/\": use negative powers, e.g. \"kg m-1 s-2\")", whole);
  for (int side = 0; side < 2; ++side) {
    int factors = 0;
    for (std::size_t at = 0; at < sides[side].size();) {
      const std::size_t end = std::min(sides[side].find_first_of(" *\t", at), sides[side].size());
      if (end > at) {
        read_factor(sides[side].substr(at, end - at), whole, side == 0 ? 1 : -1, unit);
        ++factors;
      }
      at = end + 1;
    }
    const bool expected = side == 0 || slash != std::string_view::npos;
    require(!expected || factors > 0, "\"{}\" (a unit is missing beside \"/\": for one per second write \"1/s\")",
            whole);
    require(side == 0 || factors <= 1,
            "\"{}\" (what is divided by is ambiguous: use negative powers, e.g. \"kg m-1 s-2\")", whole);
  }
  return unit;
}

// Length of the decimal number that text starts with, split before its exponent.
struct NumberText {
  std::size_t mantissa = 0;
  std::size_t length = 0;
};

NumberText scan_number(std::string_view text) {
  std::size_t at = 0, digits = 0;
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  for (; at < text.size() && is_digit(text[at]); ++at) ++digits;
  if (at < text.size() && text[at] == '.') ++at;
  for (; at < text.size() && is_digit(text[at]); ++at) ++digits;
  if (digits == 0) return {};
  NumberText number{at, at};
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    const std::size_t first = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    if (at > first) number.length = at;
  }
  return number;
}

double read_decimal(std::string_view text, NumberText number, const Unit& unit, std::string_view whole) {
  int exponent = 0;
  if (number.length > number.mantissa) {
    std::string_view digits = text.substr(number.mantissa + 1, number.length - number.mantissa - 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto status = std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec;
    require(status == std::errc{} && std::abs(exponent) < 1000, "\"{}\" (beyond the range of numbers)", whole);
  }
  std::string_view mantissa = text.substr(0, number.mantissa);
  if (mantissa.starts_with('+')) mantissa.remove_prefix(1);
  const std::string decimal = fmt::format("{}e{}", mantissa, exponent + unit.exponent);
  double value = 0;
  const auto status = std::from_chars(decimal.data(), decimal.data() + decimal.size(), value).ec;
  value = value * unit.numerator / unit.divisor;
  require(status == std::errc{} && std::isfinite(value), "\"{}\" (beyond the range of numbers)", whole);
  return value;
}

}  // namespace

Quantity parse_quantity(std::string_view whole) {
  require(whole.size() <= longest_shown, "\"{}\" (must be a number and a unit, e.g. \"33 um\")", shown_text(whole));
  const std::string spelled = plain_spelling(std::string(whole));
  std::string_view text = spelled;
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
  while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
  const NumberText number = scan_number(text);
  require(number.length > 0, "\"{}\" (must be a number and a unit, e.g. \"33 um\")", whole);
  const std::string_view unit_text = text.substr(number.length);
  require(!unit_text.starts_with(',') || unit_text.size() < 2 || !is_digit(unit_text[1]),
          "\"{}\" (a decimal comma: write a point, \"{}.{}\")", whole, text.substr(0, number.length),
          unit_text.substr(std::min<std::size_t>(1, unit_text.size())));
  require(!unit_text.empty(), "\"{}\" (a unit is missing, e.g. \"33 um\")", whole);
  const Unit unit = read_unit(unit_text, whole);
  return {.si = read_decimal(text, number, unit, whole),
          .dimension = unit.dimension,
          .is_angle = unit.angle == 1 && unit.dimension == dimension::number};
}

double parse_option(std::string_view option, std::string_view text, Dimension dimension, std::string_view meaning) {
  Quantity quantity{};
  try {
    quantity = parse_quantity(text);
  } catch (const Error& error) {
    throw Error(fmt::format("{} {} (must be {})", option, error.what(), meaning));
  }
  require(quantity.dimension == dimension, "{} {} (must be {})", option, text, meaning);
  return quantity.si;
}

std::string si_unit(Dimension d) {
  if (d == dimension::number) return "1";
  if (d == dimension::rate) return "1/s";
  if (d == dimension::velocity) return "m/s";
  if (d == dimension::density) return "kg/m3";
  if (d == dimension::pressure) return "Pa";
  if (d == dimension::viscosity) return "Pa s";
  if (d == dimension::stiffness) return "N/m";
  if (d == dimension::acceleration) return "m/s2";
  if (d == dimension::force) return "N";
  if (d == dimension::flow_rate) return "m3/s";
  if (d == dimension::compliance) return "m3/Pa";
  if (d == Dimension{2, 1, -2}) return "J";
  std::string unit;
  const std::pair<const char*, int> base[] = {{"kg", d.mass}, {"m", d.length}, {"s", d.time}};
  for (const auto& [symbol, power] : base) {
    if (power == 0) continue;
    if (!unit.empty()) unit += ' ';
    unit += symbol;
    if (power != 1) unit += std::to_string(power);
  }
  return unit;
}

QuantityWords quantity_words(Dimension d) {
  if (d == dimension::number) return {"a pure number", "0.6"};
  if (d == dimension::length) return {"a length", "33 um"};
  if (d == dimension::area) return {"an area", "0.01 mm2"};
  if (d == dimension::time) return {"a time", "10 ms"};
  if (d == dimension::rate) return {"a rate", "50 1/s"};
  if (d == dimension::velocity) return {"a velocity", "5 mm/s"};
  if (d == dimension::density) return {"a density", "1062 kg/m3"};
  if (d == dimension::pressure) return {"a pressure", "3 MPa"};
  if (d == dimension::viscosity) return {"a viscosity", "1.8 mPa s"};
  if (d == dimension::acceleration) return {"an acceleration", "-9.81 m/s2"};
  if (d == dimension::stiffness) return {"a stiffness, or an energy per area", "50 mN/m"};
  if (d == dimension::force) return {"a force", "2 nN"};
  if (d == dimension::flow_rate) return {"a flow rate", "10 uL/min"};
  if (d == dimension::compliance) return {"a compliance", "1e-15 m3/Pa"};
  return {fmt::format("a quantity in {}", si_unit(d)), fmt::format("1 {}", si_unit(d))};
}

std::string si_quantity(double si, Dimension d) { return fmt::format("{} {}", si, si_unit(d)); }

}  // namespace clogflow
