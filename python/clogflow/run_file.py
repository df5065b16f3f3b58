"""One seed: run_NNNN.h5 as tables and arrays."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import pandas as pd

from .errors import FileError
from .hdf5 import File, opened
from .scene import Scene
from .tables import column_name

FORMAT = "clogflow run"

# group, dataset, unit; those of OPTIONAL are in some files only.
COLUMNS = {
    "passages": {"time": "s", "id": "1", "y": "m", "z": "m", "friction_off": "1"},
    "releases": {"off": "s", "on": "s", "largest_speed": "m/s", "position": "m"},
    "series": {"time": "s", "count": "1", "packing_fraction": "1", "kinetic_energy": "J", "elastic_energy": "J",
               "largest_overlap": "m", "contacts": "1", "wall_contacts": "1", "drag_work": "J", "dissipated": "J",
               "median_speed": "m/s", "speed_q99": "m/s"},
}
OPTIONAL = {
    "passages": {"neck": "1", "radius": "m", "species": "1"},
    "releases": {},
    "series": {"flow_factor": "1", "pressure_drop": "Pa"},
}
CONTACTS = {"a": "1", "b": "1", "normal": "1", "force": "N"}
PARTICLES = {"id": "1", "radius": "m", "position": "m", "velocity": "m/s", "spin": "rad/s", "force": "N", "torque": "N m"}


@dataclass(frozen=True)
class Contacts:
    """Who touches whom at one time, and how hard (`output.contacts`). Arrays have a row a contact; SI units. Films are none."""

    a: np.ndarray  #: [m] id of a particle
    b: np.ndarray  #: [m] id of the other, larger than a; -1 is a wall
    normal: np.ndarray  #: [m, 3] from b to a, single precision
    force: np.ndarray  #: [m, 3] on a, along the normal and across it; b gets the opposite [N]

    def __len__(self) -> int:
        return len(self.a)

    @property
    def normal_force(self) -> np.ndarray:
        """[m] along the normal: above 0 presses, below pulls [N]"""
        return np.sum(self.normal * self.force, axis=1)


@dataclass(frozen=True)
class Snapshot:
    """All particles at one time. Arrays have a row a particle; SI units."""

    time: float  #: [s]
    id: np.ndarray  #: [n]
    radius: np.ndarray  #: [n] [m]
    position: np.ndarray  #: [n, 3]: along the flow, across, up [m]
    velocity: np.ndarray  #: [n, 3] [m/s]
    spin: np.ndarray  #: [n, 3] [rad/s]
    force: np.ndarray  #: [n, 3] of all kinds together [N]
    torque: np.ndarray  #: [n, 3] [N m]
    species: np.ndarray | None  #: [n] place in particles.species; None where particles are equal
    contacts: Contacts | None = None  #: None where they were not recorded (output.contacts)

    def __len__(self) -> int:
        return len(self.id)

    @property
    def speed(self) -> np.ndarray:
        """[n] magnitude of the velocity [m/s]"""
        return np.linalg.norm(self.velocity, axis=1)


class Snapshots(Sequence):
    """The snapshots of a run in the order of time; each is read when it is asked for. Slices give lists."""

    def __init__(self, path: Path) -> None:
        self._path = path
        with opened(path, FORMAT) as file:
            self.times = file.numbers("snapshots/time", "s")  #: [s]
            first = file.numbers("snapshots/first", "1")
            end = file.dataset("snapshots/id", "1").shape[0]
        self._rows = np.append(first, end)
        if len(first) != len(self.times) or np.any(np.diff(self._rows) < 0):
            raise FileError(f"{path}: /snapshots/first does not say where the snapshots begin (the file is damaged)")
        with opened(path, FORMAT) as file:
            self._links = np.append(file.numbers("contacts/first", "1"), file.dataset("contacts/a", "1").shape[0]) if "contacts/first" in file else None
        if self._links is not None and (len(self._links) != len(first) + 1 or np.any(np.diff(self._links) < 0)):
            raise FileError(f"{path}: /contacts/first does not say where the contacts of a snapshot begin (the file is damaged)")

    def __len__(self) -> int:
        return len(self.times)

    def __getitem__(self, index: int | slice) -> "Snapshot | list[Snapshot]":
        if isinstance(index, slice):
            return [self._read(k) for k in range(*index.indices(len(self)))]
        k = index + len(self) if index < 0 else index
        if not 0 <= k < len(self):
            raise IndexError(f"snapshot {index} of {len(self)}")
        return self._read(k)

    def at(self, time: float) -> Snapshot:
        """The one closest to a time [s]. Raises FileError where there is none."""
        if not len(self):
            raise FileError(f"{self._path}: no snapshots (output.snapshot_interval)")
        return self._read(int(np.argmin(np.abs(self.times - time))))

    def _read(self, k: int) -> Snapshot:
        rows = slice(int(self._rows[k]), int(self._rows[k + 1]))
        with opened(self._path, FORMAT) as file:
            columns = {name: file.numbers(f"snapshots/{name}", unit, rows) for name, unit in PARTICLES.items()}
            species = file.numbers("snapshots/species", "1", rows) if "snapshots/species" in file else None
            contacts = None
            if self._links is not None:
                within = slice(int(self._links[k]), int(self._links[k + 1]))
                contacts = Contacts(**{name: file.numbers(f"contacts/{name}", unit, within) for name, unit in CONTACTS.items()})
        return Snapshot(time=float(self.times[k]), species=species, contacts=contacts, **columns)


class Run:
    """What one seed produced: `clogflow.Run("run_0001.h5").passages`.

    Tables are pandas tables whose columns of reals carry their SI unit, as those of `clog stats` do: `"time [s]"`;
    ids, counts and flags have none. They are read when asked for, and kept. Bursts, arrests and lapses are computed by
    the program, not here. Raises FileError where the file is missing, cut short, damaged or of another kind.
    """

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        with opened(self.path, FORMAT) as file:
            self.seed = int(file.numbers("provenance/seed", "1")[0])
            self.end_time = float(file.numbers("end_time", "s")[0])  #: simulated [s]
            self.scene = Scene(file.text("provenance/scene"), str(self.path))
            self.provenance: dict = file.record()  #: program, revision, host, wall time ...: files/run_record.hpp

    @property
    def clogged_at(self) -> float | None:
        """When the clog began that ended the run [s]; None: the run did not end by one."""
        return self.provenance.get("clogged_at_s")

    @cached_property
    def passages(self) -> pd.DataFrame:
        """A row a particle that passed for the first time: time, id, y, z, friction_off, and neck, radius, species
        where there are several necks or sizes."""
        table = self._table("passages")
        return table.astype({"friction_off": bool})

    @cached_property
    def releases(self) -> pd.DataFrame:
        """A row a clog that was cleared: friction was off in [off, on); equal where an arch was taken out."""
        return self._table("releases")

    @cached_property
    def series(self) -> pd.DataFrame:
        """A row a sample: counts, packing fraction, energies, speeds, and the porosity of each strip of the upstream
        channel from the inlet on (`"porosity_1 [1]"` ...)."""
        table = self._table("series")
        with opened(self.path, FORMAT) as file:
            porosity = file.numbers("series/porosity", "1")
        if porosity.ndim != 2 or len(porosity) != len(table):
            raise FileError(f"{self.path}: /series/porosity is not one row a sample (the file is damaged)")
        strips = {f"porosity_{k + 1} [1]": porosity[:, k] for k in range(porosity.shape[1])}
        return table.assign(**strips)

    @cached_property
    def snapshots(self) -> Snapshots:
        """All particles at some times (output.snapshot_interval), as numpy arrays."""
        return Snapshots(self.path)

    @cached_property
    def statistics(self) -> "Statistics":
        """What `clog stats` says of this run alone. Raises ProgramError."""
        from .statistics_files import statistics
        return statistics(self.path)

    @property
    def bursts(self) -> pd.DataFrame:
        """A row a burst, by the program: start, duration, size, kind (postprocess/README.md). Raises ProgramError."""
        return self.statistics.bursts

    @property
    def arrests(self) -> pd.DataFrame:
        """A row a lapse of at least T_min, by the program; `censored` where no passage ended it. Raises ProgramError."""
        return self.statistics.arrests

    @property
    def lapses(self) -> pd.DataFrame:
        """A row a time between passages, by the program. Raises ProgramError."""
        return self.statistics.lapses

    def _table(self, group: str) -> pd.DataFrame:
        with opened(self.path, FORMAT) as file:
            columns = {column_name(name, unit, file.dataset(f"{group}/{name}", unit)): file.numbers(f"{group}/{name}", unit)
                       for name, unit in present(file, group).items()}
        if len({len(column) for column in columns.values()}) > 1:
            raise FileError(f"{self.path}: the columns of /{group} have different lengths (the file is damaged)")
        return pd.DataFrame(columns)

    def __repr__(self) -> str:
        return f"Run({str(self.path)!r}: seed {self.seed}, {self.end_time:.4g} s)"


def present(file: File, group: str) -> dict[str, str]:
    """Columns of a table that this file has, with their units."""
    return COLUMNS[group] | {name: unit for name, unit in OPTIONAL[group].items() if f"{group}/{name}" in file}
