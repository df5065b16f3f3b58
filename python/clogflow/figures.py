"""The figures of `clog report` as functions: each gives a matplotlib figure of an ensemble, a run, or statistics.

They are drawn by the scripts of postprocess/figures, which `clog report` runs too, in the report's look; the settings of
matplotlib are left as they are. The folder of the scripts: the environment's CLOG_FIGURES, or that of the sources or
the installation. `save` writes one as the report does.
"""

import importlib
import os
import sys
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Union

from .errors import ClogflowError, FileError
from .program import TOP, find_program

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .ensemble import Ensemble
    from .run_file import Run
    from .statistics_files import Statistics

    Source = Union[Ensemble, Run, Statistics]

MODULES = ("style", "channel", "run_file", "stats_files", "arch", "fig_trend", "fig_snapshots", "fig_spatiotemporal", "fig_necks",
           "fig_first_burst", "fig_bursts", "fig_lapses", "fig_series")


def folder_of_scripts() -> Path:
    """Raises FileError where they are not found."""
    given = os.environ.get("CLOG_FIGURES")
    candidates = [Path(given)] if given else [TOP / "postprocess/figures"]
    if not given:
        try:
            program = find_program().resolve()
        except ClogflowError:
            pass
        else:  # build/release/bin/clog of the sources, bin/clog of an installation
            candidates += [program.parents[3] / "postprocess/figures", program.parents[1] / "share/clogflow/postprocess/figures"]
    for folder in candidates:
        if (folder / "style.py").is_file():
            return folder
    raise FileError(f"{candidates[0]}: no figure scripts there (set CLOG_FIGURES to the folder postprocess/figures)")


@cache
def scripts() -> dict[str, ModuleType]:
    """The modules of the scripts. Their names (style, channel ...) are too general to stay those of a user's modules."""
    import matplotlib
    hidden = {name: sys.modules.pop(name) for name in MODULES if name in sys.modules}
    sys.path.insert(0, str(folder_of_scripts()))
    try:
        with matplotlib.rc_context():
            return {name: importlib.import_module(name) for name in MODULES}
    except ImportError as error:
        raise ClogflowError(f"{sys.path[0]}: the figure scripts cannot be loaded ({error})") from error
    finally:
        del sys.path[0]
        for name in MODULES:
            sys.modules.pop(name, None)
        sys.modules.update(hidden)


def drawn(module: str, source: "Source") -> "dict[str, Figure]":
    """All figures of a script, by name."""
    import matplotlib
    statistics = getattr(source, "statistics", source)
    modules = scripts()
    with matplotlib.rc_context(modules["style"].LOOK):
        return dict(modules[module].figures(modules["stats_files"].Statistics(statistics.folder)))


def named(module: str, name: str, source: "Source", group: int | None = None) -> "Figure":
    """One of them; `group`: of a sweep's entry. Raises ClogflowError where there is none."""
    import matplotlib.pyplot as plt
    figures = drawn(module, source)
    several = len(getattr(source, "statistics", source).groups) > 1
    wanted = f"{name}_{group}" if group is not None and several else name
    for other, figure in figures.items():
        if other != wanted:
            plt.close(figure)
    if wanted not in figures:
        raise ClogflowError(f"no figure {wanted!r} of these runs (drawn are: {', '.join(figures) or 'none'})")
    return figures[wanted]


def bursts(source: "Source") -> "Figure":
    """Distribution of the burst sizes; of a sweep the mean burst along it too."""
    return named("fig_bursts", "bursts", source)


def lapses(source: "Source") -> "Figure":
    """Lapses between passages and survival of arrests, with their fits; of a sweep alpha along it too."""
    return named("fig_lapses", "lapses", source)


def first_burst(source: "Source") -> "Figure":
    """Passages until the first clog: survival and hazard. Raises ClogflowError unless `unclog.protocol = "stop"`."""
    return named("fig_first_burst", "first_burst", source)


def spatiotemporal(source: "Source") -> "Figure":
    """When anything passes the neck, a row a seed."""
    return named("fig_spatiotemporal", "spatiotemporal", source)


def spatiotemporal_sweep(source: "Source") -> "Figure":
    """The same for the first seed of each ensemble of a sweep. Raises ClogflowError of a single ensemble."""
    return named("fig_spatiotemporal", "spatiotemporal_sweep", source)


def snapshots(source: "Source", group: int = 0) -> "Figure":
    """Arch, burst and new arch, if they were recorded; else three moments of a run. `group`: which entry of a sweep."""
    return named("fig_snapshots", "snapshots", source, group)


def necks(source: "Source", group: int = 0) -> "Figure":
    """Passages and mean burst of each of several necks. Raises ClogflowError where there is one."""
    return named("fig_necks", "necks", source, group)


def series(source: "Source", group: int = 0) -> "Figure":
    """How the channel fills and stays full. `group`: which entry of a sweep."""
    return named("fig_series", "series", source, group)


def save(figure: "Figure", folder: str | Path, name: str) -> list[Path]:
    """As PNG, SVG and PDF, as the report does; makes the folder if need be and closes the figure. Returns the paths."""
    import matplotlib
    style = scripts()["style"]
    Path(folder).mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context(style.LOOK):
        return style.save(figure, folder, name)
