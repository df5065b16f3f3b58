"""Outline of the constricted channel in the x-y plane, from the geometry of the scene."""

import math

from matplotlib.patches import Polygon

import style

UM = 1e6


def corners(geometry):
    """Upper wall from the inlet to the outlet as (x, y) [m]; the lower one is its mirror image."""
    half_neck = geometry["neck_width"] / 2
    half_channel = geometry["channel_width"] / 2
    narrowing = (half_channel - half_neck) / math.tan(geometry["half_angle"])
    return [(-narrowing - geometry["channel_length"], half_channel), (-narrowing, half_channel),
            (0.0, half_neck), (geometry["neck_length"], half_neck)]


def draw(axes, geometry):
    """Walls as solid bodies, axes in micrometres; shows seven neck widths before the constriction."""
    upper = [(x * UM, y * UM) for x, y in corners(geometry)]
    outer = geometry["channel_width"] / 2 * UM * 1.06
    for sign in (1, -1):
        body = [(x, sign * y) for x, y in upper] + [(upper[-1][0], sign * outer), (upper[0][0], sign * outer)]
        axes.add_patch(Polygon(body, closed=True, facecolor=style.WALL, edgecolor="none", zorder=0))
        axes.plot([x for x, _ in upper], [sign * y for _, y in upper], color=style.INK, lw=0.9, zorder=3)
    left = max(upper[0][0], -7.0 * geometry["neck_width"] * UM)
    axes.set_xlim(left, upper[-1][0])
    axes.set_ylim(-outer, outer)
    axes.set_aspect("equal")
