"""Makes the runs of the law, and the copies of states; what is there is not made again."""

import subprocess
from pathlib import Path

from points import COPIES, NECK, POINTS, SCENE
from whole_file import rewritten

ROOT = Path(__file__).resolve().parents[3]


def call(*words, **more):
    subprocess.run([str(word) for word in words], check=True, **more)


def flow_of(program, folder, point):
    """The flow of a point's neck, solved if it is not there: a minute of one core."""
    name = f"{point.angle:g}" if point.height == NECK else f"{point.angle:g}_{point.height:g}"
    flow, case = folder / f"flow_{name}.h5", folder / f"case_{name}"
    if not flow.exists():
        call(program, "case", ROOT / SCENE, case, *(word for key, value in point.neck().items() for word in ("--set", f"{key}={value}")))
        call(case / "Allrun")
        call(program, "map", case, "--out", flow)
    return flow


def run_points(program, folder, names):
    folder.mkdir(parents=True, exist_ok=True)
    for name in names or POINTS:
        point = POINTS[name]
        call(program, "run", ROOT / SCENE, "--flow", flow_of(program, folder, point), "--out", folder / name, "--seeds", point.seeds,
             *point.overrides())


def run_copies(program, folder):
    """docs/reports/bridging/committor.csv; FOLDER holds the flow of 60 degrees."""
    out = ROOT / "docs/reports/bridging/committor.csv"
    head = "D/d,seed,burst,age,copy,push,within,passed,clogged,alike"
    lines = [head]
    for diameter, seeds, end, *numbers in COPIES:
        for seed in seeds:
            age, within, copies, push = numbers
            done = subprocess.run([program, folder / "flow_60.h5", str(seed), str(age), str(within), str(copies), str(push), "ensemble.sweep=[]",
                                   f"particles.diameter={diameter} um", f"time.end={end} s", "output.snapshot_interval=1000 s"],
                                  check=True, capture_output=True, text=True)
            lines += done.stdout.splitlines()
    with rewritten(out) as file:
        file.write("\n".join(lines) + "\n")
