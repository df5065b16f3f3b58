"""Reads the parts of a run file (run_NNNN.h5) that the figures need."""

from dataclasses import dataclass

import h5py
import numpy as np


@dataclass
class Events:
    passage_times: np.ndarray  # with friction on [s]
    release_times: np.ndarray  # friction switched off [s]
    release_ends: np.ndarray   # and on again [s]
    passage_necks: np.ndarray  # of the passages; 0 where there is one neck


@dataclass
class Snapshot:
    time: float           # [s]
    position: np.ndarray  # [n][3] [m]
    speed: np.ndarray     # [n] [m/s]
    radius: np.ndarray    # [n] [m]


def read_events(path):
    with h5py.File(path, "r") as file:
        time = file["passages/time"][:]
        off = file["passages/friction_off"][:].astype(bool)
        neck = file["passages/neck"][:] if "passages/neck" in file else np.zeros(len(time), dtype=int)
        return Events(time[~off], file["releases/off"][:], file["releases/on"][:], neck[~off])


def read_series(path):
    """Columns of the time series; porosity is [sample][strip]. Those of a flow that is not steady are there if it is not."""
    always, driven = ("time", "count", "packing_fraction", "porosity"), ("flow_factor", "pressure_drop")
    with h5py.File(path, "r") as file:
        return {name: file[f"series/{name}"][:] for name in always + driven if name in always or name in file["series"]}


def snapshot_times(path):
    with h5py.File(path, "r") as file:
        return file["snapshots/time"][:]


def read_snapshot(path, time):
    """The snapshot recorded closest to a time [s]."""
    with h5py.File(path, "r") as file:
        group = file["snapshots"]
        times = group["time"][:]
        k = int(np.argmin(np.abs(times - time)))
        first = group["first"][:]
        end = first[k + 1] if k + 1 < len(first) else len(group["id"])
        rows = slice(int(first[k]), int(end))
        speed = np.linalg.norm(group["velocity"][rows], axis=1)
        return Snapshot(float(times[k]), group["position"][rows], speed, group["radius"][rows])
