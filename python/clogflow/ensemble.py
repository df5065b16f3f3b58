"""Many seeds of a scene, or of the scenes of a sweep."""

from functools import cached_property
from pathlib import Path

import pandas as pd

from .errors import FileError
from .run_file import Run
from .statistics_files import Statistics, statistics


class Ensemble:
    """A folder with run_*.h5, or a sweep's folder of such folders: `clogflow.Ensemble("runs/d22").bursts`.

    Passages, releases and series are those of its runs one after another, with the columns `point` (the folder of a
    sweep, else "") and `seed`; bursts, arrests and all numbers are the program's. Raises FileError where there is no run.
    """

    def __init__(self, folder: str | Path, program: str | Path | None = None) -> None:
        self.folder = Path(folder)
        self._program = program
        if not self.folder.is_dir():
            raise FileError(f"{self.folder}: no such folder (made by clog run, or clogflow.run)")
        files = sorted(self.folder.glob("run_*.h5")) or sorted(self.folder.glob("*/run_*.h5"))
        if not files:
            raise FileError(f"{self.folder}: no run_*.h5 here or one folder below (clog run writes them)")
        self.runs: list[Run] = sorted(map(Run, files), key=lambda run: (str(run.path.parent), run.seed))

    def point_of(self, run: Run) -> str:
        """Folder of a run within a sweep, or ""."""
        name = str(run.path.parent.relative_to(self.folder))
        return "" if name == "." else name

    def _together(self, table: str) -> pd.DataFrame:
        parts = []
        for run in self.runs:
            part = getattr(run, table).copy()
            part.insert(0, "seed", run.seed)
            part.insert(0, "point", self.point_of(run))
            parts.append(part)
        return pd.concat(parts, ignore_index=True)

    @cached_property
    def passages(self) -> pd.DataFrame:
        """Run.passages of all runs."""
        return self._together("passages")

    @cached_property
    def releases(self) -> pd.DataFrame:
        """Run.releases of all runs."""
        return self._together("releases")

    @cached_property
    def series(self) -> pd.DataFrame:
        """Run.series of all runs."""
        return self._together("series")

    @cached_property
    def statistics(self) -> Statistics:
        """What `clog stats` says of the folder. Raises ProgramError, also where runs of different scenes are mixed."""
        return statistics(self.folder, program=self._program)

    @property
    def bursts(self) -> pd.DataFrame:
        """Statistics.bursts"""
        return self.statistics.bursts

    @property
    def arrests(self) -> pd.DataFrame:
        """Statistics.arrests"""
        return self.statistics.arrests

    @property
    def lapses(self) -> pd.DataFrame:
        """Statistics.lapses"""
        return self.statistics.lapses

    @property
    def first_bursts(self) -> pd.DataFrame:
        """Statistics.first_bursts"""
        return self.statistics.first_bursts

    @property
    def quantities(self) -> pd.DataFrame:
        """Statistics.quantities"""
        return self.statistics.quantities

    def __len__(self) -> int:
        return len(self.runs)

    def __iter__(self):
        return iter(self.runs)

    def __repr__(self) -> str:
        return f"Ensemble({str(self.folder)!r}: {len(self.runs)} runs)"
