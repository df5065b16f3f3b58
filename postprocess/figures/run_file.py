"""Reads the parts of a run file (run_NNNN.h5) that the figures need."""

import json
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np


@dataclass
class Events:
    passage_times: np.ndarray  # with friction on [s]
    release_times: np.ndarray  # friction switched off [s]
    release_ends: np.ndarray   # and on again [s]
    passage_necks: np.ndarray  # of the passages; 0 where there is one neck


WALL = -1  # in place of a particle


@dataclass
class Contacts:
    a: np.ndarray       # [m] row of the particle in its snapshot
    b: np.ndarray       # [m] of the other, or WALL
    normal: np.ndarray  # [m][3] from b to a
    force: np.ndarray   # [m] along it: above 0 presses, below pulls [N]

    def among(self, kept):
        """Those between particles that are kept (a flag each), or with a wall; rows count these alone."""
        row = np.append(np.where(kept, np.cumsum(kept) - 1, -2), WALL)  # the last stands for the wall
        a, b = row[self.a], row[self.b]
        whole = (a >= 0) & (b >= WALL)
        return Contacts(a[whole], b[whole], self.normal[whole], self.force[whole])


@dataclass
class Snapshot:
    time: float           # [s]
    position: np.ndarray  # [n][3] [m]
    speed: np.ndarray     # [n] [m/s]
    radius: np.ndarray    # [n] [m]
    contacts: Contacts = None  # where they were recorded (output.contacts)

    def beyond(self, x):
        """Those that lie downstream of a place [m]."""
        kept = self.position[:, 0] >= x
        return Snapshot(self.time, self.position[kept], self.speed[kept], self.radius[kept], self.contacts and self.contacts.among(kept))


@contextmanager
def opened(path):
    """The root of a run file; "pack.h5/run_0001.h5" is a group in a pack (clog pack)."""
    path = Path(path)
    with h5py.File(path.parent if path.parent.is_file() else path, "r") as file:
        yield file[path.name] if path.parent.is_file() else file


def read_events(path):
    with opened(path) as file:
        time = file["passages/time"][:]
        off = file["passages/friction_off"][:].astype(bool)
        neck = file["passages/neck"][:] if "passages/neck" in file else np.zeros(len(time), dtype=int)
        return Events(time[~off], file["releases/off"][:], file["releases/on"][:], neck[~off])


def read_series(path):
    """Columns of the time series; porosity is [sample][strip]. Those of a flow that is not steady are there if it is not."""
    always, driven = ("time", "count", "packing_fraction", "porosity"), ("flow_factor", "pressure_drop")
    with opened(path) as file:
        return {name: file[f"series/{name}"][:] for name in always + driven if name in always or name in file["series"]}


def read_record(path):
    """Who wrote the file, where, how fast: coupling/files/run_record.hpp."""
    with opened(path) as file:
        return json.loads(file["provenance/record"][()].decode())


def snapshot_times(path):
    with opened(path) as file:
        return file["snapshots/time"][:]


def read_snapshots(path, places):
    """Those with these numbers, the first is 0."""
    with opened(path) as file:
        group = file["snapshots"]
        times = group["time"][:]
        first = [*group["first"][:], len(group["id"])]
        links = file.get("contacts")
        begins = [*links["first"][:], len(links["a"])] if links else None

        def contacts_of(k, ids):
            within = slice(int(begins[k]), int(begins[k + 1]))
            order = np.argsort(ids)

            def row(name):
                return order[np.searchsorted(ids, links[name][within], sorter=order).clip(max=len(ids) - 1)] if len(ids) else np.zeros(0, int)

            normal = links["normal"][within]
            return Contacts(row("a"), np.where(links["b"][within] < 0, WALL, row("b")), normal, np.sum(normal * links["force"][within], axis=1))

        def one(k):
            rows = slice(int(first[k]), int(first[k + 1]))
            return Snapshot(float(times[k]), group["position"][rows], np.linalg.norm(group["velocity"][rows], axis=1), group["radius"][rows],
                            contacts_of(k, group["id"][rows]) if links else None)

        return [one(k) for k in places]


def read_snapshot(path, time):
    """The snapshot recorded closest to a time [s]."""
    return read_snapshots(path, [int(np.argmin(np.abs(snapshot_times(path) - time)))])[0]
