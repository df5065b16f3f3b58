"""Outline of the channel in the x-y plane, from the geometry of the statistics."""

from matplotlib.patches import Polygon

import style

UM = 1e6


def draw(axes, geometry):
    """Walls as solid bodies, axes in micrometres; shows seven neck widths before the constriction."""
    sides = [[(x * UM, y * UM) for x, y in geometry[side]] for side in ("upper", "lower")]
    outer = max(abs(y) for side in sides for _, y in side) * 1.06
    for sign, side in zip((1, -1), sides):
        body = side + [(side[-1][0], sign * outer), (side[0][0], sign * outer)]
        axes.add_patch(Polygon(body, closed=True, facecolor=style.WALL, edgecolor="none", zorder=0))
        axes.plot([x for x, _ in side], [y for _, y in side], color=style.INK, lw=0.9, zorder=3)
    left = max(sides[0][0][0], -7.0 * geometry["neck_width"] * UM)
    axes.set_xlim(left, sides[0][-1][0])
    axes.set_ylim(-outer, outer)
    axes.set_aspect("equal")
