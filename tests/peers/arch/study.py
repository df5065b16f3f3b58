"""Which clogs, meshes and shrinkages are solved; everything ends in CSV tables."""

from dataclasses import dataclass

import numpy as np

from .clogs import DIAMETER, LAWS, law_drag, make_clog, nearest_velocity, solve_flow
from .lattice import lattice_drag
from .plug import plug_drag
from .resolved import Variant, compared, kept, resolve
from .tables import Table
from .trial import try_arch


@dataclass(frozen=True)
class Plan:
    lattices: tuple  # solid, cells a diameter, shrink
    cases: tuple  # seed, Variant
    empty_cells: int


COARSE = Plan(cases=((1, Variant(20)),), empty_cells=16,
              lattices=((0.216, 12, 0.0), (0.216, 18, 0.0), (0.5236, 12, 0.0), (0.5236, 18, 0.0)))
SEEDS = 1, 2, 3, 4, 5
FULL = Plan(
    lattices=tuple((solid, cells, 0.0) for solid in (0.216, 0.343, 0.45, 0.5236) for cells in (12, 18, 24))
    + tuple((0.5236, 18, shrink) for shrink in (0.01, 0.02)),
    cases=tuple((seed, Variant(cells)) for cells in (26, 38) for seed in SEEDS)
    + ((1, Variant(26, 0.01)), (1, Variant(26, 0.02)), (1, Variant(26, slower=100)), (1, Variant(26, start=-2.5))),
    empty_cells=20)


def say(words):
    print(words, flush=True)


def columns(name, vector):
    return {f"{name} {axis}": f"{value:.6g}" for axis, value in zip("xyz", vector)}


def run_study(program, plan, work, data):
    work.mkdir(parents=True, exist_ok=True)
    lattices = Table(data / "lattice.csv", ("solid", "cells a diameter", "shrink"))
    for solid, cells, shrink in plan.lattices:
        say(f"lattice {solid}, d/{cells}, shrunk by {shrink}")
        lattices.row(lambda: lattice_drag(work, solid, cells, shrink),
                     **{"solid": solid, "cells a diameter": cells, "shrink": shrink})
    cases = Table(data / "cases.csv", ("seed", "cells", "shrink", "slower", "start"))
    say("channel without spheres")
    add_case(cases, work, data, 0, np.zeros((0, 3)), Variant(plan.empty_cells))
    flow = solve_flow(program, work)
    clogs = {seed: make_clog(program, flow, work, seed) for seed, _ in plan.cases}
    for seed, clog in clogs.items():
        write_spheres(program, work, data, flow, clog)
    for seed, variant in plan.cases:
        say(f"clog {seed}, {variant}")
        add_case(cases, work, data, seed, clogs[seed].place, variant, kept(clogs[seed], variant.start))
    for clog in clogs.values():
        try_arch(program, work, data, flow, clog)


def write_spheres(program, work, data, flow, clog):
    """data/clog_SEED.csv: places, and drag by each law."""
    laws = {law: law_drag(program, flow, work, clog, law) for law in LAWS}
    laws |= plug_drag(flow, clog.place, laws)
    v0 = nearest_velocity(flow, clog.place)
    inner, spheres = set(compared(clog)), Table(data / f"clog_{clog.seed}.csv", ("row",))
    for row in kept(clog):
        known = {"compared": int(row in inner), "contact [N]": f"{clog.contact[row]:.4g}", "passed": clog.passed,
                 "speed [m/s]": f"{clog.speed[row]:.3g}"} | columns("place", clog.place[row]) | columns("run", clog.drag[row])
        for law, forces in ({"V0": v0} | laws).items():
            known |= columns(law, forces[row])
        spheres.row(lambda: known, row=row)


def add_case(cases, work, data, seed, places, variant, rows=()):
    """A row of cases.csv, and data/forces/SEED_VARIANT.csv."""
    def compute():
        found = resolve(work, f"clog_{seed}_{variant.name}", places[list(rows)], variant)
        told = {"mesh cells": found.told["cells"], "iterations": found.told["iterations"],
                "seconds": found.told["seconds"], "balance": f"{found.balance:.5f}", "drop [Pa]": f"{found.pressure_drop:.6g}"}
        told |= {"covered": 1, "lever": 0}
        if len(rows):
            told |= write_forces(data / "forces" / f"{seed}_{variant.name}.csv", rows, found.loads)
        return told
    cases.row(compute, seed=seed, cells=variant.cells, shrink=variant.shrink, slower=variant.slower, start=variant.start)


def write_forces(file, rows, loads):
    forces = Table(file, ("row",))
    for k, row in enumerate(rows):
        forces.row(lambda: columns("force", loads.force[k]) | columns("meshed", loads.meshed[k])
                   | columns("torque", loads.torque[k]) | {"covered": f"{loads.covered[k]:.4f}"}, row=row)
    lever = np.linalg.norm(loads.torque, axis=1) / (np.linalg.norm(loads.force, axis=1) * DIAMETER / 2)
    return {"covered": f"{loads.covered.mean():.4f}", "lever": f"{np.median(lever):.4f}"}
