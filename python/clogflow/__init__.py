"""Runs, ensembles, flows and statistics of clogflow as tables, arrays and figures; docs/python.md.

    import clogflow
    ensemble = clogflow.run("scenes/paper.toml", "runs/d22", seeds="1-8", flow="flow.h5", set={"particles.diameter": "22 um"})
    ensemble.runs[0].passages          # pandas table: "time [s]", "id", "y [m]", "z [m]", "friction_off"
    ensemble.bursts                    # of `clog stats`
    ensemble.statistics.quantity("mean_burst")
    clogflow.figures.bursts(ensemble)  # matplotlib figure
"""

from . import figures
from .ensemble import Ensemble
from .errors import ClogflowError, FileError, ProgramError
from .flow import Flow
from .program import TOP as _TOP
from .program import find_program
from .run_file import Contacts, Run, Snapshot, Snapshots
from .scene import Scene
from .simulate import export, plan, run, solve_flow
from .statistics_files import Statistics, fit, statistics
from .tables import units

__version__ = "0.2.0"
SCENES = _TOP / "scenes"  #: folder of the scenes that come with the program
__all__ = ["ClogflowError", "Contacts", "Ensemble", "FileError", "Flow", "ProgramError", "Run", "SCENES", "Scene", "Snapshot", "Snapshots",
           "Statistics", "export", "figures", "find_program", "fit", "plan", "run", "solve_flow", "statistics", "units"]
