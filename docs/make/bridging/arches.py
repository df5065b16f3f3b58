"""How many particles hold a clog: four counts of the same contact network, for each clog that was proved."""

import sys
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "postprocess" / "figures"))
from arch import arch_of  # noqa: E402  (found through the line above)
from run_file import WALL, read_snapshots  # noqa: E402

LEAST_FORCE = 0.01  # of the largest normal force near the neck: weaker contacts bear nothing
FLAT = 0.5  # |z| of a wall's normal above which it is floor or ceiling
AT_REST = 0.01  # of the mean velocity: the fastest particle within a neck width before the passage plane
CHAIN_REACH = 3  # neck widths upstream of the neck's entrance


def clog_snapshots(path, geometry):
    """The last snapshot before each time that the column was put back, where nothing passed since and it is at rest."""
    with h5py.File(path) as file:
        if "contacts" not in file:
            return []
        times, off, passages = file["snapshots/time"][:], file["releases/off"][:], file["passages/time"][:]
    last_passage = np.concatenate([[-np.inf], passages])[np.searchsorted(passages, off)]
    places = np.searchsorted(times, off) - 1
    return [s for s in read_snapshots(path, places[(places >= 0) & (times[places] > last_passage)]) if rests(s, geometry)]


def rests(snapshot, geometry):
    x = snapshot.position[:, 0]
    near = (x > -geometry["neck_width"]) & (x < geometry["passage_plane"])
    return near.any() and snapshot.speed[near].max() < AT_REST * geometry["mean_velocity"]


def layer(snapshot, geometry):
    """The arch of the program (dem/run/arch): two contacts or more, within a diameter of the foremost such particle."""
    x = snapshot.position[:, 0]
    bearing = (contact_counts(snapshot) >= 2) & (x < geometry["passage_plane"])
    return int(np.sum(bearing & (x > x[bearing].max() - 2 * snapshot.radius[0]))) if bearing.any() else 0


def contact_counts(snapshot):
    count = np.zeros(len(snapshot.radius), dtype=int)
    np.add.at(count, snapshot.contacts.a, 1)
    np.add.at(count, snapshot.contacts.b[snapshot.contacts.b != WALL], 1)
    return count


def chain(snapshot, geometry):
    """Particles of the shortest chain of contacts that bear load, from one side wall to the other; 0 if there is none."""
    c, x = snapshot.contacts, snapshot.position[:, 0]
    near = x > -CHAIN_REACH * geometry["neck_width"]
    pressing = near[c.a] & (c.b == WALL) | near[c.a] & near[np.maximum(c.b, 0)] & (c.b != WALL)
    if not pressing.any():
        return 0
    pressing &= c.force > LEAST_FORCE * c.force[pressing].max()
    side = pressing & (c.b == WALL) & (np.abs(c.normal[:, 2]) < FLAT)
    upper, lower = set(c.a[side & (c.normal[:, 1] < 0)]), set(c.a[side & (c.normal[:, 1] > 0)])
    others = {}
    for a, b in zip(c.a[pressing & (c.b != WALL)], c.b[pressing & (c.b != WALL)]):
        others.setdefault(a, []).append(b)
        others.setdefault(b, []).append(a)
    front, seen, length = upper, set(upper), 1
    while front:
        if front & lower:
            return length
        front = {b for a in front for b in others.get(a, ())} - seen
        seen |= front
        length += 1
    return 0


def counts_of(path, geometry):
    """A row for each clog of a run: seen from the outlet, those of them that are centred before the opening, foremost layer,
    shortest chain."""
    rows = []
    for snapshot in clog_snapshots(path, geometry):
        seen = arch_of(snapshot, geometry)
        centred = np.abs(snapshot.position[seen, 1]) < geometry["neck_width"] / 2
        rows.append((len(seen), int(centred.sum()), layer(snapshot, geometry), chain(snapshot, geometry)))
    return rows
