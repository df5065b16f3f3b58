"""One sphere at the walls of the silo, in each program: over the edge of the orifice, and between two facets of the cone.

Between the cone and the plate of the orifice (its 2 mm) LIGGGHTS and LAMMPS let a sphere touch the edge twice, as that of the
cone and as that of the plate, and so brake it. So they are compared without the plate.
"""

import tempfile
from pathlib import Path

import numpy as np

from silo_codes import DENSITY, DIAMETER, G, NU, PLATE, STIFFER, Clog, Lammps, run

SIDES = 96
LIMIT = 1e-3  # round walls and LAMMPS' longer lever make half of it
OVERLAP = 1e-4


def rows_of_clog(code, case, folder, every, steps):
    import h5py
    text = (folder / "silo.toml").read_text().replace(f'end = "{case.end} s"', f'end = "{steps * case.step} s"')
    (folder / "silo.toml").write_text(text.replace("series_interval", f'snapshot_interval = "{every * case.step} s"\nseries_interval'))
    run([code.program, "run", "silo.toml", "--out", "out"], folder)
    with h5py.File(folder / "out" / "run_0001.h5") as file:
        return np.hstack([file[f"snapshots/{name}"][:] for name in ("position", "velocity", "spin")])


def rows_of_peer(code, case, folder, every, steps):
    shape = "float %.15g" if isinstance(code, Lammps) else '"%d' + 9 * " %.15g" + '"'
    dump = f"dump d all custom {every} rows.txt id x y z vx vy vz omegax omegay omegaz\ndump_modify d format {shape}\nrun {steps}\n"
    text = (folder / "in.txt").read_text()
    (folder / "in.txt").write_text(text.replace(f"run {case.frame * case.frames}\n", dump))
    run([code.program, "-in", "in.txt", "-log", "none"], folder)
    rows = [line.split() for line in (folder / "rows.txt").read_text().splitlines()]
    return np.array([row[1:] for row in rows if len(row) == 10 and row[0] == "1"], dtype=float)


def way_of(code, case, place, every, steps):
    """\\return places, velocities and spins, nine columns"""
    with tempfile.TemporaryDirectory() as folder:
        code.write(case, Path(folder), place)
        return (rows_of_clog if isinstance(code, Clog) else rows_of_peer)(code, case, Path(folder), every, steps)


def on_cone(case, x, turned, apart):
    """A centre that lies over the place x [m] of the cone, at an angle `turned` around it, and `apart` from its corners there [m]."""
    from_axis = case.orifice - x - apart / np.sqrt(2)
    return np.array([[x - apart / np.sqrt(2), from_axis * np.cos(turned), case.radius + from_axis * np.sin(turned)]])


def leaving(code, case):
    """From rest on the middle of a facet. \\return speed along x [m/s] and spin [1/s] where it is half through the orifice"""
    middle = np.pi / SIDES
    place = on_cone(case, -6.6e-3, middle, DIAMETER / 2 + 1.5e-5)
    rows = way_of(code, case, place, 20, 1700)
    return [float(np.interp(PLATE / 2, rows[:, 0], values)) for values in (rows[:, 3], np.linalg.norm(rows[:, 6:], axis=1))]


def pressed(code, case):
    """Between two facets, which meet at angle 0, from the sphere's first step. \\return force over that of Hertz on a plane"""
    place = on_cone(case, -5e-3, 0.0, DIAMETER / 2 - OVERLAP)
    rows = way_of(code, case, place, 1, 1)
    pull = 2 * (rows[-1, :3] - place[0]) / case.step**2 - [G, 0, 0]
    modulus = case.modulus / (1 - NU**2) / (1 + 1 / STIFFER)
    hertz = 4 / 3 * modulus * np.sqrt(DIAMETER / 2) * OVERLAP**1.5
    return float(np.linalg.norm(pull)) * DENSITY * np.pi / 6 * DIAMETER**3 / hertz


def edge_section(codes, case):
    """\\param codes  ours first. \\return lines of the page, whether the peers without the plate do as we do"""
    lines = ["## One sphere at the walls", "",
             "It rolls down the cone from rest, 6.6 mm above the orifice on the middle of a facet, and over the edge; speed and spin where it is half "
             f"through. And it is pressed {1e3 * OVERLAP:g} mm into the corner between two facets of the cone.", "",
             "| program | along x (m/s) | spin (1/s) | force between two facets, over Hertz |", "| --- | --- | --- | --- |"]
    ours, agree = None, True
    for code in codes:
        speed, spin = leaving(code, case)
        ours = ours or speed
        agree &= getattr(code, "plate", False) or abs(speed / ours - 1) <= LIMIT
        lines.append(f"| {code.name} | {speed:.5f} | {spin:.2f} | {pressed(code, case):.2f} |")
    return [*lines, "", f"Without the plate a peer's speed must be ours to {LIMIT:g}: {'it is' if agree else '**it is not**'}.", ""], agree
