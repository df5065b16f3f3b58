"""Opens the program's HDF5 files and refuses what is none of them. The formats: coupling/FORMATS.md."""

import contextlib
import json
from collections.abc import Iterator
from pathlib import Path

import h5py
import numpy as np

from .errors import FileError

VERSION = 1
MAKES = {"clogflow run": "clog run", "clogflow flow": "clog map"}
OPENS = {"clogflow run": "clogflow.Run", "clogflow flow": "clogflow.Flow"}


class File:
    """An open file of one format, whose reads are checked."""

    def __init__(self, path: Path, file: h5py.File) -> None:
        self.path = path
        self._file = file

    def __contains__(self, name: str) -> bool:
        return name in self._file

    def dataset(self, name: str, unit: str) -> h5py.Dataset:
        """A dataset of numbers. Raises FileError where it is missing or its unit is not the one expected."""
        found = self._file.get(name)
        if not isinstance(found, h5py.Dataset):
            raise FileError(f"{self.path}: /{name} is missing (the file was written by another program or is damaged)")
        written = text(found.attrs.get("unit"))
        if written != unit:
            raise FileError(f"{self.path}: /{name} has the unit {written!r}, not {unit!r}")
        return found

    def numbers(self, name: str, unit: str, rows: slice = slice(None)) -> np.ndarray:
        """The numbers, or some rows of them. Raises FileError likewise."""
        return np.asarray(self.dataset(name, unit)[rows])

    def text(self, name: str) -> str:
        """A text. Raises FileError where it is missing."""
        found = self._file.get(name)
        if not isinstance(found, h5py.Dataset):
            raise FileError(f"{self.path}: /{name} is missing (the file was written by another program or is damaged)")
        return text(found[()])

    def record(self) -> dict:
        """Where the file comes from, entry by entry. Raises FileError where it cannot be read."""
        try:
            return json.loads(self.text("provenance/record"))
        except json.JSONDecodeError as error:
            raise FileError(f"{self.path}: /provenance/record is no JSON ({error})") from error

    def attribute(self, path: str, name: str) -> np.ndarray:
        """Numbers of an attribute. Raises FileError where it is missing."""
        if path not in self._file or name not in self._file[path].attrs:
            raise FileError(f"{self.path}: /{path}@{name} is missing (the file is damaged)")
        return np.asarray(self._file[path].attrs[name])


def text(value: object) -> str:
    """Text of an attribute or a dataset, which h5py gives as bytes or as str."""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else "" if value is None else str(value)


@contextlib.contextmanager
def opened(path: str | Path, kind: str) -> Iterator[File]:
    """The file, closed again at the end. Raises FileError: missing, cut short, damaged, another format or version."""
    path = Path(path)
    if not path.exists():
        raise FileError(f"{path}: no such file (made by {MAKES[kind]})")
    if path.is_dir():
        raise FileError(f"{path}: a folder, not a file (clogflow.Ensemble opens a folder of run files)")
    try:
        with h5py.File(path, "r") as file:
            check_kind(path, file, kind)
            yield File(path, file)
    except OSError as error:
        if isinstance(error, PermissionError):
            raise FileError(f"{path}: cannot be read (no permission)") from error
        raise FileError(f"{path}: {damage(path, str(error))}") from error


def damage(path: Path, said: str) -> str:
    """What the HDF5 library means."""
    if "truncated" in said:
        return "cut short (copy it again, or make it again)"
    if "signature not found" in said:
        return "no HDF5 file" + (" (it is empty)" if path.stat().st_size == 0 else "")
    return f"damaged: copy it again, or make it again ({said.splitlines()[0]})"


def check_kind(path: Path, file: h5py.File, kind: str) -> None:
    """Raises FileError unless the file is of that format, in the version that is read here."""
    found, version = text(file.attrs.get("format")), file.attrs.get("version")
    if found != kind:
        if found in OPENS:
            raise FileError(f"{path}: a \"{found}\" file, not a \"{kind}\" file (open it with {OPENS[found]})")
        what = f"a \"{found}\" file" if found else "an HDF5 file of another program"
        raise FileError(f"{path}: {what}, not a \"{kind}\" file (made by {MAKES[kind]})")
    if version is None or int(version) != VERSION:
        raise FileError(f"{path}: version {version} of \"{kind}\"; this package reads version {VERSION}")
