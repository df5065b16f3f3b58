"""The silo of Dosta et al. (2024), and its input for each program: number of spheres left over time."""

import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from begin import LAMMPS_BEGIN, LIGGGHTS_BEGIN
from dashpot import lammps_restitution, our_restitution

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scenes"))
from make_shapes import silo  # noqa: E402

DIAMETER, DENSITY, NU, G = 4e-3, 2500.0, 0.2, 9.81
RESTITUTION, WALL_RESTITUTION = 0.5, 0.4
FRICTION, WALL_FRICTION = 0.3, 0.2
STIFFER = 210  # steel over the particles' 1 GPa
PLATE = 2e-3  # length of the orifice; what is half through it has left
STEP = 0.04  # of the contact time
OURS = "clogflow"


def contact_time(modulus, speed=1.0):
    """Hertz: 2.87 (m*^2 / (R* E*^2 v))^(1/5)."""
    mass, radius, stiffness = DENSITY * np.pi / 12 * DIAMETER**3, DIAMETER / 4, modulus / (2 * (1 - NU**2))
    return 2.87 * (mass**2 / (radius * stiffness**2 * speed)) ** 0.2


def beverloo(orifice, packing):
    """Spheres a second: 0.58 rho_b sqrt(g) (D - 1.4 d)^(5/2) over the mass of one."""
    return 0.58 * packing * np.sqrt(G) * (2 * orifice - 1.4 * DIAMETER) ** 2.5 / (np.pi / 6 * DIAMETER**3)


@dataclass
class Case:
    orifice: float         # its radius [m]
    spheres: int
    radius: float          # of the cylinder [m]
    modulus: float         # of the particles [Pa]
    step: float            # [s]
    end: float             # [s]
    frames: int = 200

    @property
    def cone(self):
        return self.radius - self.orifice  # 45 degrees

    @property
    def height(self):
        """Of a cylinder that holds a few more than the spheres wanted, at a packing fraction of 0.54."""
        volume = self.spheres * np.pi / 6 * DIAMETER**3 / 0.54
        cone = np.pi / 3 * (self.radius**3 - self.orifice**3)
        return max(2 * DIAMETER, (volume - cone) / (np.pi * self.radius**2)) + 6 * DIAMETER

    @property
    def frame(self):
        return int(self.end / self.step / self.frames)

    def walls(self):
        """Parts of the STL file, in mm."""
        return silo(1e3 * self.radius, 1e3 * self.height, 1e3 * self.orifice, 1e3 * PLATE, 1e3 * self.cone, sides=96)


def write_stl(file, parts, unit):
    lines = []
    for name, triangles in parts.items():
        lines.append(f"solid {name}")
        for triangle in triangles:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex " + " ".join(repr(unit * float(value)) for value in corner) for corner in triangle]
            lines += ["endloop", "endfacet"]
        lines.append(f"endsolid {name}")
    file.write_text("\n".join(lines) + "\n")


def run(words, folder):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, errors="replace")
    if done.returncode:
        raise SystemExit(f"{words[0]} failed in {folder}:\n{done.stdout[-1500:]}{done.stderr[-1500:]}")
    return done.stdout


