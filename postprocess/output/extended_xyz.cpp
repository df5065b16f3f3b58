#include "postprocess/output/extended_xyz.hpp"

#include <array>
#include <iterator>

#include <fmt/format.h>

#include "coupling/scene/scene.hpp"

namespace clogflow::postprocess {
namespace {

/// By atomic number: readers such as ASE take no other words for a species. As many as a scene may have.
constexpr std::array<const char*, most_species> symbols{
    "H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si", "P",  "S",  "Cl",
    "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge", "As", "Se",
    "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb",
    "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er",
    "Tm", "Yb", "Lu", "Hf", "Ta", "W",  "Re", "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At",
    "Rn", "Fr", "Ra", "Ac", "Th", "Pa", "U",  "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm"};

}  // namespace

std::string extended_xyz(const RunData::Snapshot& snapshot, const Box& box) {
  const Vec3 size = box.high - box.low;
  std::string text = fmt::format(
      "{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"F F F\" Time={} units=\"SI: m s N rad\" "
      "Properties=species:S:1:pos:R:3:id:I:1:radius:R:1:velo:R:3:omega:R:3:force:R:3:torque:R:3\n",
      snapshot.id.size(), size.x, size.y, size.z, box.low.x, box.low.y, box.low.z, snapshot.time);
  auto out = std::back_inserter(text);
  const auto vector = [&](const std::vector<double>& values, std::size_t i) {
    fmt::format_to(out, " {} {} {}", values[3 * i], values[3 * i + 1], values[3 * i + 2]);
  };
  for (std::size_t i = 0; i < snapshot.id.size(); ++i) {
    fmt::format_to(out, "{}", symbols.at(snapshot.species.empty() ? 0 : static_cast<std::size_t>(snapshot.species[i])));
    vector(snapshot.position, i);
    fmt::format_to(out, " {} {}", snapshot.id[i], snapshot.radius[i]);
    for (const auto* values : {&snapshot.velocity, &snapshot.spin, &snapshot.force, &snapshot.torque})
      vector(*values, i);
    text += '\n';
  }
  return text;
}

}  // namespace clogflow::postprocess
