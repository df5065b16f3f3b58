"""Compares numbers of passages until the first clog, where some packs had not clogged when they were exhausted."""

import math

import numpy as np


def log_rank(first, second):
    """Probability of a difference at least as large between samples of one law: rows of passages and 1 (clogged) or 0.

    Mantel's test: at each number of passages, the clogs of the first sample against its share of those still flowing.
    """
    first, second = np.asarray(first), np.asarray(second)
    both = np.vstack([first, second])
    apart = variance = 0.0
    for passed in np.unique(both[both[:, 1] == 1, 0]):
        n1, n = np.sum(first[:, 0] >= passed), np.sum(both[:, 0] >= passed)
        clogs = np.sum((both[:, 0] == passed) & (both[:, 1] == 1))
        apart += np.sum((first[:, 0] == passed) & (first[:, 1] == 1)) - clogs * n1 / n
        if n > 1:
            variance += clogs * (n1 / n) * (1 - n1 / n) * (n - clogs) / (n - 1)
    return math.erfc(abs(apart) / math.sqrt(2 * variance)) if variance > 0 else 1.0


def interval(values, repeats=4000):
    """Of the mean, 95 %, from resampled packs."""
    rng = np.random.Generator(np.random.PCG64(1))
    values = np.asarray(values, dtype=float)
    means = values[rng.integers(0, len(values), (repeats, len(values)))].mean(axis=1)
    return np.quantile(means, [0.025, 0.975])
