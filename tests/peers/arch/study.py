"""Which clogs, meshes and shrinkages are solved; everything ends in CSV tables."""

from dataclasses import dataclass

import numpy as np

from .clogs import DIAMETER, LAWS, law_drag, make_clog, solve_flow
from .lattice import lattice_drag
from .resolved import bed_drop, compared, kept, resolve
from .tables import Table


@dataclass(frozen=True)
class Plan:
    seeds: tuple
    flow_cells: int  # of the undisturbed flow, a neck width
    lattices: tuple  # solid, cells a diameter, shrink
    cases: tuple  # seed, cells a neck width, shrink, how much slower than the scene's flow
    empty_cells: int
    stands: bool  # whether the arches are tried


COARSE = Plan(seeds=(1,), flow_cells=24, lattices=((0.216, 12, 0.0), (0.5236, 12, 0.0)), cases=((1, 20, 0.0, 1),),
              empty_cells=16, stands=False)
FULL = Plan(
    seeds=(1, 2, 3), flow_cells=48,
    lattices=tuple((solid, cells, 0.0) for solid in (0.216, 0.343, 0.45, 0.5236) for cells in (12, 18, 24))
    + tuple((0.5236, 18, shrink) for shrink in (0.01, 0.02)),
    cases=tuple((seed, 26, shrink, 1) for seed in (1, 2, 3) for shrink in (0.0, 0.01, 0.02))
    + tuple((seed, 38, 0.0, 1) for seed in (1, 2, 3)) + ((1, 50, 0.0, 1), (1, 26, 0.0, 100)),
    empty_cells=20, stands=True)


def say(words):
    print(words, flush=True)


def columns(name, vectors, k):
    return {f"{name} {axis}": f"{vectors[k, a]:.6g}" for a, axis in enumerate("xyz")}


def run_study(program, plan, work, data):
    work.mkdir(parents=True, exist_ok=True)
    lattices = Table(data / "lattice.csv", ("solid", "cells a diameter", "shrink"))
    for solid, cells, shrink in plan.lattices:
        say(f"lattice {solid}, d/{cells}, shrunk by {shrink}")
        lattices.row(lambda: lattice_drag(work, solid, cells, shrink),
                     **{"solid": solid, "cells a diameter": cells, "shrink": shrink})
    flow = solve_flow(program, work, plan.flow_cells)
    cases = Table(data / "cases.csv", ("seed", "cells", "shrink", "slower"))
    say("channel without spheres")
    cases.row(lambda: empty(work, plan.empty_cells), seed=0, cells=plan.empty_cells, shrink=0.0, slower=1)
    for seed in plan.seeds:
        say(f"clog {seed}")
        study_clog(program, plan, work, data, flow, cases, seed)


def empty(work, cells):
    found = resolve(work, "empty", np.zeros((0, 3)), cells)
    return {"mesh cells": found.told["cells"], "iterations": found.told["iterations"], "seconds": found.told["seconds"],
            "balance": found.balance, "drop [Pa]": found.pressure_drop, "bed [Pa]": 0, "ergun [Pa]": 0,
            "covered": 1, "torque": 0}


def study_clog(program, plan, work, data, flow, cases, seed):
    clog = make_clog(program, flow, work, seed)
    rows, inner = kept(clog), compared(clog)
    laws = {law: law_drag(program, flow, work, clog, law)[rows] for law in LAWS}
    spheres = Table(data / f"clog_{seed}.csv", ("row",))
    for k, row in enumerate(rows):
        spheres.row(lambda: {"x [m]": clog.place[row, 0], "y [m]": clog.place[row, 1], "z [m]": clog.place[row, 2],
                             "compared": int(inner[k]), "contact [N]": f"{clog.contact[row]:.4g}",
                             "speed [m/s]": f"{clog.speed[row]:.3g}"} | columns("run", clog.drag[rows], k)
                    | {name: value for law in LAWS for name, value in columns(law, laws[law], k).items()}, row=k)
    for number, cells, shrink, slower in plan.cases:
        if number != seed:
            continue
        name = f"clog_{seed}_{cells}_{shrink}_{slower}"
        say(f"clog {seed}, {cells} cells a neck width, shrunk by {shrink}" + (f", {slower} times slower" if slower > 1 else ""))
        cases.row(lambda: solved(work, name, clog, cells, shrink, slower, data),
                  seed=seed, cells=cells, shrink=shrink, slower=slower)
    if plan.stands:
        from .trial import try_arch
        try_arch(program, work, data, flow, clog)


def solved(work, name, clog, cells, shrink, slower, data):
    """Also writes the forces: data/forces/NAME.csv."""
    places = clog.place[kept(clog)]
    found = resolve(work, name, places, cells, shrink, slower)
    forces = Table(data / "forces" / f"{name}.csv", ("row",))
    for k in range(len(places)):
        forces.row(lambda: columns("force", found.loads.force, k) | columns("meshed", found.loads.meshed, k)
                   | columns("torque", found.loads.torque, k) | {"covered": f"{found.loads.covered[k]:.4f}"}, row=k)
    lever = np.linalg.norm(found.loads.torque, axis=1) / (np.linalg.norm(found.loads.force, axis=1) * DIAMETER / 2)
    return {"mesh cells": found.told["cells"], "iterations": found.told["iterations"], "seconds": found.told["seconds"],
            "balance": f"{found.balance:.5f}", "drop [Pa]": f"{found.pressure_drop:.6g}",
            "bed [Pa]": f"{bed_drop(places, shrink):.5g}", "ergun [Pa]": f"{bed_drop(places, shrink, True):.5g}",
            "covered": f"{found.loads.covered.mean():.4f}", "torque": f"{np.median(lever):.4f}"}
