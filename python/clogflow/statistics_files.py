"""What `clog stats` computes, as tables. Nothing is computed here: one place for each definition (postprocess/README.md)."""

import json
import shutil
import tempfile
import weakref
from collections.abc import Iterable, Mapping
from functools import cached_property
from pathlib import Path

import pandas as pd

from .errors import FileError
from .program import HOUR, call

FORMAT, VERSION = "clogflow statistics", 1


class Statistics:
    """The folder that `clog stats` wrote. `groups` has an entry for each scene (several in a sweep), as stats.json.

    In every table the column `group` is the place in `groups`. Raises FileError where the folder holds no such statistics.
    """

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder)
        file = self.folder / "stats.json"
        try:
            self.data: dict = json.loads(file.read_text(encoding="utf-8"))
        except FileNotFoundError as error:
            raise FileError(f"{file}: no such file (made by clog stats, or clogflow.statistics)") from error
        except (OSError, ValueError) as error:
            raise FileError(f"{file}: cannot be read ({error})") from error
        if not isinstance(self.data, dict) or (self.data.get("format"), self.data.get("version")) != (FORMAT, VERSION):
            raise FileError(f"{file}: not statistics of version {VERSION} (run clog stats again)")
        self.groups: list[dict] = self.data["groups"]

    @cached_property
    def quantities(self) -> pd.DataFrame:
        """A row a number of a group: label, key, value with its interval of 95 % (low, high), unit, meaning, note.
        An unknown value is NaN, and `note` says why; a low or high beside it is a bound."""
        rows = [{"group": index, "label": group["label"], "key": key,
                 **{name: entry.get(name) for name in ("value", "low", "high", "unit", "meaning", "note")}}
                for index, group in enumerate(self.groups) for key, entry in group["quantities"].items()]
        return pd.DataFrame(rows).astype({"value": float, "low": float, "high": float})

    def quantity(self, key: str, group: int = 0) -> pd.Series:
        """One of them: `statistics.quantity("mean_burst").value`. Raises KeyError."""
        found = self.quantities.query("group == @group and key == @key")
        if found.empty:
            raise KeyError(f"no quantity {key!r} of group {group}; there are {', '.join(self.quantities['key'].unique())}")
        return found.iloc[0]

    def table(self, name: str) -> pd.DataFrame:
        """`name`.csv of the folder. Raises FileError where it is missing."""
        file = self.folder / f"{name}.csv"
        try:
            return pd.read_csv(file)
        except FileNotFoundError as error:
            raise FileError(f"{file}: no such table (run clog stats again)") from error
        except (OSError, ValueError) as error:
            raise FileError(f"{file}: cannot be read ({error})") from error

    @cached_property
    def bursts(self) -> pd.DataFrame:
        """What passed between two clogs: start, duration, size, kind."""
        return self.table("bursts")

    @cached_property
    def arrests(self) -> pd.DataFrame:
        """Lapses of at least T_min; `censored` where no passage ended them."""
        return self.table("arrests").astype({"censored": bool})

    @cached_property
    def lapses(self) -> pd.DataFrame:
        """Times between passages, and what ended each."""
        return self.table("lapses")

    @cached_property
    def arrest_survival(self) -> pd.DataFrame:
        """Kaplan-Meier estimate of the arrests, cut ones included."""
        return self.table("arrest_survival")

    @cached_property
    def first_bursts(self) -> pd.DataFrame:
        """The burst before the first clog of each seed; not `clogged`: the end of the run cut it."""
        return self.table("first_bursts").astype({"clogged": bool})

    @cached_property
    def first_burst_survival(self) -> pd.DataFrame:
        """Kaplan-Meier estimate: share of seeds that pass more than n particles before the first clog."""
        return self.table("first_burst_survival")

    @cached_property
    def points(self) -> pd.DataFrame:
        """A row a group: what the laws of a sweep are fitted to."""
        return self.table("points")

    def __repr__(self) -> str:
        return f"Statistics({str(self.folder)!r}: {', '.join(group['label'] for group in self.groups)})"


def statistics(sources: str | Path | Iterable[str | Path], *, out: str | Path | None = None, threshold: str | None = None,
               p_value: int | None = None, program: str | Path | None = None, timeout: float | None = HOUR) -> Statistics:
    """Bursts, arrests and fits of run files, by the program.

    `sources`: folders of runs (or of a sweep's folders), or single run files. `out`: a folder for stats.json and the
    tables; without it they live as long as the result. `threshold`: shortest lapse that is a clog, such as "3.3 ms".
    `p_value`: bootstrap replicates of the goodness of fit. `timeout` [s]. Raises ProgramError with the program's line.
    """
    paths = [Path(sources)] if isinstance(sources, (str, Path)) else [Path(source) for source in sources]
    kept = Path(tempfile.mkdtemp(prefix="clogflow-"))
    try:
        result = Statistics(_written(paths, kept, out, threshold, p_value, program, timeout))
    except BaseException:
        shutil.rmtree(kept, ignore_errors=True)
        raise
    weakref.finalize(result, shutil.rmtree, kept, ignore_errors=True)
    return result


def _written(paths: list[Path], kept: Path, out: str | Path | None, threshold: str | None, p_value: int | None,
             program: str | Path | None, timeout: float | None) -> Path:
    """The folder that the program wrote; what nobody asked to keep is in `kept`."""
    folders = [path for path in paths if not path.is_file()]
    files = [path for path in paths if path.is_file()]
    if files:
        # The program takes folders; under a name of its own each may come from any place.
        linked = kept / "runs"
        linked.mkdir()
        for number, file in enumerate(files):
            (linked / f"run_{number:06}.h5").symlink_to(file.resolve())
        folders.append(linked)
    into = Path(out) if out is not None else kept / "stats"
    words: list[str | Path] = ["stats", *folders, "--out", into]
    words += ["--threshold", threshold] if threshold is not None else []
    words += ["--p-value", str(p_value)] if p_value is not None else []
    call(words, program=program, timeout=timeout)
    return into


def fit(values: Iterable[float], *, xmin: float | None = None, p_value: int | None = None, discrete: bool | None = None,
        program: str | Path | None = None, timeout: float | None = HOUR) -> Mapping[str, object]:
    """Power-law fit of numbers as Clauset, Shalizi and Newman (2009), by the program (`clog fit`): alpha, sigma, xmin,
    n_tail, ks and the exponential law beside it. `xmin` fixes the lower end; `discrete`: the law of whole numbers
    (None: if they are). Raises ProgramError."""
    with tempfile.TemporaryDirectory(prefix="clogflow-") as folder:
        column = Path(folder) / "values.txt"
        column.write_text("".join(f"{float(value)!r}\n" for value in values), encoding="utf-8")
        words: list[str | Path] = ["fit", column]
        words += ["--xmin", repr(float(xmin))] if xmin is not None else []
        words += ["--p-value", str(p_value)] if p_value is not None else []
        words += [] if discrete is None else ["--discrete" if discrete else "--continuous"]
        return json.loads(call(words, program=program, timeout=timeout))
