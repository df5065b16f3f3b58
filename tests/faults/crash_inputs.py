"""A scene and a solved flow case that cost nothing: plug flow in the places that the case asks for."""

import json
import math
import pathlib
import re
import subprocess

SCENE = """
[geometry]
neck_width = "100 um"
half_angle = "60 deg"
channel_width = "200 um"
channel_length = "200 um"
neck_length = "100 um"
[fluid]
viscosity = "1.8e-3 Pa s"
density = "1062 kg/m3"
[flow]
source = "openfoam"
mean_velocity = "5 mm/s"
mesh_cells_per_neck = 8
grid_spacing = "10 um"
[particles]
diameter = "50 um"
density = "1062 kg/m3"
[contact]
youngs_modulus = "3 MPa"
poisson_ratio = 0.35
[contact.friction]
sliding = 0.5
[inlet]
enabled = true
taps = 1
[unclog]
protocol = "release"
after = "3 ms"
[time]
mass_scale = 10
rotational_inertia_scale = 5
step_fraction = 0.04
end = "6 ms"
[output]
snapshot_interval = "4 ms"
series_interval = "1 ms"
checkpoint_interval = "1 us"
[ensemble]
seeds = "3-4"                # whose packs come to rest; every fourth of this small channel does not
"""
NECK, WIDE, SPACING = 100e-6, 200e-6, 10e-6  # as in the scene [m]
NARROWING = (WIDE - NECK) / 2 / math.tan(math.radians(60))


def half_width(x):
    """Of the channel at x [m]."""
    share = min(1, max(0, (x + NARROWING) / NARROWING))
    return WIDE / 2 - share * (WIDE - NECK) / 2


def plug_velocity(mean, x):
    """Uniform over the points of a plane that lie in the fluid, so that each plane carries the same flux [m/s]."""
    across = sum((j + 0.5) * SPACING < half_width(x) for j in range(50))
    return mean * WIDE / 2 / (across * SPACING)


def samples(dictionary):
    """The text that OpenFOAM's sampling writes for a sceneDict."""
    def entry(name):
        return float(re.search(rf"{name}\s+([^;]+);", dictionary)[1])

    mean = entry("meanVelocity")
    axes = []
    for axis in "XYZ":
        count = int(entry(f"samplePoints{axis}"))
        step = entry(f"sampleSpan{axis}") / (count + 1)
        axes.append([entry(f"sampleOrigin{axis}") + (i + 1) * step for i in range(count)])
    return "".join(f"{x:.9g} {y:.9g} {z:.9g} {plug_velocity(mean, x):.9g} 0 0\n"
                   for x in axes[0] for y in axes[1] for z in axes[2])


def pretend_solved(case):
    """Gives a case that `clog case` wrote what its Allrun leaves."""
    out = case / "postProcessing/samples/100"
    out.mkdir(parents=True)
    (out / "lattice_U.xy").write_text(samples((case / "system/sceneDict").read_text()))
    (case / "log.simpleFoam").write_text(
        "Version: 1912\nSolving for Ux, Initial residual = 1e-6\nSolving for Uy, Initial residual = 1e-6\n"
        "Solving for Uz, Initial residual = 1e-6\nSolving for p, Initial residual = 1e-6\n"
        "SIMPLE solution converged in 100 iterations\n")
    (case / "log.checkMesh").write_text("\n    cells: 1000\nMesh non-orthogonality Max: 40\nMesh OK\n")
    (case / "fluxes").write_text("inlet 5e-11\noutlet 5e-11\n")
    (case / "pressure").write_text("0.01\n")
    (case / "solved").write_text((case / "hash").read_text())


STUDY = {"format": "clogflow trade 2", "scene": "", "diameter": 33e-6, "neck_ratio": 3.03, "reference": "a",
         "settings": [{"name": "a", "kind": "dose", "overrides": [], "seconds_per_clog": 1, "within": 0,
                       "step_over_limit": 0.5}]}


# The real scripts take seconds a call and write their files as these do.
PYTHON = """#!/bin/sh
[ "$1" = -c ] || exec /usr/bin/python3 "$@"
"""
MAKE_REPORT = """import pathlib, sys
pathlib.Path(sys.argv[2]).mkdir(parents=True, exist_ok=True)
for name, content in ("series.png", bytes(300000)), ("series.svg", b"<svg/>"), ("report.html", b"<html></html>"):
    file = pathlib.Path(sys.argv[2]) / name
    file.write_bytes(content)
    print("wrote", file)
"""


def stand_in_figures(folder):
    folder.mkdir()
    (folder / "make_report.py").write_text(MAKE_REPORT)
    (folder / "python").write_text(PYTHON)
    (folder / "python").chmod(0o755)


def make(clog, folder):
    """scene.toml, case/ (solved), flow.h5, runs/, stats/, trade.json and figures/ in a folder."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    (folder / "scene.toml").write_text(SCENE)
    stand_in_figures(folder / "figures")
    (folder / "trade.json").write_text(json.dumps(STUDY))
    for words in (["case", "scene.toml", "case"], ["map", "case", "--out", "flow.h5"],
                  ["run", "scene.toml", "--flow", "flow.h5", "--out", "runs"],
                  ["stats", "runs", "--out", "stats", "--p-value", "0"]):
        if words[0] == "map":
            pretend_solved(folder / "case")
        subprocess.run([clog, *words], cwd=folder, check=True, capture_output=True)
    return folder