class Clog:
    def __init__(self, program, name=OURS, **changes):
        """\param changes  for controls: moved, all places along x [m]; friction, wall_friction"""
        self.program, self.name = program, name
        self.moved = changes.get("moved", 0.0)
        self.friction, self.wall_friction = changes.get("friction", FRICTION), changes.get("wall_friction", WALL_FRICTION)

    def scene(self, case, more):
        return f"""gravity = ["{G} m/s2", "0 m/s2", "0 m/s2"]
[geometry]
stl = "silo.stl"
stl_unit = "1 mm"
neck_width = "{2 * case.orifice} m"
[particles]
diameter = "{DIAMETER} m"
density = "{DENSITY} kg/m3"
[contact]
youngs_modulus = "{case.modulus} Pa"
poisson_ratio = {NU}
restitution = {our_restitution(RESTITUTION)!r}
tangential_factor = 1
tangential_damping = 0
wall_youngs_modulus = "{STIFFER * case.modulus} Pa"
wall_restitution = {our_restitution(WALL_RESTITUTION)!r}
friction.sliding = {self.friction}
wall_friction.sliding = {self.wall_friction}
[time]
step = "{case.step} s"
{more}"""

    def pack(self, case, seed, folder):
        """Poured behind the gate; of the spheres the lowest. \\return their places"""
        import h5py
        write_stl(folder / "silo.stl", case.walls(), 1)
        (folder / "pour.toml").write_text(self.scene(case, f'end = "{case.step} s"\n[inlet]\nstart = "filled"\ntaps = 0\n'))
        run([self.program, "run", "pour.toml", "--seeds", str(seed), "--out", "poured"], folder)
        with h5py.File(folder / "poured" / f"run_{seed:04}.h5") as file:
            first = file["snapshots/first"][:]
            places = file["snapshots/position"][:first[1] if len(first) > 1 else None]
        if len(places) < case.spheres:
            raise SystemExit(f"the poured pack has {len(places)} spheres, {case.spheres} are wanted: a taller cylinder")
        return places[np.argsort(-places[:, 0])[:case.spheres]]

    def write(self, case, folder, places):
        write_stl(folder / "silo.stl", case.walls(), 1)
        places = places + [self.moved, 0, 0]
        rows = ["x,y,z"] + [",".join(map(repr, place)) for place in places.tolist()]
        (folder / "pack.csv").write_text("\n".join(rows) + "\n")
        text = self.scene(case, f'end = "{case.end} s"\n[output]\nseries_interval = "{case.end / 10} s"\n')
        (folder / "silo.toml").write_text(text.replace("[contact]", 'initial = "pack.csv"\n[contact]'))

    def left(self, case, folder):
        """\\return numbers left at the end of each frame"""
        import h5py
        run([self.program, "run", "silo.toml", "--out", "out"], folder)
        with h5py.File(folder / "out" / "run_0001.h5") as file:
            passed = np.sort(file["passages/time"][:])
        return case.spheres - np.searchsorted(passed, np.arange(1, case.frames + 1) * case.frame * case.step)


class Peer:
    def __init__(self, program, falling=False, plate=False):
        """\param falling  whether spheres fall on below the orifice; else they are taken out where the plate ends, as ours are
        \param plate    whether the orifice has its length; then both peers count its edge twice, see silo_edge.py"""
        self.program, self.falling, self.plate = program, falling, plate
        self.name = self.called + ", falling on" * falling + ", with plate" * plate

    def data_file(self, case, places):
        low = (places[:, 0].min() - DIAMETER, -case.radius - DIAMETER, -DIAMETER)
        high = (0.05 if self.falling else PLATE, case.radius + DIAMETER, 2 * case.radius + DIAMETER)
        low = (min(low[0], -case.cone - case.height - 1e-3), *low[1:])
        head = ["spheres in a silo", "", f"{len(places)} atoms", "2 atom types"]
        head += [f"{a!r} {b!r} {x}lo {x}hi" for a, b, x in zip(map(float, low), high, "xyz")] + ["", "Atoms", ""]
        rows = [f"{i} 1 {DIAMETER!r} {DENSITY!r} " + " ".join(map(repr, p)) for i, p in enumerate(places.tolist(), 1)]
        return "\n".join(head + rows) + "\n"

    def tail(self, case):
        return f"""
fix weight all gravity {G} vector 1 0 0
fix move all nve/sphere
timestep {case.step}
region before block -1 {PLATE / 2!r} -1 1 -1 1 units box
variable left equal count(all,before)
thermo {case.frame}
thermo_style custom step v_left
thermo_modify lost ignore norm no
run {case.frame * case.frames}
"""

    def left(self, case, folder):
        said = run([self.program, "-in", "in.txt", "-log", "none"], folder)
        rows = [list(map(float, words)) for words in map(str.split, said.splitlines())
                if len(words) == 2 and words[0].isdigit() and words[1].replace(".", "").isdigit()]
        rows = np.array([row for row in rows if row[0] > 0 and row[0] % case.frame == 0])
        if len(rows) < case.frames:
            raise SystemExit(f"{self.name} gave {len(rows)} frames, {case.frames} are wanted:\n{said[-1500:]}")
        return rows[:case.frames, 1]


