// Quantities: finite, and printed text reads back to the same bits.
#include <cmath>

#include "coupling/base/units.hpp"
#include "tests/fuzz/one_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return clogflow::fuzz::try_input([&] {
    const clogflow::Quantity quantity = clogflow::parse_quantity(clogflow::fuzz::as_text(data, size));
    clogflow::fuzz::must(std::isfinite(quantity.si), "a quantity is finite");
    if (quantity.is_angle || quantity.dimension == clogflow::dimension::number) return;
    const clogflow::Quantity again =
        clogflow::parse_quantity(clogflow::format_quantity(quantity.si, quantity.dimension));
    clogflow::fuzz::must(again.si == quantity.si && again.dimension == quantity.dimension,
                         "a printed quantity reads back the same");
  });
}
