"""Runs the same spheres in a box in clog and in LAMMPS (pair_style granular), for peer_lammps and peer_turning."""

import math
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

DIAMETER = 33e-6
E, NU, DENSITY = 3e6, 0.35, 1062.0
STEP = 5e-8
NORMAL = E / (2 * (1 - NU * NU))                     # E*
SHEAR = E / (2 * (1 + NU)) / (2 * (2 - NU))          # G*


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


LMP = shutil.which("lmp") or shutil.which("lmp_mpi") or shutil.which("lmp_serial")
if LMP is None:
    skip("LAMMPS is not installed (apt-get install lammps)")
try:
    import h5py
    import numpy as np
except ImportError as error:
    skip(f"{error} (apt-get install python3-h5py)")


def state(places, speed, spin_speed=None):
    """Velocities and spins (times the radius), the same for both codes; ids count from 0 in the order given."""
    rng = random.Random(7)
    turning = speed if spin_speed is None else spin_speed
    rows = []
    for x in places:
        v = [rng.gauss(0, speed) if speed else 0.0 for _ in range(3)]
        w = [rng.gauss(0, turning / (DIAMETER / 2)) if turning else 0.0 for _ in range(3)]
        rows.append((*x, *v, *w))
    return rows


SCENE = """
[box]
min = ["0 m", "0 m", "0 m"]
max = ["{box[0]} m", "{box[1]} m", "{box[2]} m"]
[particles]
diameter = "{d} m"
density = "{rho} kg/m3"
initial = "particles.csv"
[contact]
youngs_modulus = "{E} Pa"
poisson_ratio = {nu}
restitution = {e}
tangential_factor = {factor!r}
tangential_damping = {tangential}
[contact.friction]
sliding = {mu[0]}
rolling = {mu[1]}
torsion = {mu[2]}
[time]
end = "{end} s"
step = "{step} s"
allow_unstable = {unstable}
[output]
series_interval = "{end} s"
"""


def run_clog(program, rows, box, steps, law):
    """law: friction (sliding, rolling, torsion), restitution, tangential_factor and _damping"""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        with open(folder / "particles.csv", "w") as csv:
            csv.write("x,y,z,vx,vy,vz,wx,wy,wz\n")
            csv.writelines(",".join(repr(v) for v in row) + "\n" for row in rows)
        (folder / "scene.toml").write_text(SCENE.format(
            box=[repr(size) for size in box], d=DIAMETER, rho=DENSITY, E=E, nu=NU, mu=law["friction"], e=law["restitution"],
            factor=law["tangential_factor"], tangential=law["tangential_damping"], end=repr(STEP * max(steps, 1)),
            step=repr(STEP), unstable=str(law.get("allow_unstable", False)).lower()))
        done = subprocess.run([program, "run", str(folder / "scene.toml"), "--out", str(folder / "out")],
                              capture_output=True, text=True)
        if done.returncode:
            sys.exit("clog failed:\n" + done.stderr)
        with h5py.File(folder / "out" / "run_0001.h5") as file:
            first = file["snapshots/first"][:]
            part = slice(first[0], first[1]) if steps == 0 else slice(first[-1], None)
            row = 0 if steps == 0 else -1
            return {name: file[f"snapshots/{name}"][part] for name in ("position", "spin", "force", "torque")} | {
                name: int(file[f"series/{name}"][row]) for name in ("contacts", "wall_contacts")}


LAMMPS_INPUT = """
units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
region box block -1e-5 {hx} -1e-5 {hy} -1e-5 {hz}
create_box 1 box
{atoms}
neighbor 3.3e-6 bin
neigh_modify delay 0 every 1 check yes
pair_style granular
pair_coeff * * {law}
fix wx all wall/gran granular {wall} xplane 0 {bx}
fix wy all wall/gran granular {wall} yplane 0 {by}
fix wz all wall/gran granular {wall} zplane 0 {bz}
fix move all nve/sphere
timestep {step}
compute pairs all property/local patom1 patom2 cutoff radius
compute forces all pair/local force
dump particles all custom {every} particles.dump id x y z fx fy fz tqx tqy tqz omegax omegay omegaz
dump_modify particles sort id format float %.17g
dump contacts all local {every} contacts.dump index c_pairs[1] c_pairs[2] c_forces
dump_modify contacts format float %.17g
thermo_modify lost error norm no
run {steps}
"""


def run_lammps(rows, box, steps, laws):
    """laws: the coefficients of pair_style granular for pairs and for walls"""
    atoms = [f"create_atoms 1 single {x!r} {y!r} {z!r}" for x, y, z, *_ in rows]
    atoms.append(f"set group all diameter {DIAMETER!r} density {DENSITY!r}")
    for i, row in enumerate(rows, 1):
        vx, vy, vz, wx, wy, wz = row[3:]
        atoms.append(f"set atom {i} vx {vx!r} vy {vy!r} vz {vz!r} omega {wx!r} {wy!r} {wz!r}")
    pair, wall = laws
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        (folder / "in.lmp").write_text(LAMMPS_INPUT.format(
            hx=box[0] + 1e-5, hy=box[1] + 1e-5, hz=box[2] + 1e-5, bx=repr(box[0]), by=repr(box[1]), bz=repr(box[2]),
            atoms="\n".join(atoms), law=pair, wall=wall, step=repr(STEP), steps=steps, every=max(steps, 1)))
        done = subprocess.run([LMP, "-in", "in.lmp", "-log", "log.lmp", "-screen", "none"], cwd=folder)
        if done.returncode:
            sys.exit("LAMMPS failed:\n" + (folder / "log.lmp").read_text()[-2000:])
        particles = last_frame(folder / "particles.dump")
        contacts = last_frame(folder / "contacts.dump")
    return {"position": particles[:, 1:4], "force": particles[:, 4:7], "torque": particles[:, 7:10],
            "spin": particles[:, 10:13], "contacts": contacts}


def last_frame(file):
    text = file.read_text().split("ITEM: TIMESTEP")[-1]
    lines = text.splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith(("ITEM: ATOMS", "ITEM: ENTRIES")))
    return np.array([[float(v) for v in line.split()] for line in lines[start + 1:]])


def largest_difference(ours, theirs):
    """Of any particle, over the largest of all."""
    apart = np.linalg.norm(ours - theirs, axis=1)
    return apart.max() / np.linalg.norm(theirs, axis=1).max()


def check(name, value, limit):
    good = bool(value <= limit)
    print(f"  {name}: {value:.2e} (limit {limit:.1e}) {'ok' if good else 'NOT WITHIN THE LIMIT'}")
    return good
