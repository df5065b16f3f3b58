"""Is a peer's silo ours? On the same pack, beside the spread of N(t) over our own packs."""

from dataclasses import dataclass

import numpy as np

SHARES = 0.1, 0.5, 0.9  # gone: the times of emptying that are compared
LIMIT, GRAINS = 0.02, 5
MOMENTS = np.arange(0.05, 0.96, 0.05)  # shares gone in the mean of our packs: the times that N(t) is compared at
DEVIATIONS = 3
FEWEST_PACKS = 5


def mean_curve(runs):
    return np.mean([run.left for run in runs], axis=0)


@dataclass
class Spread:
    """Of N(t) over packs."""
    times: np.ndarray
    mean: np.ndarray
    deviation: np.ndarray  # of one pack; a sphere at least
    least: np.ndarray
    most: np.ndarray

    def apart(self, run, other):
        """Largest difference of two runs, in standard deviations of the difference of two packs."""
        return float(np.max(np.abs(run.at(self.times) - other.at(self.times)) / (np.sqrt(2) * self.deviation)))

    def inside(self, run):
        """\\return at how many of the times the run lies between the least and the most"""
        left = run.at(self.times)
        return int(np.sum((left >= self.least) & (left <= self.most)))


def spread(runs):
    """\\return None of too few"""
    if len(runs) < FEWEST_PACKS:
        return None
    middle = mean_curve(runs)
    times = np.interp(MOMENTS * middle[0], middle[0] - middle, runs[0].times)
    left = np.array([run.at(times) for run in runs])
    return Spread(times, left.mean(axis=0), np.maximum(left.std(axis=0, ddof=1), 1), left.min(axis=0), left.max(axis=0))


def common(theirs, ours):
    return [number for number in theirs if number in ours]


def ratios(theirs, ours):
    """Times of emptying over ours, a row for each pack that both have."""
    return np.array([theirs[n].emptying_times(SHARES) / ours[n].emptying_times(SHARES) for n in common(theirs, ours)])


def pairs_apart(runs):
    """Of all pairs of our own packs, in deviations."""
    among = spread(runs)
    return [among.apart(one, other) for k, one in enumerate(runs) for other in runs[:k]]


def apart_on_same_pack(theirs, ours):
    """\return in deviations, of each pack that both have"""
    among = spread(list(ours.values()))
    return [among.apart(theirs[n], ours[n]) for n in common(theirs, ours)]


def times_agree(theirs, ours):
    spheres = next(iter(ours.values())).left[0]
    return bool(np.all(np.abs(ratios(theirs, ours).mean(axis=0) - 1) <= LIMIT + GRAINS / (np.array(SHARES) * spheres)))


def spread_agrees(theirs, ours):
    """True too where our packs are too few to tell."""
    return not spread(list(ours.values())) or max(apart_on_same_pack(theirs, ours)) <= DEVIATIONS
