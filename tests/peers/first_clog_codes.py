"""Input of first_clog for each program, and its frames: passages and the speed of those before the plane."""

import math
import shutil
import subprocess

import numpy as np

from begin import LAMMPS_BEGIN, LIGGGHTS_BEGIN
from dashpot import lammps_restitution, our_restitution
from first_clog_case import (DENSITY, DIAMETER, DRAG, E, END, FRAME, LAST, LENGTH, NARROWING, NECK, NORMAL, NU,
                             PARTICLES, PLANE, RADIUS, REST, RESTITUTION, SHEAR, SPEED, START, STEP, VISCOSITY,
                             WAIT, WIDTH, first_clog)

PARTS = 60, 120, LAST  # frames
PAD = NECK / 4  # walls reach so far beyond each other


def loop(again):
    """The end of both peers' inputs: frames until the clog or the end, each a printed line.

    again: words of `run` for frames after the first.
    """
    return f"""
region before block {START - PAD!r} {PLANE!r} {-WIDTH} {WIDTH} {-NECK} {2 * NECK} units box
variable left equal count(all,before)
variable passed equal {PARTICLES}-v_left
variable v2 atom vx*vx+vy*vy+vz*vz
compute sum all reduce/region before sum v_v2
variable speed equal sqrt(c_sum/(v_left+1e-9))
thermo {FRAME}
thermo_style custom step v_passed v_speed
thermo_modify lost ignore norm no
variable most equal 0
variable since equal 0
variable k loop {LAST}
run 0
label again
run {FRAME} {again} post no
variable now equal ${{passed}}
variable rest equal ${{speed}}
print "FRAME ${{now}} ${{rest}}"
if "${{now}} > ${{most}}" then "variable since equal ${{k}}" "variable most equal ${{now}}"
variable waited equal ${{k}}-${{since}}
if "${{now}} == {PARTICLES}" then "jump SELF done"
if "${{waited}} >= {WAIT} && ${{rest}} <= {REST * SPEED!r}" then "jump SELF done"
next k
jump SELF again
label done
"""


def data_file(places):
    """Both peers read it: id, type, diameter, density, place."""
    low, high = (START - 2 * PAD, -WIDTH / 2 - 2 * PAD, -2 * PAD), (END, WIDTH / 2 + 2 * PAD, NECK + 2 * PAD)
    head = [f"{PARTICLES} spheres before a neck", "", f"{len(places)} atoms", "1 atom types"]
    head += [f"{a!r} {b!r} {x}lo {x}hi" for a, b, x in zip(low, high, "xyz")] + ["", "Atoms", ""]
    rows = [f"{i} 1 {DIAMETER!r} {DENSITY!r} " + " ".join(map(repr, p)) for i, p in enumerate(places.tolist(), 1)]
    return "\n".join(head + rows) + "\n"


def stl():
    """Slope and neck on both sides, for LIGGGHTS; the other walls are planes."""
    lines = ["solid neck"]
    for side in (1, -1):
        slope = PAD * math.tan(math.radians(30)), PAD
        profile = [(-NARROWING - slope[0], WIDTH / 2 + slope[1]), (0.0, NECK / 2), (END + PAD, NECK / 2)]
        for (xa, ya), (xb, yb) in zip(profile, profile[1:]):
            a, b, c, d = [(x, side * y, z) for x, y, z in (
                (xa, ya, -PAD), (xb, yb, -PAD), (xb, yb, NECK + PAD), (xa, ya, NECK + PAD))]
            for corners in ((a, b, c), (a, c, d)):
                lines += ["facet normal 0 0 0", "outer loop"]
                lines += ["vertex " + " ".join(map(repr, p)) for p in corners] + ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid neck"]) + "\n"


def run(words, folder):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{words[0]} failed in {folder}:\n{done.stdout[-1500:]}{done.stderr[-1500:]}")
    return done.stdout


class Clog:
    def __init__(self, program, name="clogflow", moved=0.0, **law):
        """moved: all places along x [m]; law: scene keys of the section contact"""
        self.program, self.name, self.moved = program, name, moved
        self.law = {"tangential_factor": 1, "tangential_damping": 0, "friction.sliding": 0.6} | law

    def write(self, folder, places, rolling):
        rows = ["x,y,z"] + [f"{x + self.moved!r},{y!r},{z!r}" for x, y, z in places.tolist()]
        (folder / "particles.csv").write_text("\n".join(rows) + "\n")
        (folder / "scene.toml").write_text(f"""
[geometry]
neck_width = "{NECK} m"
channel_width = "{WIDTH} m"
channel_length = "{LENGTH} m"
half_angle = "60 deg"
[fluid]
viscosity = "{VISCOSITY} Pa s"
density = "1000 kg/m3"
[flow]
source = "uniform"
velocity = ["{SPEED} m/s", "0 m/s", "0 m/s"]
[particles]
diameter = "{DIAMETER} m"
density = "{DENSITY} kg/m3"
initial = "particles.csv"
[drag]
law = "stokes"
[contact]
youngs_modulus = "{E} Pa"
poisson_ratio = {NU}
restitution = {our_restitution(RESTITUTION)!r}
{chr(10).join(f"{key} = {value}" for key, value in self.law.items())}
friction.rolling = {rolling}
[time]
end = "{PARTS[0] * FRAME * STEP!r} s"
step = "{STEP} s"
[output]
snapshot_interval = "{FRAME * STEP!r} s"
series_interval = "{FRAME * STEP!r} s"
""")

    def frames(self, folder):
        """A run that is not over goes on from where it stood."""
        for last in PARTS:
            run([self.program, "run", "scene.toml", "--out", "out", "--set", f"time.end = {last * FRAME * STEP!r} s"],
                folder)
            frames = self.read(folder / "out" / "run_0001.h5")
            if first_clog(frames).ended:
                break
        return frames

    @staticmethod
    def read(file):
        import h5py
        with h5py.File(file) as run_file:
            first = run_file["snapshots/first"][:]
            x, v = run_file["snapshots/position"][:, 0], run_file["snapshots/velocity"][:]
        frames = []
        for part in np.split(np.arange(len(x)), first[1:])[1:]:
            before = part[x[part] < PLANE]
            frames.append((PARTICLES - len(before), np.sqrt(np.sum(v[before] ** 2) / max(len(before), 1))))
        return frames


