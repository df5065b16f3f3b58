"""The arch of a clog in a snapshot as a viewer sees it: the particles that bear load and close the neck, however deep they stand.
A poke takes out another set, what bears load within one diameter of the foremost (dem/run/arch.hpp)."""

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
    """Of each particle: those recorded, or the overlaps of spheres and walls among those that are near."""
    count = np.zeros(len(snapshot.radius), dtype=int)
    if snapshot.contacts:
        np.add.at(count, snapshot.contacts.a, 1)
        np.add.at(count, snapshot.contacts.b[snapshot.contacts.b != WALL], 1)
        return count
    position, radius = snapshot.position[near], snapshot.radius[near]
    apart = np.linalg.norm(position[:, None] - position, axis=2)
    pairs = apart < radius[:, None] + radius
    count[near] = pairs.sum(axis=1) - 1 + wall_contacts(position, radius, geometry)
    return count


def seen_from_outlet(position, radius, x_of_others, lateral_of_others):
    """Whether no other particle stands downstream of a centre, in front of it."""
    in_front = (x_of_others > position[:, :1]) & (np.linalg.norm(position[:, None, 1:] - lateral_of_others, axis=2) < radius[:, None])
    return ~in_front.any(axis=1)


def arch_of(snapshot, geometry):
    """Rows of the particles that close the neck: at least two contacts press on them, their centres lie before the opening or
    within half a radius of it, and nothing stands before them upstream of the passage plane. Of channels with one neck in the
    middle, given by keys; none elsewhere."""
    position, radius = snapshot.position, snapshot.radius
    upstream = np.flatnonzero(position[:, 0] < geometry["passage_plane"])
    if "upper" not in geometry or not len(upstream):
        return np.zeros(0, dtype=int)
    near = upstream[position[upstream, 0] > position[upstream, 0].max() - NEAR * 2 * radius.max()]
    count = contact_counts(snapshot, near, geometry)
    before = near[(count[near] >= 2) & (np.abs(position[near, 1]) < geometry["neck_width"] / 2 + radius[near] / 2)]
    return before[seen_from_outlet(position[before], radius[before], position[near, 0], position[near, 1:])]
