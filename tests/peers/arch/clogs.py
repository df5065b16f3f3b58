"""Clogs of the campaign's scene, and what the program's own laws say of the same spheres."""

import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

SCENE = Path(__file__).resolve().parents[3] / "scenes" / "campaign.toml"
DIAMETER = 47e-6
END = 0.2  # [s] 21 Stokes times
SHAPE = {"geometry.channel_length": "1 mm", "ensemble.sweep": "[]"}
CLOG = SHAPE | {"particles.diameter": f"{DIAMETER} m", "inlet.start": "flowing", "unclog.protocol": "none",
                "time.end": f"{END} s", "output.snapshot_interval": "5 ms", "output.contacts": "true"}
LAWS = {  # of the drag, in words of a scene; at rest "mixture" is the paper's
    "strips": {},
    "mixture": {"drag.velocity": "mixture"},
    "local": {"porosity.method": "local"},
    "superficial": {"drag.velocity": "superficial"},
    "beetstra": {"drag.law": "beetstra"}}


def call(words, folder=None):
    done = subprocess.run([str(w) for w in words], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{words[0]} {words[1]}: {(done.stderr or done.stdout).strip().splitlines()[-1]}")
    return done.stdout


def settings(values):
    return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


def solve_flow(program, folder):
    """folder/flow.h5, unless it is there."""
    flow = folder / "flow.h5"
    if not flow.exists():
        call([program, "case", SCENE, folder / "flow", *settings(SHAPE)])
        call([folder / "flow" / "Allrun", ""])
        call([program, "map", folder / "flow", "--out", flow])
    return flow


def nearest_velocity(flow, places):
    """V0 at the grid's points nearest to places [n, 3] [m/s]"""
    import h5py
    with h5py.File(flow) as file:
        image = file["VTKHDF"]
        field = image["PointData/U"][...]
        at = np.rint((places - image.attrs["Origin"]) / image.attrs["Spacing"][0]).astype(int)
    at = np.clip(at, 0, np.array(field.shape[2::-1]) - 1)
    return field[at[:, 2], at[:, 1], at[:, 0]].astype(float)


@dataclass(frozen=True)
class Clog:
    """The last snapshot of a run. Arrays have a row a sphere, sorted by x; SI units."""

    seed: int
    id: np.ndarray  # [n]
    place: np.ndarray  # [n, 3]
    speed: np.ndarray  # [n]
    drag: np.ndarray  # [n, 3] all forces less those of contacts, which at rest is drag alone
    contact: np.ndarray  # [n] sum of the normal forces on it
    passed: int
    last_passage: float


def read_clog(file, seed, which=-1):
    """which: of the snapshots"""
    import h5py
    with h5py.File(file) as run:
        rows, links = (slice(*np.append(run[f"{name}/first"][:], len(run[last]))[[which - (which < 0), which + (which >= 0)]])
                       for name, last in (("snapshots", "snapshots/id"), ("contacts", "contacts/a")))
        ids, place, velocity, force = (run[f"snapshots/{name}"][rows] for name in ("id", "position", "velocity", "force"))
        a, b, normal, push = (run[f"contacts/{name}"][links] for name in ("a", "b", "normal", "force"))
        passages = run["passages/time"][:]
    row = {number: k for k, number in enumerate(ids)}
    drag, load = force.copy(), np.zeros(len(ids))
    for one, other, n, f in zip(a, b, normal.astype(float), push.astype(float)):
        drag[row[one]] -= f
        load[row[one]] += n @ f
        if other >= 0:
            drag[row[other]] += f
            load[row[other]] += n @ f
    order = np.argsort(place[:, 0])
    return Clog(seed, ids[order], place[order], np.linalg.norm(velocity, axis=1)[order], drag[order], load[order],
                len(passages), passages[-1] if len(passages) else 0.0)


def make_clog(program, flow, folder, seed):
    """The run folder/seed_N, unless it is there, and its clog."""
    out = folder / f"seed_{seed}"
    file = out / f"run_{seed:04}.h5"
    if not file.exists():
        call([program, "run", SCENE, "--flow", flow, "--seeds", seed, "--out", out, *settings(CLOG)])
    return read_clog(file, seed)


def write_start(folder, clog):
    """A file for particles.initial, in the clog's order."""
    file = folder / "start.csv"
    file.write_text("x,y,z\n" + "".join(",".join(f"{c:.17g}" for c in p) + "\n" for p in clog.place))
    return file


def law_drag(program, flow, folder, clog, law):
    """[n, 3] drag of the clog's spheres at rest, as the program computes it at these places under another law [N]."""
    out = folder / f"law_{clog.seed}_{law.replace(' ', '_')}"
    file = out / "run_0001.h5"
    if not file.exists():
        out.mkdir(parents=True, exist_ok=True)
        once = {"particles.initial": write_start(out, clog), "inlet.enabled": "false", "inlet.start": "empty",
                "time.end": "20 us", "output.snapshot_interval": "1 us"}
        call([program, "run", SCENE, "--flow", flow, "--seeds", 1, "--out", out, *settings(CLOG | once | LAWS[law])])
    return read_clog(file, clog.seed, 0).drag
