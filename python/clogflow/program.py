"""Finds the program `clog` and calls it: bounded, and with its own line as the error."""

import os
import shutil
import signal
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from .errors import ProgramError

TOP = Path(__file__).resolve().parents[2]  # of the sources, or share/clogflow of an installation
HOUR = 3600.0
TIME_TO_SAVE = 60.0  # for a program that was asked to stop, to save its states [s]

Value = str | int | float | bool | Sequence[object]


def find_program(program: str | Path | None = None) -> Path:
    """The program: the argument, the environment's CLOG, that of the sources or the installation this package lies in,
    or one named clogflow or clog in PATH. Raises ProgramError where there is none.

    Debian has another program named clog, a log viewer; of PATH only one that says it is ours is taken.
    """
    for given, name in ((program, "program"), (os.environ.get("CLOG"), "the environment's CLOG")):
        if given:
            found = shutil.which(str(given))
            if found is None:
                raise ProgramError(f"{given}: no program there ({name})")
            return Path(found).absolute()
    near = (TOP / "build/release/bin/clog", TOP.parents[1] / "bin/clogflow", TOP.parents[1] / "bin/clog")
    for candidate in (*near, shutil.which("clogflow"), shutil.which("clog")):
        if candidate and os.access(candidate, os.X_OK) and is_ours(candidate):
            return Path(candidate).absolute()
    raise ProgramError(f"the program clog was not found: build it (./Allwmake clog), or set CLOG to its path (looked in {TOP} and PATH)")


def is_ours(program: str | Path) -> bool:
    """Whether a program of this name is clogflow's."""
    try:
        said = subprocess.run([program, "--help"], capture_output=True, text=True, timeout=10, check=False).stdout
    except (OSError, subprocess.TimeoutExpired):
        return False
    return "clogflow" in said


def overrides(option: str, values: Mapping[str, Value] | None) -> list[str]:
    """`{"time.end": "1 s"}` as words of the command line. Texts as they are, other values as TOML."""
    return [word for key, value in (values or {}).items() for word in (option, f"{key}={written(value)}")]


def written(value: Value) -> str:
    """A value as the program reads it after `key=`."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return value
    if isinstance(value, Sequence):
        return "[" + ", ".join(f'"{entry}"' if isinstance(entry, str) else written(entry) for entry in value) + "]"
    return repr(value.item() if hasattr(value, "item") else value)


def call(words: Sequence[str | Path], *, program: str | Path | None = None, timeout: float | None = HOUR,
         ranks: int = 1, progress: bool = False) -> str:
    """Calls the program and gives what it printed.

    `timeout`: longest time [s], None without end; then the program is asked to stop, which saves the states of runs,
    and ended if it does not. `ranks`: processes under mpirun. `progress`: it prints to the terminal, not to the result.
    Raises ProgramError with the program's line.
    """
    command = [str(find_program(program)), *map(str, words)]
    if ranks > 1:
        if shutil.which("mpirun") is None:
            raise ProgramError(f"{ranks} ranks need mpirun, which is not installed (openmpi-bin)")
        command = ["mpirun", "-np", str(ranks), "--bind-to", "none", "--oversubscribe", *command]
    return bounded(command, timeout, progress)


def environment() -> dict[str, str]:
    """Open MPI refuses root unless told."""
    allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"} if os.geteuid() == 0 else {}
    return {**os.environ, **allowed}


def bounded(command: Sequence[str], timeout: float | None, progress: bool = False,
            folder: str | Path | None = None) -> str:
    """Runs a command in a session of its own, so that it can be ended with all that it started. Raises ProgramError."""
    try:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=None if progress else subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, errors="replace", start_new_session=True,
                                   env=environment(), cwd=folder)
    except OSError as error:
        raise ProgramError(f"{command[0]}: cannot be started ({error.strerror})") from error
    try:
        out, err = process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired as error:
        out, err = ended(process)
        raise ProgramError(f"stopped after {timeout:g} s (timeout); runs have saved their states, and the same call goes on",
                           None, (out or "") + err) from error
    except BaseException:
        ended(process)
        raise
    if process.returncode != 0:
        raise ProgramError(error_line(command, err, process.returncode), process.returncode, (out or "") + err)
    return out or ""


def ended(process: subprocess.Popen) -> tuple[str, str]:
    """Asks to stop, waits, ends."""
    process.terminate()
    try:
        return process.communicate(timeout=TIME_TO_SAVE)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        return process.communicate()


def error_line(command: Sequence[str], said: str, status: int) -> str:
    """The program's own line; of a wrong usage its first one."""
    lines = [line for line in said.splitlines() if line.strip()]
    ours = [line.split(": ", 1)[1] for line in lines if line.startswith(("clog: ", "clogflow: "))]
    if ours:
        return ours[-1]
    if lines:
        return lines[0] if status == 2 else lines[-1]
    return f"{command[0]} ended with status {status} and said nothing"
