#include "coupling/geometry/stl_openings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "coupling/base/require.hpp"

namespace clogflow {
namespace {

// The letters of a name, in lower case: "Inlet_1" says "inlet".
std::string letters(const std::string& name) {
  std::string result;
  for (const char c : name)
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) result += static_cast<char>(c | 0x20);
  return result;
}

// At most one letter is missing, too many, or another, or two neighbours are exchanged.
bool nearly(const std::string& a, const std::string& b) {
  if (a.size() > b.size()) return nearly(b, a);
  const std::size_t front = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
  if (front == a.size()) return b.size() <= a.size() + 1;
  if (a.size() < b.size()) return b.size() == a.size() + 1 && a.substr(front) == b.substr(front + 1);
  if (a.substr(front + 1) == b.substr(front + 1)) return true;
  return front + 1 < a.size() && a[front] == b[front + 1] && a[front + 1] == b[front] &&
         a.substr(front + 2) == b.substr(front + 2);
}

void refuse_near_miss(const std::string& name, const std::string& file) {
  for (const char* opening : {"inlet", "outlet"})
    require(name == opening || !nearly(letters(name), opening),
            "{}: a part is named \"{}\" (the opening must be named {}, whole and in this spelling; "
            "a wall must not be taken "
            "for it): name it otherwise",
            file, name, opening);
}

ChannelPart part_of(const std::string& name) {
  return name == "inlet" ? ChannelPart::inlet : name == "outlet" ? ChannelPart::outlet : ChannelPart::wall;
}

std::string names_of(const std::vector<StlSolid>& solids) {
  std::string names;
  for (const StlSolid& solid : solids)
    names += (names.empty() ? "" : ", ") + (solid.name.empty() ? "one without a name" : "\"" + solid.name + "\"");
  return names;
}

void find_openings(ChannelFacets& facets) {
  double low = 1e300, high = -1e300;
  for (const Triangle& t : facets.all)
    for (const Vec3& corner : t.corner) low = std::min(low, corner.x), high = std::max(high, corner.x);
  const double tolerance = same_length * (high - low);
  const auto lies_at = [&](const Triangle& t, double x) {
    return std::ranges::all_of(t.corner, [&](const Vec3& corner) { return std::abs(corner.x - x) < tolerance; });
  };
  for (std::size_t k = 0; k < facets.all.size(); ++k)
    facets.part[k] = lies_at(facets.all[k], low)    ? ChannelPart::inlet
                     : lies_at(facets.all[k], high) ? ChannelPart::outlet
                                                    : ChannelPart::wall;
}

void require_all(const ChannelFacets& facets, const std::string& names, const std::string& file) {
  for (const auto& [part, name, x] :
       {std::tuple(ChannelPart::inlet, "inlet", "smallest"), {ChannelPart::outlet, "outlet", "largest"}}) {
    const bool there = std::ranges::find(facets.part, part) != facets.part.end();
    require(there || !names.empty(),
            "{}: is one part and has no facet in the plane of its {} x, where the {} would be: "
            "close it",
            file, x, name);
    require(there,
            "{}: holds no part named {} (its parts: {}); write \"solid {}\" before those facets, "
            "in a text file",
            file, name, names, name);
  }
  require(std::ranges::find(facets.part, ChannelPart::wall) != facets.part.end(),
          "{}: holds an inlet and an outlet, but no wall", file);
}

}  // namespace

ChannelFacets channel_facets(std::vector<StlSolid> solids, double unit, const std::string& file) {
  std::erase_if(solids, [](const StlSolid& solid) { return solid.triangles.empty(); });
  const bool one = solids.size() == 1;
  const std::string names = one ? "" : names_of(solids);
  ChannelFacets facets;
  for (StlSolid& solid : solids) {
    if (!one) refuse_near_miss(solid.name, file);
    facets.part.insert(facets.part.end(), solid.triangles.size(), part_of(solid.name));
    if (facets.all.empty())
      facets.all = std::move(solid.triangles);
    else
      facets.all.insert(facets.all.end(), solid.triangles.begin(), solid.triangles.end());
  }
  for (Triangle& t : facets.all)
    for (Vec3& corner : t.corner) corner *= unit;
  if (one) find_openings(facets);
  require_all(facets, names, file);
  return facets;
}

}  // namespace clogflow
