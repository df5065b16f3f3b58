"""Bursts as whole numbers, and their mean with an interval."""

import csv

import numpy as np
from whole_file import rewritten  # beside this folder, on the path of its scripts

RESAMPLES = 4000


def fair_sizes(rows, end):
    """Sizes of the bursts of one point by seed, from the table `bursts` of `clog stats`: empty, first and whole ones.

    The end of a run [s] cuts long bursts more often than short ones. So a burst counts if it begins so early that the
    longest way from one burst to the next still fits before the end: which count then knows nothing of their size."""
    seeds = {}
    for row in rows:
        seeds.setdefault(int(float(row["seed"])), []).append((float(row["start [s]"]), int(float(row["s [1]"])), row["kind"]))
    longest = max((b[0] - a[0] for bursts in seeds.values() for a, b in zip(bursts, bursts[1:])), default=0)
    fair = {seed: [s for start, s, kind in bursts if start < end - longest and kind != "cut off"] for seed, bursts in seeds.items()}
    return {seed: sizes for seed, sizes in fair.items() if sizes}


def mean_of(fair):
    """\\return mean over all bursts, and 95 %: the wider of bursts resampled and of seeds resampled."""
    sizes = np.concatenate([np.array(s, float) for s in fair.values()])
    random = np.random.default_rng(1)
    by_burst = sizes[random.integers(0, len(sizes), (RESAMPLES, len(sizes)))].mean(axis=1)
    sums, counts = np.array([sum(s) for s in fair.values()]), np.array([len(s) for s in fair.values()])
    drawn = random.integers(0, len(sums), (RESAMPLES, len(sums)))
    by_seed = sums[drawn].sum(axis=1) / counts[drawn].sum(axis=1)
    low, high = np.array([np.quantile(means, (0.025, 0.975)) for means in (by_burst, by_seed)]).T
    return sizes.mean(), low.min(), high.max()


def log_error(fair):
    """Standard error of ln of the mean, by the scatter of the bursts."""
    sizes = np.concatenate([np.array(s, float) for s in fair.values()])
    return sizes.std(ddof=1) / np.sqrt(len(sizes)) / sizes.mean()


def write_sizes(file, points):
    """A line for each seed: point, seed, sizes. \\param points  name -> seed -> sizes"""
    with rewritten(file) as out:
        writer = csv.writer(out)
        writer.writerow(["point", "seed", "sizes of the bursts [1]"])
        for name, fair in points.items():
            for seed, sizes in fair.items():
                writer.writerow([name, seed, " ".join(map(str, sizes))])


def read_sizes(file):
    points = {}
    with file.open(newline="") as table:
        for name, seed, sizes in list(csv.reader(table))[1:]:
            points.setdefault(name, {})[int(seed)] = [int(s) for s in sizes.split()]
    return points