class Peer:
    def __init__(self, program):
        self.program = program

    def frames(self, folder):
        said = run([self.program, "-in", "in.txt", "-log", "none"], folder)
        return [(int(float(words[1])), float(words[2])) for words in map(str.split, said.splitlines())
                if len(words) == 3 and words[0] == "FRAME"]


class Liggghts(Peer):
    name = "LIGGGHTS"

    def write(self, folder, places, rolling):
        (folder / "pack.data").write_text(data_file(places))
        (folder / "neck.stl").write_text(stl())
        law = "model hertz tangential history" + (" rolling_friction epsd2" if rolling else "")
        options = "tangential_damping off limitForce on"
        planes = [("x", START), ("y", -WIDTH / 2), ("y", WIDTH / 2), ("z", 0.0), ("z", NECK)]
        walls = "\n".join(f"fix plane{k} all wall/gran {law} primitive type 1 {x}plane {at!r} {options}"
                          for k, (x, at) in enumerate(planes))
        (folder / "in.txt").write_text(LIGGGHTS_BEGIN + f"""
neighbor {0.1 * DIAMETER!r} bin
neigh_modify delay 0
hard_particles no
soft_particles yes
fix m1 all property/global youngsModulus peratomtype {E}
fix m2 all property/global poissonsRatio peratomtype {NU}
fix m3 all property/global coefficientRestitution peratomtypepair 1 {RESTITUTION}
fix m4 all property/global coefficientFriction peratomtypepair 1 0.6
fix m5 all property/global coefficientRollingFriction peratomtypepair 1 {rolling}
pair_style gran {law} {options}
pair_coeff * *
fix neck all mesh/surface file neck.stl type 1
fix slopes all wall/gran {law} mesh n_meshes 1 meshes neck {options}
{walls}
fix drag all viscous {DRAG!r}
fix push all addforce {DRAG * SPEED!r} 0 0
fix move all nve/sphere
timestep {STEP}
{loop("")}""")


class Lammps(Peer):
    name = "LAMMPS"
    overlap = 2e-3 * DIAMETER  # for which its rolling springs of constant stiffness are ours

    def rolling(self, radius, coefficient):
        stiffness = 8 * SHEAR * math.sqrt(radius * self.overlap)
        return f"rolling sds {stiffness!r} 0.0 {coefficient}" if coefficient else ""

    def write(self, folder, places, rolling):
        (folder / "pack.data").write_text(data_file(places))
        e = lammps_restitution(RESTITUTION)
        tail = "damping tsuji limit_damping"
        pair = f"hertz/material {E!r} {e!r} {NU} tangential mindlin NULL 0.0 0.6 {self.rolling(RADIUS / 2, rolling)} {tail}"
        # For walls the release of 2021 takes E / (2 (1 - nu)) for E*: so its coefficients are given outright.
        wall = (f"hertz {4 / 3 * NORMAL!r} {e!r} tangential mindlin {8 * SHEAR!r} 0.0 0.6 "
                f"{self.rolling(RADIUS, rolling)} {tail}")
        # At each beginning of a run it also turns the walls' restitution into a dashpot once more, so "pre no".
        lean = (WIDTH - NECK) / 2 / math.tan(math.radians(60)) * (1 + PAD / NECK)
        top, far = WIDTH / 2 + PAD, 3 * NECK
        (folder / "in.txt").write_text(LAMMPS_BEGIN + f"""
neighbor {0.1 * DIAMETER!r} bin
neigh_modify delay 0 every 1 check yes
pair_style granular
pair_coeff * * {pair}
region upper prism 0 {far!r} {NECK / 2!r} {top!r} {-PAD!r} {NECK + PAD!r} {-lean!r} 0 0 side out units box
region lower prism {-lean!r} {far!r} {-top!r} {-NECK / 2!r} {-PAD!r} {NECK + PAD!r} {lean!r} 0 0 side out units box
fix upper all wall/gran/region granular {wall} region upper
fix lower all wall/gran/region granular {wall} region lower
fix x all wall/gran granular {wall} xplane {START!r} NULL
fix y all wall/gran granular {wall} yplane {-WIDTH / 2!r} {WIDTH / 2!r}
fix z all wall/gran granular {wall} zplane 0 {NECK!r}
fix drag all viscous {DRAG!r}
fix push all addforce {DRAG * SPEED!r} 0 0
fix move all nve/sphere
timestep {STEP}
{loop("pre no")}""")
