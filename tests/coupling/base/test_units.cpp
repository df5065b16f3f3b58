// Every unit, the exactness of prefixes, and what is refused.
#include <bit>
#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

#include "coupling/base/units.hpp"
#include "tests/coupling/refusal.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;

struct Example {
  const char* text;
  double si;
  Dimension dimension;
};

TEST(Units, EverySymbol) {
  const Example examples[] = {
      {"33 um", 33e-6, dimension::length},
      {"33um", 33e-6, dimension::length},
      {"33 \u00b5m", 33e-6, dimension::length},
      {"33 \u03bcm", 33e-6, dimension::length},
      {"1 mm", 1e-3, dimension::length},
      {"1 cm", 1e-2, dimension::length},
      {"7 nm", 7e-9, dimension::length},
      {"2 km", 2e3, dimension::length},
      {"3 g", 3e-3, {0, 1, 0}},
      {"3 kg", 3, {0, 1, 0}},
      {"5 ms", 5e-3, dimension::time},
      {"5 us", 5e-6, dimension::time},
      {"2 min", 120, dimension::time},
      {"10 uL/min", 1e-8 / 60, dimension::flow_rate},
      {"3.6 mL/h", 3.6e-6 / 3600, dimension::flow_rate},
      {"2e-10 m3/s", 2e-10, dimension::flow_rate},
      {"1e-15 m3/Pa", 1e-15, dimension::compliance},
      {"2 h", 7200, dimension::time},
      {"50 Hz", 50, dimension::rate},
      {"50 1/s", 50, dimension::rate},
      {"50 s-1", 50, dimension::rate},
      {"50 s^-1", 50, dimension::rate},
      {"2 nN", 2e-9, dimension::force},
      {"3 MPa", 3e6, dimension::pressure},
      {"3 GPa", 3e9, dimension::pressure},
      {"3 mPa", 3e-3, dimension::pressure},
      {"2 bar", 2e5, dimension::pressure},
      {"1.8e-3 Pa s", 1.8e-3, dimension::viscosity},
      {"1.8 mPa s", 1.8e-3, dimension::viscosity},
      {"1.8 mPa*s", 1.8e-3, dimension::viscosity},
      {"1.8 cP", 1.8e-3, dimension::viscosity},
      {"1062 kg/m3", 1062, dimension::density},
      {"1062 kg/m^3", 1062, dimension::density},
      {"1062 kg m-3", 1062, dimension::density},
      {"1062 kg/m\u00b3", 1062, dimension::density},
      {"1.062 g/cm3", 1062, dimension::density},
      {"1.062 kg/L", 1062, dimension::density},
      {"5 mm/s", 5e-3, dimension::velocity},
      {"9.81 m/s^2", 9.81, {1, 0, -2}},
      {"1 J", 1, {2, 1, -2}},
      {"1 W", 1, {2, 1, -3}},
      {"1 ml", 1e-6, {3, 0, 0}},
      {"0.6 1", 0.6, dimension::number},
      {" +3.0E1 um ", 30e-6, dimension::length},
      {"-.5 m", -0.5, dimension::length},
  };
  for (const Example& example : examples) {
    const Quantity quantity = parse_quantity(example.text);
    // Prefixes move the decimal point of the text, so nothing is rounded twice.
    EXPECT_EQ(quantity.si, example.si) << example.text;
    EXPECT_EQ(quantity.dimension, example.dimension) << example.text;
    EXPECT_FALSE(quantity.is_angle) << example.text;
  }
}

TEST(Units, Angles) {
  EXPECT_DOUBLE_EQ(parse_quantity("60 deg").si, std::numbers::pi / 3);
  EXPECT_EQ(parse_quantity("90 deg").si, std::numbers::pi / 2);
  EXPECT_EQ(parse_quantity("1 rad").si, 1);
  EXPECT_TRUE(parse_quantity("60 deg").is_angle);
  EXPECT_TRUE(parse_quantity("60 \u00b0").is_angle);
  EXPECT_EQ(parse_quantity("3 rad/s").dimension, dimension::rate);
  EXPECT_FALSE(parse_quantity("3 rad/s").is_angle);
}

TEST(Units, FormattedTextReadsBackToTheSameBits) {
  const Dimension dimensions[] = {dimension::number,    dimension::length,  dimension::time,  dimension::rate,
                                  dimension::velocity,  dimension::density, dimension::force, dimension::pressure,
                                  dimension::viscosity, {2, 1, -2},         {1, 0, -2},       {0, 2, 3}};
  for (const Dimension d : dimensions)
    for (const double value : {0.0, 1.0, -1.0 / 3.0, 33e-6, 1e-300, 1.7976931348623157e308, 0.1 + 0.2}) {
      const Quantity quantity = parse_quantity(format_quantity(value, d));
      EXPECT_EQ(quantity.si, value) << format_quantity(value, d);
      EXPECT_EQ(quantity.dimension, d) << format_quantity(value, d);
      EXPECT_EQ(parse_quantity(si_quantity(value, d)).si, value) << si_quantity(value, d);
    }
  EXPECT_EQ(si_quantity(3.3e-5, dimension::length), "3.3e-05 m");
}

