#include "postprocess/output/extended_xyz.hpp"

#include <iterator>

#include <fmt/format.h>

namespace clogflow::postprocess {

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
    fmt::format_to(out, "{}", snapshot.species.empty() ? 1 : snapshot.species[i] + 1);
    vector(snapshot.position, i);
    fmt::format_to(out, " {} {}", snapshot.id[i], snapshot.radius[i]);
    for (const auto* values : {&snapshot.velocity, &snapshot.spin, &snapshot.force, &snapshot.torque})
      vector(*values, i);
    text += '\n';
  }
  return text;
}

}  // namespace clogflow::postprocess
