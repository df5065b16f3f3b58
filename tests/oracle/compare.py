"""Compares the HDF5 files of two folders, or two such files: names, types, shapes, every byte, every attribute."""

import json
from pathlib import Path

import h5py
import numpy as np

# What the clock, the machine or the build writes; none of it is a result. The state that a run ends with holds its seconds.
ASIDE = {"wall_time_s", "processor_time_s", "particle_steps_per_s", "host", "date", "revision", "compiler", "program", "program_version",
         "openfoam_log", "end_state", "inputs_hash", "flow_hash", "flow_file", "resumed", "hash"}


def files_below(place):
    place = Path(place)
    if place.is_file():
        return {"": place}
    return {str(file.relative_to(place)): file for file in sorted(place.rglob("*.h5"))}


def contents(file):
    """\\return every group, dataset and attribute of a file by its path"""
    found = {}

    def visit(path, thing):
        found[path] = None if isinstance(thing, h5py.Group) else thing[()]
        for name, value in thing.attrs.items():
            found[f"{path}@{name}"] = value

    with h5py.File(file, "r") as h5:
        for name, value in h5.attrs.items():
            found[f"@{name}"] = value
        h5.visititems(visit)
    return found


def as_text(value):
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, np.ndarray) and value.shape == () and value.dtype.kind in "SO":
        return as_text(value[()])
    return value if isinstance(value, str) else None


def without_aside(path, value):
    """The value with everything that is no result taken out; None if nothing remains."""
    if path.split("/")[-1].split("@")[-1] in ASIDE:
        return None
    text = as_text(value)
    if text is None:
        return value
    try:
        parsed = json.loads(text)
    except ValueError:
        return text
    return {key: own for key, own in parsed.items() if key not in ASIDE} if isinstance(parsed, dict) else parsed


def more_keys_only(path, a, b):
    """Whether two texts of a scene differ in keys alone that the new program has more of."""
    if path != "provenance/scene" or not isinstance(a, str) or not isinstance(b, str):
        return False
    left = iter(b.splitlines())
    return all(line in left for line in a.splitlines())


def equal(a, b):
    if a is None or b is None or isinstance(a, (str, dict, list)):
        return a is b if a is None or b is None else a == b
    a, b = np.asarray(a), np.asarray(b)
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def describe(a, b):
    if isinstance(a, dict) and isinstance(b, dict):
        keys = [key for key in sorted(a.keys() | b.keys()) if a.get(key) != b.get(key)]
        return "; ".join(f"{key}: {str(a.get(key))[:60]} | {str(b.get(key))[:60]}" for key in keys[:4])
    a, b = np.asarray(a), np.asarray(b)
    if a.shape != b.shape or a.dtype != b.dtype:
        return f"{a.shape} {a.dtype} | {b.shape} {b.dtype}"
    if a.dtype.kind != "f":
        return f"{str(a)[:80]} | {str(b)[:80]}"
    different = np.flatnonzero(a.ravel() != b.ravel())
    first = different[0] if different.size else 0
    return f"{different.size} of {a.size} numbers, first {a.ravel()[first]!r} | {b.ravel()[first]!r}"


def file_differences(old, new):
    a, b = contents(old), contents(new)
    found = [f"{path} only in the old file" for path in a.keys() - b.keys()]
    found += [f"{path} only in the new file" for path in b.keys() - a.keys()]
    for path in sorted(a.keys() & b.keys()):
        one, other = without_aside(path, a[path]), without_aside(path, b[path])
        if not equal(one, other) and not more_keys_only(path, one, other):
            found.append(f"{path}: {describe(one, other)}")
    return found


def differences(old, new, old_name="old", new_name="new"):
    """\\return a line for everything that differs between two files or all HDF5 files of two folders"""
    a, b = files_below(old), files_below(new)
    found = [f"{name}: only {old_name}" for name in a.keys() - b.keys()]
    found += [f"{name}: only {new_name}" for name in b.keys() - a.keys()]
    if not a.keys() & b.keys():
        found.append("no file to compare")
    for name in sorted(a.keys() & b.keys()):
        found += [f"{name or Path(old).name} {line}" for line in file_differences(a[name], b[name])]
    return found
