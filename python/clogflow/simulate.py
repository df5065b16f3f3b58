"""Planning, solving the flow, running and sweeping, by the program. Scenes are files (TOML); `set` overrides their keys."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from .ensemble import Ensemble
from .errors import FileError, ProgramError
from .flow import Flow
from .program import HOUR, Value, bounded, call, overrides, written
from .run_file import Run


def scene_words(scene: str | Path, set: Mapping[str, Value] | None) -> list[str | Path]:
    """The scene and its overrides, as words of the command line."""
    return [Path(scene), *overrides("--set", set)]


def plan(scene: str | Path, *, set: Mapping[str, Value] | None = None, flow: Flow | str | Path | None = None,
         program: str | Path | None = None, timeout: float | None = HOUR) -> str:
    """What a scene needs and costs, in words (`clog plan`): dimensionless numbers, limits of the step, memory, time.
    Raises ProgramError with the program's line where the scene is refused."""
    return call(["plan", *scene_words(scene, set), *flow_words(flow)], program=program, timeout=timeout)


def solve_flow(scene: str | Path, folder: str | Path, *, set: Mapping[str, Value] | None = None,
               program: str | Path | None = None, timeout: float | None = HOUR) -> Flow:
    """Writes the OpenFOAM case of a scene into a folder, solves it and maps it: folder/flow.h5. A case that is solved
    already is not solved again. `timeout` [s] of each of the three steps. Raises ProgramError."""
    folder = Path(folder)
    call(["case", scene, folder, *overrides("--set", set)], program=program, timeout=timeout)
    bounded([str((folder / "Allrun").absolute())], timeout)
    call(["map", folder, "--out", folder / "flow.h5"], program=program, timeout=timeout)
    return Flow(folder / "flow.h5")


def run(scene: str | Path, out: str | Path, *, seeds: str | int | Sequence[int] | None = None,
        set: Mapping[str, Value] | None = None, sweep: Mapping[str, Sequence[object]] | None = None,
        flow: Flow | str | Path | None = None, until: str | None = None, tolerance: float | None = None,
        time_limit: str | None = None, ranks: int = 1, timeout: float | None = HOUR, progress: bool = False,
        program: str | Path | None = None) -> Ensemble:
    """Runs the seeds of a scene, one file a seed in the folder `out`; seeds that have a file are not run again.

    `seeds`: "1-40", 7 or [1, 2, 5] (None: those of the scene). `set`: {"particles.diameter": "22 um"}. `sweep`:
    {"particles.diameter": ["22 um", "25 um"]}, a folder for every value. `until`: only as many seeds as are enough, such
    as "bursts>=1000". `time_limit`: the program stops after this time, such as "55 min", with every state saved.
    `ranks`: processes, under mpirun. `timeout` [s]: see clogflow.program.call. `progress`: prints as it goes.
    Raises ProgramError with the program's line: a scene that is refused, a flow of another scene, a full disk.
    """
    words: list[str | Path] = ["run", *scene_words(scene, set), "--out", Path(out), *flow_words(flow)]
    words += ["--seeds", seed_text(seeds)] if seeds is not None else []
    words += overrides("--sweep", {key: ",".join(map(written, values)) for key, values in (sweep or {}).items()})
    words += ["--until", until] if until is not None else []
    words += ["--tolerance", repr(tolerance)] if tolerance is not None else []
    words += ["--time-limit", time_limit] if time_limit is not None else []
    said = call(words, program=program, timeout=timeout, ranks=ranks, progress=progress)
    try:
        return Ensemble(out, program=program)
    except FileError as error:
        last = said.strip().splitlines()[-1:] or ["nothing"]
        raise ProgramError(f"{out}: no run has ended yet; the program said: {last[0]}", 0, said) from error


def export(source: Run | Flow | str | Path, out: str | Path, *, format: str = "all", flow: Flow | str | Path | None = None,
           walls: bool = True, program: str | Path | None = None, timeout: float | None = HOUR) -> list[Path]:
    """Files for ParaView ("vtk"), OVITO ("xyz") or both ("all") of a run, or of a flow for ParaView (`clog export`).
    `flow`: that of the run, to be exported with it. Returns the files to open. Raises ProgramError."""
    path = source.path if isinstance(source, (Run, Flow)) else Path(source)
    words: list[str | Path] = ["export", path, "--out", Path(out), "--format", format, *flow_words(flow)]
    said = call(words + ([] if walls else ["--no-walls"]), program=program, timeout=timeout)
    return [Path(line) for line in said.splitlines()]


def flow_words(flow: Flow | str | Path | None) -> list[str | Path]:
    """--flow, if there is one."""
    return [] if flow is None else ["--flow", flow.path if isinstance(flow, Flow) else Path(flow)]


def seed_text(seeds: str | int | Sequence[int]) -> str:
    """As the program reads them: "1,2,5"."""
    return seeds if isinstance(seeds, str) else str(seeds) if isinstance(seeds, int) else ",".join(map(str, seeds))
