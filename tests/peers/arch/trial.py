"""Each arch under other forces than those of the law it grew under."""

import numpy as np

from .compare import compare
from .resolved import CHANNEL, NECK, compared, kept
from .stand import go_on
from .tables import Table, read


def vectors(rows, name):
    return np.array([[float(row[f"{name} {axis}"]) for axis in "xyz"] for row in rows])


def finest(data, seed):
    """Name of the finest case of unshrunk spheres in the scene's flow."""
    rows = [row for row in read(data / "cases.csv")
            if row["seed"] == str(seed) and float(row["shrink"]) == 0 and float(row["slower"]) == 1]
    best = max(rows, key=lambda row: int(row["cells"]))
    return f"clog_{seed}_{best['cells']}_{best['shrink']}_{best['slower']}"


def variants(clog, rows, inner, resolved):
    """Forces on all spheres of the run [N]. Those that are not compared get the law's times the mean ratio."""
    law = clog.drag[rows]
    ratio = compare(resolved[inner], law[inner]).ratio

    def around(scatter, factor):
        """ratio law + scatter (resolved - ratio law), all times factor / ratio"""
        forces = ratio * clog.drag
        forces[rows[inner]] += scatter * (resolved - ratio * law)[inner]
        return forces * factor / ratio

    only = clog.drag.copy()
    only[rows[inner]] = resolved[inner]
    return {"law": clog.drag, "law scaled": around(0, ratio), "resolved": around(1, ratio), "resolved, law elsewhere": only,
            "scatter doubled": around(2, ratio), "scatter times 4": around(4, ratio)}


def try_arch(program, work, data, flow, clog):
    rows, inner = kept(clog), compared(clog)
    resolved = vectors(read(data / "forces" / f"{finest(data, clog.seed)}.csv"), "force")
    watched = rows[inner & (clog.place[rows, 0] > -CHANNEL.narrowing * NECK)]
    outcomes = Table(data / "stand.csv", ("seed", "forces"))
    for name, forces in variants(clog, rows, inner, resolved).items():
        print(f"clog {clog.seed} under the forces: {name}", flush=True)

        def compute():
            found = go_on(program, flow, work, clog, forces, watched, name.replace(" ", "_").replace(",", ""))
            return {"watched": len(watched), "passed": found.passed, "moved": found.moved, "way [d]": f"{found.way:.3g}",
                    "speed [m/s]": f"{found.speed:.3g}"}
        outcomes.row(compute, seed=clog.seed, forces=name)