class Liggghts(Peer):
    called = "LIGGGHTS"

    def write(self, case, folder, places):
        (folder / "pack.data").write_text(self.data_file(case, places))
        walls = [triangle for triangle in case.walls()["walls"] if self.plate or max(x for x, _, _ in triangle) <= 0]
        write_stl(folder / "walls.stl", {"walls": walls}, 1e-3)
        law, options = "model hertz tangential history", "tangential_damping off limitForce on"

        def pairs(own, wall):
            return f"2 {own} {wall} {wall} {wall}"

        (folder / "in.txt").write_text(LIGGGHTS_BEGIN + f"""
neighbor {0.2 * DIAMETER!r} bin
neigh_modify delay 0
hard_particles yes
soft_particles yes
fix m1 all property/global youngsModulus peratomtype {case.modulus} {STIFFER * case.modulus}
fix m2 all property/global poissonsRatio peratomtype {NU} {NU}
fix m3 all property/global coefficientRestitution peratomtypepair {pairs(RESTITUTION, WALL_RESTITUTION)}
fix m4 all property/global coefficientFriction peratomtypepair {pairs(FRICTION, WALL_FRICTION)}
pair_style gran {law} {options}
pair_coeff * *
fix silo all mesh/surface file walls.stl type 2
fix walls all wall/gran {law} mesh n_meshes 1 meshes silo {options}
{self.tail(case)}""")


class Lammps(Peer):
    called = "LAMMPS"

    def write(self, case, folder, places):
        (folder / "pack.data").write_text(self.data_file(case, places))
        e, tail = case.modulus, "damping tsuji limit_damping"
        pair = f"hertz/material {e!r} {lammps_restitution(RESTITUTION)!r} {NU} tangential mindlin NULL 0.0 {FRICTION} {tail}"
        # For walls the release of 2021 takes E / (2 (1 - nu)) for E*: so its coefficients are given outright.
        soft = 1 + 1 / STIFFER  # compliance of both over that of the particle
        normal = e / (1 - NU**2) / soft
        shear = e / (2 * (1 + NU)) / (2 - NU) / soft
        wall = (f"hertz {4 / 3 * normal!r} {lammps_restitution(WALL_RESTITUTION)!r} tangential mindlin {8 * shear!r} 0.0 "
                f"{WALL_FRICTION} {tail}")
        middle = f"0.0 {case.radius!r}"
        (folder / "in.txt").write_text(LAMMPS_BEGIN + f"""
neighbor {0.2 * DIAMETER!r} bin
neigh_modify delay 0 every 1 check yes
pair_style granular
pair_coeff * * {pair}
region cylinder cylinder x {middle} {case.radius!r} {-case.cone - case.height - 0.01!r} {-case.cone!r} open 1 open 2 units box
region cone cone x {middle} {case.radius!r} {case.orifice!r} {-case.cone!r} 0 open 1 open 2 units box
region orifice cylinder x {middle} {case.orifice!r} 0 {PLATE!r} open 1 open 2 units box
fix cylinder all wall/gran/region granular {wall} region cylinder
fix cone all wall/gran/region granular {wall} region cone
{f"fix orifice all wall/gran/region granular {wall} region orifice" if self.plate else ""}
{self.tail(case)}""")
