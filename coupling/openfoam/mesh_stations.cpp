#include "coupling/openfoam/mesh_stations.hpp"

#include <algorithm>
#include <cmath>

namespace clogflow {
namespace {

// The neck's entrance flow develops within about one neck height at Reynolds numbers of order one.
constexpr double neck_continuation = 0.5;

// Walls whose corners need curves farther apart than this, in distances from the axis, get a curve
// each.
constexpr double common_curve = 0.35;

// Last cell over first from the axis to the wall.
constexpr double grade_inlet = 0.3, grade_corner = 0.25, grade_middle = 0.6, grade_outlet = 0.7;

// A corner of one side wall, and the curve from it to the axis that halves the angle there.
struct Corner {
  const WallPiece *before, *after;
  Vec2 at() const { return after->from; }
  double angle_before() const { return before->angle_at(at()); }
  double angle_after() const { return after->angle_at(at()); }
  bool edge() const { return angle_after() > angle_before() + 1e-9; }
  bool bend() const { return angle_after() < angle_before() - 1e-9; }
  /// x where the curve meets the axis at a right angle
  double axis() const { return at().x() + at().y() * std::tan((angle_before() + angle_after()) / 4); }
};

std::vector<Corner> corners(const ChannelSide& side) {
  std::vector<Corner> result;
  for (std::size_t i = 0; i + 1 < side.pieces.size(); ++i) result.push_back({&side.pieces[i], &side.pieces[i + 1]});
  return result;
}

// Middle of the arc around a point of the axis from (axis, 0) to the wall; none when it is
// straight.
std::optional<Vec2> arc_middle(double axis, const Vec2& wall) {
  const double s = wall.x() - axis, y = wall.y();
  if (std::abs(s) < 1e-6 * y) return std::nullopt;
  const double radius = (s * s + y * y) / (2 * s);
  const double half = std::atan2(y / radius, (radius - s) / radius) / 2;
  return Vec2(axis + radius - radius * std::cos(half), radius * std::sin(half));
}

// Where a curve that starts from the axis at a right angle meets a slanted wall at a right angle.
Vec2 foot_on_slope(const WallPiece& wall, double axis) {
  const double slope = -wall.angle_at(wall.from);
  const double meets_axis = wall.from.x() + wall.from.y() / std::tan(slope);
  const double radius = meets_axis - axis;
  return {meets_axis - radius * std::cos(slope), radius * std::sin(slope)};
}

class Builder {
public:
  Builder(const Scene& scene, const ChannelShape& shape)
      : g_(scene.geometry),
        shape_(shape),
        straight_part_(solved_length(scene.geometry)),
        cell_(scene.geometry.neck_width / scene.flow.mesh_cells_per_neck),
        spacing_(scene.flow.grid_spacing) {
    sides_ = {&shape.upper};
    if (!shape.symmetric) sides_.push_back(&shape.lower);
  }

  std::vector<MeshStation> stations() {
    add_narrowing();
    add_inlet();
    add_neck();
    if (g_.expansion_width > 0) add_expansion();
    return std::move(stations_);
  }

private:
  // Cell sizes along the wall: nearly square at an edge, about as long as wide at a bend. The
  // ratios are those that gave the smallest error for a 60 degree narrowing from 4 to 1.
  MeshFoot foot(const Corner& corner) const {
    const double width = 2 * corner.at().y();
    MeshFoot foot{corner.at(), {}, 0, 0};
    if (corner.bend()) {
      const bool narrows = std::abs(corner.angle_after()) > std::abs(corner.angle_before());
      const double slope = (narrows ? corner.after : corner.before)->length();
      const double size = std::clamp(1.4 * width * cell_ / g_.neck_width, slope / 16, slope / 4);
      foot.before = narrows ? size / 2 : size;
      foot.after = narrows ? size : size / 2;
    } else if (corner.edge()) {
      foot.before = foot.after = 0.45 * cell_ * width / g_.neck_width;
    } else {
      const double arc = (corner.after->is_arc() ? corner.after : corner.before)->length();
      foot.before = foot.after = std::clamp(arc / 6, 0.45 * cell_, cell_);
    }
    return foot;
  }

  MeshStation station(const char* name, double axis, double grading) const {
    return {.name = name, .axis = axis, .edge = false, .grading = grading, .foot = {}};
  }

  // A straight curve where all walls have the same distance.
  MeshStation straight(const char* name, double x, double grading, double before, double after) const {
    MeshStation result = station(name, x, grading);
    for (const ChannelSide* side : sides_) result.foot.push_back({{x, side->distance(x)}, {}, before, after});
    return result;
  }

