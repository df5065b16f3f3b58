"""Does the arch stand under other forces? The run goes on, contacts and their springs as they are.

The drag law is linear in V0 and a sphere reads V0 at one point of the grid, so a flow file whose V0 is the same all around the
centre of a sphere, and such that the law gives the wanted force at rest, is that force; a sphere that moves at v still feels
the law's -c v. The forces go over from the law's to the wanted ones in RAMP steps of STEP, then all is left alone for HOLD.
"""

import shutil
from dataclasses import dataclass

import numpy as np

from .clogs import CLOG, DIAMETER, END, SCENE, call, read_clog, settings

RAMP, STEP, HOLD = 5, 5e-3, 0.1  # steps, [s], [s]
REACH = 0.4  # around a centre the field is its sphere's [d]
MOVED = 0.1  # a sphere that moved by more is another arch's [d]


@dataclass(frozen=True)
class Outcome:
    passed: int  # spheres since the forces began to change
    moved: int  # of the watched spheres, how many moved by more than MOVED
    way: float  # [d] the median way of the watched spheres
    speed: float  # [m/s] 99 of 100 spheres are slower at the end


def write_flow(file, clog, before, after):
    """Changes V0 around each sphere so that the law's drag is `after` where it was `before`; [n, 3] each."""
    import h5py
    with h5py.File(file, "r+") as flow:
        image = flow["VTKHDF"]
        origin, spacing = image.attrs["Origin"], image.attrs["Spacing"][0]
        grid = image["PointData/U"]
        shape = np.array(grid.shape[2::-1])
        field = grid[...]
        for place, old, new in zip(clog.place, before, after):
            nearest = np.clip(np.rint((place - origin) / spacing).astype(int), 0, shape - 1)
            here = field[nearest[2], nearest[1], nearest[0]].astype(float)
            per_speed = np.linalg.norm(old) / np.linalg.norm(here)
            low = np.clip(np.floor((place - REACH * DIAMETER - origin) / spacing).astype(int), 0, shape)
            high = np.clip(np.ceil((place + REACH * DIAMETER - origin) / spacing).astype(int) + 1, 0, shape)
            field[low[2]:high[2], low[1]:high[1], low[0]:high[0]] = new / per_speed
        grid[...] = field


def go_on(program, flow, folder, clog, wanted, watched, name):
    """Outcome of the clog under the forces wanted [n, 3] [N] in the place of clog.drag. \\param watched  rows of the arch"""
    out = folder / f"stand_{clog.seed}_{name}"
    if out.exists():
        shutil.rmtree(out)
    shutil.copytree(folder / f"seed_{clog.seed}", out)
    field, end = out / "flow.h5", END
    for k in range(1, RAMP + 1):
        share = k / RAMP
        shutil.copy(flow, field)
        write_flow(field, clog, clog.drag, (1 - share) * clog.drag + share * wanted)
        end += STEP if k < RAMP else HOLD
        later = CLOG | {"time.end": f"{end:.6g} s"}
        call([program, "run", SCENE, "--flow", field, "--seeds", clog.seed, "--out", out, *settings(later)])
    after = read_clog(out / f"run_{clog.seed:04}.h5", clog.seed)
    field.unlink()
    return outcome(clog, after, watched)


def outcome(before, after, watched):
    """A watched sphere that has left counts as moved."""
    place = dict(zip(after.id, after.place))
    way = np.array([np.linalg.norm(place[n] - at) / DIAMETER if n in place else np.inf
                    for n, at in zip(before.id[watched], before.place[watched])])
    return Outcome(after.passed - before.passed, int(np.sum(way > MOVED)), float(np.median(way)),
                   float(np.quantile(after.speed, 0.99)))
