// Quantities as people write them: the shortest digits that are exact, moved by a decimal prefix.
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "coupling/base/units.hpp"

namespace clogflow {
namespace {

struct Prefix {
  std::string_view name;
  int exponent;
};

/// A unit that prefixes go in front of; those that nobody says are left out.
struct ReadableUnit {
  Dimension dimension;
  std::string_view unit;
  int smallest, largest;  // exponents of its prefixes
};

constexpr std::array units{
    ReadableUnit{dimension::length, "m", -9, 0},
    ReadableUnit{dimension::time, "s", -9, 0},
    ReadableUnit{dimension::velocity, "m/s", -6, 0},
    ReadableUnit{dimension::pressure, "Pa", -3, 9},
    ReadableUnit{dimension::viscosity, "Pa s", -6, 3},
    ReadableUnit{dimension::force, "N", -12, 3},
    ReadableUnit{{2, 1, -2}, "J", -12, 3},
};

constexpr std::array shown_prefixes{Prefix{"p", -12}, Prefix{"n", -9}, Prefix{"u", -6}, Prefix{"m", -3},
                                    Prefix{"", 0},    Prefix{"k", 3},  Prefix{"M", 6},  Prefix{"G", 9}};

/// d.ddd x 10^exponent, the fewest digits that are read back to the same bits.
struct Decimal {
  std::string digits;  // without the point
  int exponent = 0;
};

Decimal decimal_of(double magnitude) {
  std::array<char, 32> buffer{};
  const auto [end, status] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude, std::chars_format::scientific);
  const std::string_view all(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const std::size_t e = all.find('e');
  Decimal decimal;
  for (const char c : all.substr(0, e))
    if (c != '.') decimal.digits += c;
  std::string_view exponent = all.substr(e + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  std::from_chars(exponent.data(), exponent.data() + exponent.size(), decimal.exponent);
  return decimal;
}

/// The number with its point `places` behind the first digit; places from 0 to 2.
std::string with_point(std::string digits, std::size_t places) {
  if (digits.size() <= places) digits.resize(places + 1, '0');
  if (digits.size() == places + 1) return digits;
  return fmt::format("{}.{}", digits.substr(0, places + 1), digits.substr(places + 1));
}

std::optional<std::string> with_prefix(double si, const ReadableUnit& unit) {
  const Decimal decimal = decimal_of(std::abs(si));
  for (const Prefix& prefix : shown_prefixes) {
    const int places = decimal.exponent - prefix.exponent;
    if (prefix.exponent < unit.smallest || prefix.exponent > unit.largest || places < 0 || places > 2) continue;
    return fmt::format("{}{} {}{}", si < 0 ? "-" : "", with_point(decimal.digits, static_cast<std::size_t>(places)),
                       prefix.name, unit.unit);
  }
  return std::nullopt;
}

}  // namespace

std::string format_quantity(double si, Dimension d) {
  for (const ReadableUnit& unit : units)
    if (unit.dimension == d)
      if (const auto text = with_prefix(si, unit)) return *text;
  return si_quantity(si, d);
}

std::string format_angle(double radians) {
  constexpr int most_digits = 17;
  for (int digits = 1; digits <= most_digits; ++digits) {
    const double degrees = std::stod(fmt::format("{:.{}g}", radians * 180 / std::numbers::pi, digits));
    const std::string text = fmt::format("{} deg", degrees);
    if (parse_quantity(text).si == radians) return text;
  }
  return fmt::format("{} rad", radians);
}

}  // namespace clogflow
