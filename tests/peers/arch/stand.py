"""Does the arch stand under other forces? A run that begins with its spheres where they are, at rest.

The drag law is linear in V0 and a sphere reads V0 at one point of the grid, so a flow file whose V0 is the same all around the
centre of a sphere, and such that the law gives the wanted force at rest, is that force; a sphere that moves at v still feels
the law's -c v. Contacts begin without the springs of friction that the clog had wound up: these are wound up anew, by ways
of the size of the overlaps. That the arch stands so under the law's own forces is the control.
"""

import shutil
from dataclasses import dataclass

import numpy as np

from .clogs import CLOG, DIAMETER, SCENE, call, read_clog, settings, write_start

HOLD = 0.1  # [s] 11 Stokes times
REACH = 0.4  # around a centre the field is its sphere's [d]
MOVED = 0.1  # a sphere that moved by more is another arch's [d]


@dataclass(frozen=True)
class Outcome:
    passed: int  # spheres that passed the plane
    moved: int  # of the watched spheres, how many moved by more than MOVED
    way: float  # [d] the median way of the watched spheres
    speed: float  # [m/s] 99 of 100 spheres are slower at the end


def write_flow(file, clog, before, after):
    """Changes V0 around each sphere so that the law's drag is `after` where it was `before`; [n, 3] each. The points between,
    which no sphere reads, get what keeps the rate through every plane, for the program checks it. Spheres far upstream, where
    the file's first plane stands for the developed flow, keep the law's force. Returns which were changed [n]."""
    import h5py
    with h5py.File(file, "r+") as flow:
        image = flow["VTKHDF"]
        origin, spacing = image.attrs["Origin"], image.attrs["Spacing"][0]
        grid, free = image["PointData/U"], image["PointData/solid"][...] == 0
        shape, field = np.array(grid.shape[2::-1]), grid[...].astype(float)
        rate = field[..., 0].sum(axis=(0, 1))
        changed = clog.place[:, 0] > origin[0] + DIAMETER
        for place, old, new in zip(clog.place, before, np.where(changed[:, None], after, before)):
            at = (place - origin) / spacing
            nearest = np.clip(np.rint(at).astype(int), 0, shape - 1)
            per_speed = np.linalg.norm(old) / np.linalg.norm(grid[tuple(nearest[::-1])].astype(float))
            reach = REACH * DIAMETER / spacing
            low, high = np.clip(np.floor(at - reach).astype(int), 0, shape), np.clip(np.ceil(at + reach).astype(int) + 1, 0, shape)
            box = tuple(slice(a, b) for a, b in zip(low[::-1], high[::-1]))
            free[box] = False
            if place[0] > origin[0] + DIAMETER:
                field[box] = new / per_speed
        lost = (rate - field[..., 0].sum(axis=(0, 1))) / np.maximum(free.sum(axis=(0, 1)), 1)
        field[..., 0] += free * lost
        grid[...] = field
    return changed


def go_on(program, flow, out, clog, wanted, watched):
    """Outcome of the clog under the forces wanted [n, 3] [N] in the place of clog.drag, in the folder `out`.
    watched: rows of the arch"""
    if out.exists():
        shutil.rmtree(out)
    out.mkdir(parents=True)
    field = out / "flow.h5"
    shutil.copy(flow, field)
    changed = write_flow(field, clog, clog.drag, wanted)
    once = {"particles.initial": write_start(out, clog), "inlet.enabled": "false", "inlet.start": "empty", "time.end": f"{HOLD} s"}
    call([program, "run", SCENE, "--flow", field, "--seeds", 1, "--out", out, *settings(CLOG | once)])
    field.unlink()
    before, after = (read_clog(out / "run_0001.h5", clog.seed, which) for which in (0, -1))
    off = np.abs(before.drag - np.where(changed[:, None], wanted, clog.drag)).max() / np.abs(wanted).max()
    if off > 1e-4:
        raise SystemExit(f"{out}: the forces are not those wanted: off by {off:.1e} of the largest")
    return outcome(before, after, watched)


def outcome(before, after, watched):
    """A watched sphere that has left counts as moved."""
    place = dict(zip(after.id, after.place))
    way = np.array([np.linalg.norm(place[n] - at) / DIAMETER if n in place else np.inf
                    for n, at in zip(before.id[watched], before.place[watched])])
    return Outcome(after.passed, int(np.sum(way > MOVED)), float(np.median(way)), float(np.quantile(after.speed, 0.99)))
