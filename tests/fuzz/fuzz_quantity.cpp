// Quantities: finite, and printed text reads back to the same bits.
#include <cmath>

#include "coupling/units.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clog::fuzz::try_input([&] {
    const clog::Quantity quantity = clog::parse_quantity(clog::fuzz::as_text(data, size));
    clog::fuzz::must(std::isfinite(quantity.si), "a quantity is finite");
    if (quantity.is_angle || quantity.dimension == clog::dimension::number) return;
    const clog::Quantity again = clog::parse_quantity(clog::format_quantity(quantity.si, quantity.dimension));
    clog::fuzz::must(again.si == quantity.si && again.dimension == quantity.dimension, "a printed quantity reads back the same");
  });
}
