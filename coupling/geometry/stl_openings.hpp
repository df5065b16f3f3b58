// Which facets of a channel's STL file are its inlet, its outlet and its walls.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/geometry/stl.hpp"

namespace clogflow {

enum class ChannelPart : std::uint8_t { wall, inlet, outlet };

struct ChannelFacets {
  Walls all;                      ///< in the order of the file [m]
  std::vector<ChannelPart> part;  ///< of each
};

/// Lengths closer than this share of the channel's length are the same: files hold few digits.
constexpr double same_length = 1e-5;

/// Parts are told by their whole names, "inlet" and "outlet", all others are walls. A file of one
/// part (a binary file has no more) has its openings in the planes of its smallest and largest x.
/// \param file  for messages
/// \throws Error naming the file's parts if an opening is missing, or a name is nearly that of one
ChannelFacets channel_facets(std::vector<StlSolid> solids, double unit, const std::string& file);

}  // namespace clogflow
