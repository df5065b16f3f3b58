"""The tables of a study, read back for the page and the test."""

from dataclasses import dataclass, field

import numpy as np

from .compare import at_no_size
from .lattice import lattice_problem
from .resolved import CHANNEL, NECK, RATE
from .tables import read

LAWS = "strips", "local", "superficial", "beetstra", "plug strips", "plug local"


def vectors(rows, name):
    return np.array([[float(row[f"{name} {axis}"]) for axis in "xyz"] for row in rows])


@dataclass(frozen=True)
class Case:
    cells: int
    shrink: float
    slower: float
    start: float
    row: dict  # of cases.csv
    rows: np.ndarray  # of the clog's spheres
    every: np.ndarray  # [n, 3] on them [N]

    def of(self, rows):
        """[m, 3] on those of the rows given"""
        where = {row: k for k, row in enumerate(self.rows)}
        return self.every[[where[row] for row in rows]]

    @property
    def drop(self):
        return float(self.row["drop [Pa]"])


@dataclass(frozen=True)
class ClogResults:
    seed: int
    rows: np.ndarray
    place: np.ndarray  # [n, 3] [m]
    inner: np.ndarray  # which are compared
    laws: dict  # name to [n, 3] [N]
    run: np.ndarray  # [n, 3] drag in the run itself
    mixture: np.ndarray  # [n, 3] by drag.velocity = "mixture"
    v0: np.ndarray  # [n, 3] [m/s]
    passed: int
    cases: list = field(default_factory=list)

    def plain(self):
        """Cases that differ in nothing but the mesh, coarse ones first."""
        found = [c for c in self.cases if c.shrink == 0 and c.slower == 1 and c.start == CHANNEL.start]
        return sorted(found, key=lambda c: c.cells)

    def shrunk(self):
        """Cases of one coarse mesh, shrunk or not."""
        fewest = self.plain()[0].cells
        return [c for c in self.cases if c.cells == fewest and c.slower == 1 and c.start == CHANNEL.start]

    def force(self):
        """[n, 3] at cells of no size, of one mesh as it is."""
        plain = self.plain()
        values = [c.of(self.rows) for c in plain]
        return values[0] if len(plain) == 1 else at_no_size(values, [c.cells for c in plain])

    def drop(self):
        plain = self.plain()
        return plain[0].drop if len(plain) == 1 else at_no_size([c.drop for c in plain], [c.cells for c in plain])

    def x(self):
        return self.place[:, 0] / NECK

    def across(self):
        """|y| over the half width there"""
        return np.abs(self.place[:, 1]) / NECK / CHANNEL.half_width(self.x())

    def near(self):
        """Compared spheres of narrowing and neck."""
        return self.inner & (self.x() > -CHANNEL.narrowing)

    def drop_of(self, forces, empty):
        """By the reciprocal theorem, each force at the sphere's centre: empty + sum of F.V0 over the rate [Pa]"""
        return empty + float(np.sum(forces * self.v0) / RATE)


@dataclass(frozen=True)
class Lattice:
    solid: float
    exact: float
    counts: list  # about so many cells a diameter
    found: list  # K of each

    def limit(self, meshes=None):
        """K at cells of no size, from so many of the coarsest meshes, all of them otherwise"""
        counts, found = self.counts[:meshes], self.found[:meshes]
        cells = [lattice_problem(self.solid, count, 0).cells_per_length for count in counts]
        return at_no_size(found, cells) if len(cells) > 1 else found[0]


def read_lattices(data):
    """Of unshrunk spheres, by solid fraction."""
    rows = sorted((float(row["solid"]), int(row["cells a diameter"]), float(row["K"]), float(row["exact"]))
                  for row in read(data / "lattice.csv") if float(row["shrink"]) == 0)
    return [Lattice(solid, next(r[3] for r in rows if r[0] == solid), *map(list, zip(*[r[1:3] for r in rows if r[0] == solid])))
            for solid in dict.fromkeys(row[0] for row in rows)]


def read_results(data):
    """Clogs by seed, rows of stand.csv, the empty channel's pressure drop [Pa]."""
    clogs, empty = {}, 0.0
    for row in read(data / "cases.csv"):
        seed = int(row["seed"])
        if seed == 0:
            empty = float(row["drop [Pa]"])
            continue
        if seed not in clogs:
            table = read(data / f"clog_{seed}.csv")
            clogs[seed] = ClogResults(
                seed, np.array([int(r["row"]) for r in table]), vectors(table, "place"),
                np.array([r["compared"] == "1" for r in table]), {law: vectors(table, law) for law in LAWS},
                vectors(table, "run"), vectors(table, "mixture"), vectors(table, "V0"), int(table[0]["passed"]))
        name = "_".join(row[key] for key in ("seed", "cells", "shrink", "slower", "start"))
        forces = read(data / "forces" / f"{name}.csv")
        clogs[seed].cases.append(Case(int(row["cells"]), float(row["shrink"]), float(row["slower"]), float(row["start"]), row,
                                      np.array([int(r["row"]) for r in forces]), vectors(forces, "force")))
    return clogs, read(data / "stand.csv"), empty
