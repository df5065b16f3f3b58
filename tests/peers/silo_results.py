"""Runs of the silo, how many spheres are left over time, and the file that keeps them: one line a run."""

import csv
from dataclasses import dataclass

import numpy as np

# What says which run it is, then what came out.
NAMES = ["modulus", "spheres", "radius", "orifice", "step", "end", "program", "pack"]
HEAD = [*NAMES, "seconds", "left"]


@dataclass
class Run:
    times: np.ndarray  # from 0 on, evenly [s]
    left: np.ndarray   # spheres that are not yet half through the orifice
    seconds: float     # of processor time

    def at(self, times):
        return np.interp(times, self.times, self.left)

    def emptying_times(self, shares):
        """When these shares of the spheres have left; nan where they do not. [s]"""
        gone, wanted = self.left[0] - self.left, np.array(shares) * self.left[0]
        return np.where(wanted <= gone[-1], np.interp(wanted, gone, self.times), np.nan)

    def rate(self):
        """Spheres a second, from 20 to 60 % gone."""
        begin, end = self.emptying_times([0.2, 0.6])
        return 0.4 * self.left[0] / (end - begin)

    def particle_steps(self, step):
        """Of the spheres that are left; what is below the orifice hardly counts."""
        return np.sum((self.left[1:] + self.left[:-1]) / 2 * np.diff(self.times)) / step


def frame_times(step, end, frames):
    """Beginnings and ends of the frames, which are whole numbers of steps. [s]"""
    return np.arange(frames + 1) * int(end / step / frames) * step


class Results:
    """Of all cases; what is in the file is not run again."""

    def __init__(self, file=None):
        self.file, self.runs = file, {}
        if not file or not file.exists():
            return
        text = file.read_text()
        whole = text[:text.rfind("\n") + 1]
        if whole != text:  # a line was cut off when its writer was killed
            file.write_text(whole)
        for row in csv.DictReader(whole.splitlines()):
            left = np.array([int(number) for number in row["left"].split()])
            times = frame_times(float(row["step"]), float(row["end"]), len(left) - 1)
            self.runs[tuple(row[name] for name in NAMES)] = Run(times, left, float(row["seconds"]))

    @staticmethod
    def key(case, program, pack):
        numbers = float(case.modulus), case.spheres, float(case.radius), float(case.orifice), case.step, case.end
        return (*map(repr, numbers), program, str(pack))

    def has(self, case, program, pack):
        return self.key(case, program, pack) in self.runs

    def put(self, case, program, pack, run):
        key = self.key(case, program, pack)
        self.runs[key] = run
        if not self.file:
            return
        new = not self.file.exists()
        with open(self.file, "a", newline="") as out:
            writer = csv.writer(out, lineterminator="\n")
            if new:
                writer.writerow(HEAD)
            writer.writerow([*key, f"{run.seconds:.2f}", " ".join(f"{number:.0f}" for number in run.left)])

    def of(self, case, program):
        """\\return its runs by pack"""
        wanted = self.key(case, program, 0)[:-1]
        return {number: self.runs[*wanted, str(number)]
                for number in sorted(int(key[-1]) for key in self.runs if key[:-1] == wanted)}
