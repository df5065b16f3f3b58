"""Outline of the channel in the x-y plane, from the geometry of the statistics."""

import numpy as np
from matplotlib.patches import PathPatch, Polygon
from matplotlib.path import Path

import style
from lengths import unit_of_scene

MARGIN = 1.06  # of wall beside the fluid


def draw_sides(axes, geometry, scale):
    """Two sides without an obstacle between them: a shape given by keys."""
    sides = [[(x * scale, y * scale) for x, y in geometry[side]] for side in ("upper", "lower")]
    outer = max(abs(y) for side in sides for _, y in side) * MARGIN
    for sign, side in zip((1, -1), sides):
        body = side + [(side[-1][0], sign * outer), (side[0][0], sign * outer)]
        axes.add_patch(Polygon(body, closed=True, facecolor=style.WALL, edgecolor="none", zorder=0))
        axes.plot([x for x, _ in side], [y for _, y in side], color=style.INK, lw=0.9, zorder=3)
    return sides[0][0][0], sides[0][-1][0], -outer, outer


def draw_fluid(axes, loops, scale):
    """The cut of an STL channel half way up, closed lines around the fluid and around obstacles in it."""
    loops = [np.array(loop) * scale for loop in loops]
    corners = np.concatenate(loops)
    (left, low), (right, high) = corners.min(axis=0), corners.max(axis=0)
    beside = (MARGIN - 1) / 2 * (high - low)
    low, high = low - beside, high + beside
    frame = np.array([(left, low), (right, low), (right, high), (left, high)])
    # The fluid's lines run counter-clockwise and the frame clockwise, so what lies between is filled.
    lines = [frame[::-1]] + loops
    vertices = np.concatenate([np.vstack([line, line[:1]]) for line in lines])
    codes = np.concatenate([[Path.MOVETO] + [Path.LINETO] * (len(line) - 1) + [Path.CLOSEPOLY] for line in lines])
    axes.add_patch(PathPatch(Path(vertices, codes), facecolor=style.WALL, edgecolor="none", zorder=0))
    for loop in loops:
        for a, b in zip(loop, np.roll(loop, -1, axis=0)):
            if a[0] != b[0] or left < a[0] < right:  # inlet and outlet are open
                axes.plot([a[0], b[0]], [a[1], b[1]], color=style.INK, lw=0.9, zorder=3)
    return left, right, low, high


def draw(axes, geometry):
    """Walls as solid bodies, axes in unit_of_scene(); shows seven neck widths before the constriction."""
    scale = unit_of_scene(geometry).per_metre
    fluid = geometry.get("fluid")
    left, right, low, high = draw_fluid(axes, fluid, scale) if fluid else draw_sides(axes, geometry, scale)
    axes.set_xlim(max(left, -7.0 * geometry["neck_width"] * scale), right)
    axes.set_ylim(low, high)
    axes.set_aspect("equal")
