"""The arch of a clog in a snapshot, as the program finds it (dem/run/arch.hpp): the particles that bear the load at the neck."""

import numpy as np

from run_file import WALL

NEAR = 6  # diameters upstream of the front: where contacts are looked for [1]


def distance_to_lines(points, corners):
    """Of points [n][2] to the nearest of the segments between corners [k][2]."""
    start, along = corners[:-1], np.diff(corners, axis=0)
    share = np.einsum("nkd,kd->nk", points[:, None] - start, along) / np.maximum(np.sum(along**2, axis=1), 1e-300)
    nearest = start + share.clip(0, 1)[..., None] * along
    return np.linalg.norm(points[:, None] - nearest, axis=2).min(axis=1)


def wall_contacts(position, radius, geometry):
    """How many walls each sphere overlaps: sides given by keys, floor and ceiling."""
    count = np.zeros(len(radius), dtype=int)
    for side in ("upper", "lower"):
        count += distance_to_lines(position[:, :2], np.array(geometry[side])) < radius
    if geometry["neck_height"] > 0:
        count += position[:, 2] < radius
        count += position[:, 2] > geometry["neck_height"] - radius
    return count


def contact_counts(snapshot, near, geometry):
    """Of all particles: those recorded, or the overlaps of spheres and walls among those that are near; None where neither is known."""
    count = np.zeros(len(snapshot.radius), dtype=int)
    if snapshot.contacts:
        np.add.at(count, snapshot.contacts.a, 1)
        np.add.at(count, snapshot.contacts.b[snapshot.contacts.b != WALL], 1)
        return count
    if "upper" not in geometry:
        return None
    position, radius = snapshot.position[near], snapshot.radius[near]
    apart = np.linalg.norm(position[:, None] - position, axis=2)
    pairs = apart < radius[:, None] + radius
    count[near] = pairs.sum(axis=1) - 1 + wall_contacts(position, radius, geometry)
    return count


def arch_of(snapshot, geometry):
    """Rows of the particles that at least two contacts press on, upstream of the passage plane and within one diameter of
    the one that is farthest downstream; none where contacts are not known."""
    x, diameter = snapshot.position[:, 0], 2 * snapshot.radius
    upstream = x < geometry["passage_plane"]
    if not upstream.any():
        return np.zeros(0, dtype=int)
    near = np.flatnonzero(x > x[upstream].max() - NEAR * diameter.max())
    count = contact_counts(snapshot, near, geometry)
    if count is None:
        return np.zeros(0, dtype=int)
    bearing = upstream & (count >= 2)
    if not bearing.any():
        return np.zeros(0, dtype=int)
    return np.flatnonzero(bearing & (x >= x[bearing].max() - diameter))
