"""How many beads pass until the first clog, and whether the neck remembers how many have: laws through counts of which some were cut."""

import csv
from pathlib import Path

import numpy as np

TABLE = Path(__file__).resolve().parents[2] / "reports/experiment/first_clogs.csv"
COLUMNS = ["D/d [1]", "concentration fed [1]", "mass scale [1]", "seed", "beads passed [1]", "clogged", "time [s]"]
DROP = 1.92  # of the logarithm of the likelihood at the ends of an interval of 95 %


class Point:
    """Runs of one D/d, concentration and mass. The bead that clogs has come, too."""

    def __init__(self, ratio, concentration, mass, rows):
        self.ratio, self.concentration, self.mass, self.seeds = float(ratio), float(concentration), float(mass), len(rows)
        self.passed = np.array([int(row[COLUMNS[4]]) for row in rows])
        self.clogged = np.array([row[COLUMNS[5]] == "1" for row in rows])
        self.came = (self.passed + self.clogged).astype(float)

    def clogs(self):
        return int(self.clogged.sum())

    def beads_a_clog(self):
        """Value, low and high; where nothing clogged the low bound alone."""
        return mean_until(self.came.sum(), self.clogs())

    def shape(self):
        return shape(self.came, self.clogged) if self.clogs() > 2 else None


def points():
    rows = {}
    with TABLE.open(newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            rows.setdefault(tuple(row[c] for c in COLUMNS[:3]), []).append(row)
    return [Point(*key, of_point) for key, of_point in rows.items()]


def within(values, likelihood):
    """Most likely of the values, and the range of those that the data do not exclude with 95 %."""
    kept = values[likelihood > likelihood.max() - DROP]
    return values[likelihood.argmax()], kept[0], kept[-1]


def mean_until(came, clogs):
    """Beads a clog if the chance of each never changes. \\param came  beads, clogging ones included"""
    if clogs == 0:
        return None, came / np.log(20), None
    means = came / clogs * np.geomspace(0.02, 50, 40001)
    return within(means, -clogs * np.log(means) - came / means)


def shape(came, clogged):
    """Exponent k of Weibull's law S(n) = exp(-(n / scale)^k) of the beads until the clog; runs that did not clog are censored.
    1: no memory, a Poisson process; more: the more have come, the likelier a clog. The scale is the most likely one for each k."""
    exponents, m = np.geomspace(0.1, 20, 4001), clogged.sum()
    likelihood = np.array([m * np.log(k) + (k - 1) * np.log(came[clogged]).sum() - m * np.log((came ** k).sum()) for k in exponents])
    return within(exponents, likelihood)
