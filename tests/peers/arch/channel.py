"""The channel of a scene around a clog, in neck widths: box of the mesh, slopes as triangles, cross-section."""

import math
from dataclasses import dataclass

import numpy as np

FAR = 0.5  # the wedges that cut the box reach so far beyond it


@dataclass(frozen=True)
class Channel:
    """Of the straight neck only what the mesh covers. The neck begins at x = 0; y across from the middle, z from 0."""

    width: float  # of the wide part
    height: float
    slope: float  # from the axis [rad]
    start: float  # x of the mesh's inlet, < -narrowing
    end: float  # x of its outlet

    @property
    def narrowing(self):
        return (self.width - 1) / 2 / math.tan(self.slope)

    def half_width(self, x):
        """Half of the y extent at x, any shape."""
        return np.clip(0.5 - np.asarray(x, float) * math.tan(self.slope), 0.5, self.width / 2)

    def area(self, x):
        return 2 * self.half_width(x) * self.height

    def wedges(self):
        """Triangles [n, 3, 3] of the two solid bodies beside narrowing and neck; they close outside of the box."""
        lean, top, far = FAR / math.tan(self.slope), self.width / 2 + FAR, self.end + FAR
        outline = np.array([(-self.narrowing - lean, top), (0, 0.5), (far, 0.5), (far, top)])
        triangles = []
        for side in (1, -1):
            low = np.column_stack([outline[:, 0], side * outline[:, 1], np.full(4, -FAR)])
            high = low + [0, 0, self.height + 2 * FAR]
            for k in range(4):
                a, b = k, (k + 1) % 4
                triangles += [(low[a], low[b], high[b]), (low[a], high[b], high[a])]
            for face in (low, high):
                triangles += [(face[0], face[1], face[2]), (face[0], face[2], face[3])]
        return np.array(triangles)


def stl_text(triangles, name):
    lines = [f"solid {name}"]
    for corners in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(f"{c:.12g}" for c in corner) for corner in corners]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + [f"endsolid {name}"]) + "\n"