TEST(Units, ArePrintedAsPeopleWriteThem) {
  const std::pair<const char*, Quantity> examples[] = {
      {"33 um", {3.3e-5, dimension::length, false}}, {"1.65 um", {1.65e-6, dimension::length, false}},
      {"100 um", {1e-4, dimension::length, false}},  {"1 mm", {1e-3, dimension::length, false}},
      {"2500 m", {2.5e3, dimension::length, false}}, {"-50 um", {-5e-5, dimension::length, false}},
      {"0 m", {0, dimension::length, false}},        {"500 ms", {0.5, dimension::time, false}},
      {"1.5 s", {1.5, dimension::time, false}},      {"5 mm/s", {5e-3, dimension::velocity, false}},
      {"3 MPa", {3e6, dimension::pressure, false}},  {"1.8 mPa s", {1.8e-3, dimension::viscosity, false}},
      {"1 nN", {1e-9, dimension::force, false}},     {"1062 kg/m3", {1062, dimension::density, false}},
      {"50 1/s", {50, dimension::rate, false}},      {"1e-300 m", {1e-300, dimension::length, false}},
      {"9.81 m/s2", {9.81, {1, 0, -2}, false}},
  };
  for (const auto& [text, quantity] : examples) EXPECT_EQ(format_quantity(quantity.si, quantity.dimension), text);
  EXPECT_EQ(format_angle(std::numbers::pi / 3), "60 deg");
  EXPECT_EQ(format_angle(parse_quantity("22.5 deg").si), "22.5 deg");
  EXPECT_EQ(format_angle(parse_quantity("1 rad").si), format_angle(1));
}

TEST(Units, PrintedTextIsExactForAnyNumber) {
  std::mt19937_64 random(1);
  const auto check = [](double value, Dimension d) {
    const std::string text = format_quantity(value, d);
    EXPECT_EQ(parse_quantity(text).si, value) << text;
    EXPECT_EQ(parse_quantity(text).dimension, d) << text;
  };
  for (int k = 0; k < 20000; ++k) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const double near = std::ldexp(value, -std::ilogb(value) + static_cast<int>(random() % 80) - 50);
    for (const Dimension d : {dimension::length, dimension::time, dimension::velocity, dimension::pressure,
                              dimension::viscosity, dimension::force, dimension::density}) {
      check(value, d);
      check(near, d);
    }
    const double angle = std::abs(std::ldexp(near, 20 - std::ilogb(near) - static_cast<int>(random() % 40)));
    EXPECT_EQ(parse_quantity(format_angle(angle)).si, angle) << format_angle(angle);
    EXPECT_TRUE(parse_quantity(format_angle(angle)).is_angle);
  }
}

TEST(Units, RefusalsSayWhy) {
  const std::pair<const char*, const char*> refused[] = {
      {"33", "\"33\" (a unit is missing"},
      {"", "must be a number and a unit"},
      {"um", "must be a number and a unit"},
      {"nan m", "must be a number and a unit"},
      {"inf m", "must be a number and a unit"},
      {"0x10 m", "\"x10\" is no unit"},
      {"33 foo", "unknown unit \"foo\""},
      {"3 kmin", "unknown unit \"kmin\""},
      {"3 m/s/s", "at most one \"/\""},
      {"3 kg/m s", "ambiguous"},
      {"3 /s", "write \"1/s\""},
      {"3 m/", "a unit is missing beside"},
      {"3 m^x", "no unit"},
      {"3 m0", "no unit"},
      {"3 m99999999999", "no unit"},
      {"1e999 m", "beyond the range"},
      {"1e308 Gm", "beyond the range"},
      {"1e99999999999 m", "beyond the range"},
  };
  for (const auto& [text, reason] : refused)
    EXPECT_THAT(refusal([&, text = text] { parse_quantity(text); }), HasSubstr(reason)) << text;
}

TEST(Options, AreReadInSiUnitsAndNamedWhenRefused) {
  const auto refused = [](const char* text) {
    return refusal([&] { parse_option("--from", text, dimension::time, "a time, such as '120 ms'"); });
  };
  EXPECT_DOUBLE_EQ(parse_option("--from", "120 ms", dimension::time, "a time"), 0.12);
  EXPECT_EQ(refused("85"), "--from \"85\" (a unit is missing, e.g. \"33 um\") (must be a time, such as '120 ms')");
  EXPECT_EQ(refused("85 mm"), "--from 85 mm (must be a time, such as '120 ms')");
}

}  // namespace
}  // namespace clogflow