  void add_corner(const char* name, std::size_t number) {
    double axis = 0;
    for (const ChannelSide* side : sides_) axis += corners(*side)[number].axis() / static_cast<double>(sides_.size());
    MeshStation result = station(name, axis, grade_corner);
    for (const ChannelSide* side : sides_) {
      const Corner corner = corners(*side)[number];
      result.edge = corner.edge();
      result.foot.push_back(foot(corner));
      result.foot.back().middle = arc_middle(axis, corner.at());
    }
    stations_.push_back(result);
  }

  // Of walls that narrow from different places on, each gets its own curve.
  void add_wide_corners() {
    const Corner above = corners(shape_.upper).front(), below = corners(shape_.lower).front();
    if (std::abs(above.axis() - below.axis()) < common_curve * above.at().y()) return add_corner("wideCorner", 0);
    const bool above_first = above.axis() < below.axis();
    for (const bool upper : {above_first, !above_first}) {
      const Corner &corner = upper ? above : below, &other = upper ? below : above;
      MeshStation result = station(upper ? "wideCornerAbove" : "wideCornerBelow", corner.axis(), grade_corner);
      // The other wall is still straight at the first curve, and slanted already at the second.
      const Vec2 across =
          upper == above_first ? Vec2(result.axis, other.at().y()) : foot_on_slope(*other.after, result.axis);
      const MeshFoot own = foot(corner);
      for (const bool here : {upper, !upper}) {
        const Vec2 wall = here ? corner.at() : across;
        result.foot.push_back({wall, arc_middle(result.axis, wall), own.before, own.after});
      }
      stations_.push_back(result);
    }
  }

  void add_narrowing() {
    if (g_.channel_width <= g_.neck_width) return;
    add_wide_corners();
    std::size_t next = 1;
    if (g_.step_width > 0) {
      add_corner("stepEdge", next++);
      add_corner("stepCorner", next++);
    }
    if (g_.neck_rounding > 0) add_corner("roundingStart", next++);
    add_corner(g_.neck_rounding > 0 ? "roundingEnd" : "neckEdge", next);
  }

  void add_inlet() {
    double begin = 0, before = 3 * cell_;
    if (!stations_.empty()) {
      begin = stations_.front().foot.front().wall.x();
      for (const MeshFoot& foot : stations_.front().foot) begin = std::min(begin, foot.wall.x());
      before = stations_.front().foot.front().before;
    }
    const double size = std::max(0.13 * straight_part_, before);
    stations_.insert(stations_.begin(), straight("inlet", begin - straight_part_, grade_inlet, size, size));
  }

  void add_neck() {
    const double begin = stations_.size() == 1 ? 0 : stations_.back().foot.front().wall.x();
    const double side = std::max(g_.neck_width, g_.neck_height);
    double entrance = g_.neck_width / 2;
    if (g_.expansion_width > 0) entrance = std::min(entrance, (g_.neck_length - begin) / 2);
    const double size = std::min(2.4 * cell_, entrance / 3);
    stations_.push_back(straight("neckMiddle", begin + entrance, grade_middle, size, 3 * cell_));
    if (g_.expansion_width > 0) return;
    stations_.push_back(straight("outlet", std::max(g_.neck_length, begin + side) + neck_continuation * side,
                                 grade_outlet, 3 * cell_, 3 * cell_));
  }

  void add_expansion() {
    const std::size_t count = corners(shape_.upper).size();
    add_corner("neckEnd", count - 2);
    add_corner("expansionCorner", count - 1);
    const MeshFoot corner = stations_.back().foot.front();
    // The grid's last plane lies up to a spacing behind the end.
    const double length =
        std::max(g_.expansion_length + spacing_, development_widths * std::max(g_.expansion_width, g_.neck_height));
    const double size = std::max(0.13 * length, corner.after);
    stations_.push_back(straight("outlet", corner.wall.x() + length, grade_inlet, size, size));
  }

  decltype(Scene::geometry) g_;
  const ChannelShape& shape_;
  double straight_part_, cell_, spacing_;
  std::vector<const ChannelSide*> sides_;
  std::vector<MeshStation> stations_;
};

}  // namespace

std::vector<MeshStation> mesh_stations(const Scene& scene, const ChannelShape& shape) {
  return Builder(scene, shape).stations();
}

}  // namespace clogflow
