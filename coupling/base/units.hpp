// Quantities as text with a unit ("33 um", "1.8e-3 Pa s") to SI numbers and back.
#pragma once

#include <string>
#include <string_view>

namespace clogflow {

/// Powers of the SI base units metre, kilogram, second; an angle is dimensionless.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimension {
inline constexpr Dimension number{};
inline constexpr Dimension length{1, 0, 0};
inline constexpr Dimension area{2, 0, 0};
inline constexpr Dimension time{0, 0, 1};
inline constexpr Dimension rate{0, 0, -1};
inline constexpr Dimension velocity{1, 0, -1};
inline constexpr Dimension acceleration{1, 0, -2};
inline constexpr Dimension density{-3, 1, 0};
inline constexpr Dimension pressure{-1, 1, -2};
inline constexpr Dimension viscosity{-1, 1, -1};
inline constexpr Dimension force{1, 1, -2};
inline constexpr Dimension flow_rate{3, 0, -1};
inline constexpr Dimension compliance{4, -1, 2};
inline constexpr Dimension stiffness{0, 1, -2};  // and energy per area
}  // namespace dimension

/// A number of SI units with the kind of quantity it is.
struct Quantity {
  double si;  ///< value [SI unit of the dimension; rad for angles]
  Dimension dimension;
  bool is_angle;  ///< written with "deg" or "rad", which have no dimension
};

/// Reads "number unit", the unit a product of known symbols with integer powers and at most one
/// division ("kg/m3", "mPa s", "m/s^2").
/// \throws Error naming the text and the symbol that is unknown, or that a unit is missing
Quantity parse_quantity(std::string_view text);

/// What an option of a command line was given, "--from" for example.
/// \param meaning  what it must be, for the message: "a time, such as '120 ms'"
/// \return [SI unit of the dimension]
/// \throws Error naming the option if the text is no quantity, or none of this dimension
double parse_option(std::string_view option, std::string_view text, Dimension dimension, std::string_view meaning);

/// The SI unit of a dimension in words a file can carry: "m", "Pa s", "kg/m3", "1" for a number.
std::string si_unit(Dimension dimension);

/// "a length" and an example "33 um": how messages name a kind of quantity.
struct QuantityWords {
  std::string name;
  std::string example;
};
QuantityWords quantity_words(Dimension dimension);

/// Shortest text in SI units that parse_quantity reads back to the same bits: "3.3e-05 m". Effective
/// scenes are written so, and what is named by them does not depend on what is pleasant to read.
std::string si_quantity(double si, Dimension dimension);

/// The same digits for the eye, with a decimal prefix where one fits: "33 um"; read back to the same
/// bits too.
std::string format_quantity(double si, Dimension dimension);

/// "60 deg" where that is read back to the same bits, otherwise radians. \param radians finite
std::string format_angle(double radians);

}  // namespace clogflow
