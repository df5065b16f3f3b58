"""Forces of the resolved flow beside those of a law."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Comparison:
    """Of vectors R (resolved) and L (law), a row a sphere.

    ratio      sum of R.L over sum of L.L: the factor on the law that leaves the least squares
    total      sum of R along x over that of L
    along      standard deviation of (R - ratio L).l / (ratio |L|), l the direction of L
    across     root mean square of each of the two components across l, likewise
    strength   root mean square of all three components: what drag.fluctuation.strength multiplies
    size       standard deviation of |R| / |L| over its mean
    angle      median angle between R and L [rad]
    """

    ratio: float
    total: float
    along: float
    across: float
    strength: float
    size: float
    angle: float
    count: int


def compare(resolved, law):
    size = np.linalg.norm(law, axis=1)
    unit = law / size[:, None]
    ratio = np.sum(resolved * law) / np.sum(law * law)
    rest = (resolved - ratio * law) / (ratio * size)[:, None]
    along = np.sum(rest * unit, axis=1)
    square = np.sum(rest * rest, axis=1)
    length = np.linalg.norm(resolved, axis=1)
    angle = np.arccos(np.clip(np.sum(resolved * unit, axis=1) / length, -1, 1))
    return Comparison(ratio=float(ratio), total=float(resolved[:, 0].sum() / law[:, 0].sum()),
                      along=float(np.std(along)), across=float(np.sqrt(np.mean(square - along**2) / 2)),
                      strength=float(np.sqrt(np.mean(square) / 3)),
                      size=float(np.std(length / size) / np.mean(length / size)),
                      angle=float(np.median(angle)), count=len(law))


def apart(one, other):
    """Root mean square of the difference of two sets of vectors over that of the second: between meshes."""
    return float(np.sqrt(np.sum((one - other) ** 2) / np.sum(other**2)))


def at_no_size(values, cells):
    """Of the two finest meshes, values at cells of no size: the error falls with the square of their edge, as that of the
    lattices does. values: arrays alike, cells: of a length, likewise many."""
    (coarse, few), (fine, many) = sorted(zip(values, cells), key=lambda pair: pair[1])[-2:]
    return fine + (fine - coarse) / ((many / few) ** 2 - 1)


def at_no_shrinkage(values, shares):
    """A straight line through values (numbers) at shares, read at 0."""
    return float(np.polyfit(shares, values, 1)[1])
