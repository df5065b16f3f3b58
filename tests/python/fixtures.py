"""Files that the real program wrote, made once a process: a solved flow, runs, their statistics; and an ensemble whose
passages are made up, so that its answers are known."""

import atexit
import functools
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests/faults")]

import crash_inputs  # noqa: E402  (found through the line above)

PROGRAM = os.environ.get("CLOG", str(ROOT / "build/release/bin/clog"))
# Seeds whose packs come to rest at once.
STEADY = {"inlet.start": "filled", "unclog.protocol": "none", "particles.diameter": "45 um", "time.end": "200 ms",
          "output.checkpoint_interval": "60 s"}
# A pack that a flow presses together, and whose snapshots hold the contacts.
TOUCHING = {"output.contacts": "true", "drag.law": "hoef", "contact.restitution": "0.5", "output.checkpoint_interval": "60 s"}
SEEDS = range(1, 41)
TAU = 45e-6 / 5e-3  # [s]
END = 0.2           # [s]


def scratch():
    """A folder that the end of the process takes away."""
    made = pathlib.Path(tempfile.mkdtemp(prefix="clogflow-test-"))
    atexit.register(shutil.rmtree, made, ignore_errors=True)
    return made


@functools.cache
def folder():
    """scene.toml, flow.h5, runs/ (seeds 3 and 4), stats/"""
    return crash_inputs.make(PROGRAM, scratch() / "made")


@functools.cache
def touching():
    """A run of them."""
    words = [word for key, value in TOUCHING.items() for word in ("--set", f"{key}={value}")]
    subprocess.run([PROGRAM, "run", "scene.toml", "--flow", "flow.h5", "--out", "touching", "--seeds", "3", *words], cwd=folder(), check=True, capture_output=True)
    return folder() / "touching/run_0003.h5"


@functools.cache
def known():
    """A folder of runs with made-up passages: bursts with short lapses inside, arrests from a Pareto law between them."""
    made = folder() / "known"
    words = [word for key, value in STEADY.items() for word in ("--set", f"{key}={value}")]
    subprocess.run([PROGRAM, "run", "scene.toml", "--flow", "flow.h5", "--out", "known", "--seeds", "3", *words],
                   cwd=folder(), check=True, capture_output=True)
    model = made / "run_0003.h5"
    template = folder() / "template.h5"
    model.rename(template)
    random = np.random.default_rng(7)
    for seed in SEEDS:
        invent(template, made / f"run_{seed:04}.h5", seed, random)
    return made


def invent(template, file, seed, random):
    shutil.copy(template, file)
    times = []
    time = 0.0
    while time < END:
        for _ in range(random.geometric(0.3)):
            time += random.exponential(0.05 * TAU)
            times.append(time)
        time += 0.5 * TAU * random.pareto(1.2) + 0.5 * TAU  # survival (t / T_min)^-1.2: alpha 2.2
    times = np.array([t for t in times if t < END])
    columns = {"time": (times, "s"), "id": (np.arange(len(times)), "1"), "y": (np.zeros(len(times)), "m"),
               "z": (np.full(len(times), 5e-5), "m"), "friction_off": (np.zeros(len(times), np.uint8), "1")}
    with h5py.File(file, "r+") as opened:
        for name in list(opened["passages"]):
            del opened[f"passages/{name}"]
        for name, (values, unit) in columns.items():
            opened.create_dataset(f"passages/{name}", data=values).attrs["unit"] = np.bytes_(unit)
        opened["provenance/seed"][0] = seed
