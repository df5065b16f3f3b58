#!/usr/bin/python3
"""Kills a verb at each of some places where it touches the disk, and calls it again.

usage: crash_points.py CLOG SHIM VERB

After the kill every file under its final name is whole: of this call or of the one before. The second call succeeds,
gives what an undisturbed one gives, and leaves nothing else. Where the disk fills instead, the call ends with status 1
and a line that names a file and the reason. A file is flushed to the disk before it gets its name.
"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

import h5py

import crash_inputs
from crash_verbs import VERBS

NO_RESULT = ("wall_time_s", "processor_time_s", "particle_steps_per_s", "date", "host", "seconds", "started", "finished")
LIMIT = 300  # [s] for one call; a second is usual


def h5_content(file):
    content = {}

    def add(name, item):
        content[name] = {key: str(value) for key, value in item.attrs.items()}
        if isinstance(item, h5py.Dataset):
            value = item[()]
            if name == "provenance/record":
                record = json.loads(value)
                value = json.dumps({k: v for k, v in record.items() if not any(word in k for word in NO_RESULT)})
            if name == "end_state":  # holds the seconds of computing and a checksum over them
                value = str(value.size)
            content[name]["value"] = value if isinstance(value, (str, bytes)) else value.tobytes()

    with h5py.File(file) as opened:
        opened.visititems(add)
    return content


def run_together(file):
    """Lines of the log of calls, which is no result, that begin inside another one: HOST.PROCESS.TIME,rank,HOST,..."""
    found = []
    for line in file.read_text().splitlines()[1:]:
        cells = line.split(",")
        if len(cells) > 8 or len(cells) > 2 and not re.fullmatch(re.escape(cells[2]) + r"\.\d+\.\d+", cells[0]):
            found.append(line)
    return found


def content(file):
    """What of a file is a result; None of one that cannot be read."""
    if file.name == "ensemble.csv":
        return run_together(file)
    if file.suffix not in (".h5", ".hdf"):
        return file.read_bytes()
    try:
        return h5_content(file)
    except (OSError, KeyError, ValueError):
        return None


def files_in(folder):
    return {str(file.relative_to(folder)): file for file in folder.rglob("*") if file.is_file()}


class Trials:
    """Calls of one verb, each from a fresh copy of the same inputs."""

    def __init__(self, clog, shim, name, scratch):
        self.clog, self.shim = os.path.abspath(clog), os.path.abspath(shim)
        self.verb, self.scratch = VERBS[name], scratch
        self.inputs = crash_inputs.make(self.clog, scratch / "inputs")
        self.given = files_in(self.inputs).keys()
        self.faults, self.killed = [], 0

    def folder(self, older):
        folder = self.scratch / "trial"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.inputs, folder)
        if older:
            self.verb.before(folder, self.clog)
        return folder

    def contents(self, folder):
        return {name: content(file) for name, file in files_in(folder).items() if name not in self.given}

    def call(self, folder, **settings):
        counter, log = self.scratch / "counter", self.scratch / "log"
        counter.write_bytes(bytes(8))
        log.unlink(missing_ok=True)
        environment = dict(os.environ, LD_PRELOAD=self.shim, CRASH_FOLDER=f"{folder}/", CRASH_COUNTER=str(counter),
                           CRASH_LOG=str(log), **self.verb.environment)
        environment |= {f"CRASH_{key.upper()}": str(value) for key, value in settings.items()}
        done = subprocess.run([self.clog, *self.verb.words], cwd=folder, env=environment, capture_output=True,
                              text=True, timeout=LIMIT)
        return done, log.read_text().splitlines() if log.exists() else []

    def fault(self, where, what):
        self.faults.append(f"{where}: {what}")

    def undisturbed(self, older):
        folder = self.folder(older)
        done, log = self.call(folder)
        if done.returncode != 0:
            raise SystemExit(f"{self.verb.words}: {done.stderr}")
        return self.contents(folder), log

    def check_flushed(self, log):
        unflushed, source = set(), ""
        for line in log:
            what, path = line.split(" ", 1)
            if what == "write":
                unflushed.add(path)
            elif what in ("fsync", "fdatasync"):
                unflushed.discard(path)
            elif what == "from":
                source = path
            # A state has a checksum and an older one beside it, and a launcher that ends a job does not wait for a disk.
            elif what in ("rename", "renameat") and source in unflushed and not path.endswith(".state"):
                self.fault("undisturbed", f"{pathlib.Path(path).name} gets its name before it is on the disk")

    def killed_at(self, place, act, older, wanted):
        where = f"killed at {act}{' over an older result' if older else ''}"
        folder = self.folder(older)
        before = self.contents(folder)
        done, _ = self.call(folder, kill_at=place)
        if done.returncode == 0:
            return  # how often a state is saved depends on the clock: this act may be missing
        self.killed += 1
        self.check_whole(where, self.contents(folder), before, wanted)
        self.check_again(where, folder, wanted)

    def check_whole(self, where, there, before, wanted):
        if self.verb.words[0] == "case" and there.get("out/solved") != there.get("out/hash", ...):
            return  # a case is one thing, whole when it calls itself solved
        for name, value in there.items():
            if name in wanted and value != wanted[name] and value != before.get(name, ...):
                self.fault(where, f"{name} is torn")

    def check_again(self, where, folder, wanted):
        done, _ = self.call(folder)
        if done.returncode != 0 or "is not used" in done.stderr:
            self.fault(where, f"the next call says {done.stderr.strip()[:300]}")
            return
        there = self.contents(folder)
        for name in sorted(there.keys() | wanted.keys()):
            if name not in wanted:
                self.fault(where, f"the next call leaves {name}")
            elif there.get(name, ...) != wanted[name]:
                self.fault(where, f"the next call gives another {name}")

    def full_at(self, place, act, wanted):
        where = f"disk full at {act}"
        folder = self.folder(False)
        done, _ = self.call(folder, full_at=place)
        lines = done.stderr.strip().splitlines()
        named = [line for line in lines if "o space left" in line and self.verb.makes in line]
        if done.returncode != 1 or not named:
            self.fault(where, f"status {done.returncode}, says {lines[-1:]}")
        there = self.contents(folder)
        left = [name for name in there if name not in wanted and ".state" not in name]
        if left:
            self.fault(where, f"leaves {left}")
        self.check_whole(where, there, {}, wanted)
        self.check_again(where, folder, wanted)


def evenly(acts, most):
    """Of a list at most so many, first and last among them."""
    if len(acts) <= most:
        return acts
    return [acts[round(i * (len(acts) - 1) / (most - 1))] for i in range(most)] if most > 1 else acts[:most]


def spread(acts, most):
    """One of every kind of act on every file as far as they go and the last of all, then more of what is done often."""
    first = {act: (place, act) for place, act in reversed(acts)}
    chosen = evenly(sorted({*first.values(), acts[-1]}), most)
    return sorted({*chosen, *evenly([each for each in acts if each not in chosen], most - len(chosen))})


def acts_of(log, folder):
    acts = [line.replace(f"{folder}/", "") for line in log if not line.startswith("from ")]
    return list(enumerate(acts, 1))


def main(clog, shim, name):
    with tempfile.TemporaryDirectory(prefix="clogflow_crash_") as scratch:
        trials = Trials(clog, shim, name, pathlib.Path(scratch).resolve())
        verb, tried = trials.verb, 0
        states = (False, True) if verb.before else (False,)
        for older in states:
            wanted, log = trials.undisturbed(older)
            acts = acts_of(log, trials.scratch / "trial")
            trials.check_flushed(log)
            for place, act in spread(acts, verb.places // len(states)):
                trials.killed_at(place, act, older, wanted)
                tried += 1
            if older:
                continue
            for place, act in spread([each for each in acts if each[1].startswith("write")], verb.full):
                trials.full_at(place, act, wanted)
        print(f"clog {name}: {len(acts)} acts, killed at {trials.killed} of {tried} places")
        if trials.killed < max(1, 0.7 * tried):
            trials.fault("all calls", "too few met the place where they were to be killed")
        for fault in dict.fromkeys(trials.faults):
            print(f"  {fault}")
        return 1 if trials.faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
