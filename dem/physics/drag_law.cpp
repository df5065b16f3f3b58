// The registry of drag laws: the one place, besides a law's own file, that knows it.
#include "dem/physics/drag_law.hpp"

#include <array>

#include "coupling/base/require.hpp"
#include "dem/physics/drag_laws/beetstra.hpp"
#include "dem/physics/drag_laws/hoef.hpp"
#include "dem/physics/drag_laws/stokes.hpp"

namespace clogflow {

namespace {

template <class... Laws>
constexpr std::array<DragLaw, sizeof...(Laws)> make_rows() {
  return {DragLaw{Laws::word, Laws::knows_slip, Laws::of_packs, Laws::factor}...};
}

constexpr auto drag_law_rows = make_rows<HoefDrag, StokesDrag, BeetstraDrag>();

}  // namespace

const DragLaw& find_drag_law(std::string_view word) {
  for (const DragLaw& row : drag_law_rows)
    if (row.word == word) return row;
  throw Error(fmt::format("drag.law = \"{}\" has no row in the registry", word));
}

}  // namespace clogflow
