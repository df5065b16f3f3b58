"""Is a clog foreseen in the state before it? Variance of its chance between states against that between copies of one."""

import csv
from dataclasses import dataclass

import numpy as np

RESAMPLES = 2000
WITHIN = 60  # passages that copies are followed for


@dataclass
class Share:
    """Of the variance among copies, what the state decides."""

    mean: float  # of all copies: the chance that one clogs, or the particles that it lets pass
    value: float  # share of the variance between states
    low: float
    high: float
    p_value: float  # of so much where copies are dealt to states at random
    states: int
    copies: int


def read_copies(file):
    """\\return (D/d, push, age) -> state -> rows of (passed, clogged, alike), copy 0 first"""
    sets = {}
    with file.open(newline="") as table:
        for row in csv.DictReader(table):
            key = float(row["D/d"]), float(row["push"]), int(row["age"])
            state = sets.setdefault(key, {}).setdefault((int(row["seed"]), int(row["burst"])), [])
            state.append((int(row["passed"]), int(row["clogged"]), int(row["alike"])))
    # A state of which the end of the run cut a copy tells nothing.
    return {key: {name: rows for name, rows in states.items() if all(clogged or passed >= WITHIN for passed, clogged, _ in rows)}
            for key, states in sets.items()}


def share_of_variance(sums, squares, copies):
    """Analysis of variance of one factor, not cut off at 0. Of the values of each state's copies, [..., states]: their sum, the
    sum of their squares, their number."""
    total, states = copies.sum(axis=-1), copies.shape[-1]
    overall = sums.sum(axis=-1) / total
    between = (copies * (sums / copies - overall[..., None]) ** 2).sum(axis=-1) / (states - 1)
    within = (squares - sums**2 / copies).sum(axis=-1) / (total - states)
    typical = (total - (copies**2).sum(axis=-1) / total) / (states - 1)
    with np.errstate(invalid="ignore", divide="ignore"):
        return (between - within) / (between + (typical - 1) * within)


def foreseen(groups):
    """\param groups  for each state a value of each of its copies: whether it clogs, or how many particles it lets pass"""
    groups = [g for g in groups if len(g) > 1]
    copies, values = np.array([len(g) for g in groups]), np.concatenate(groups).astype(float)
    begins = np.cumsum(copies) - copies
    random = np.random.default_rng(1)

    def sums_of(rows):
        return np.add.reduceat(rows, begins, axis=-1), np.add.reduceat(rows**2, begins, axis=-1)

    sums, squares = sums_of(values)
    drawn = random.integers(0, len(groups), (RESAMPLES, len(groups)))
    low, high = np.nanquantile(share_of_variance(sums[drawn], squares[drawn], copies[drawn]), (0.025, 0.975))
    value = share_of_variance(sums, squares, copies)
    dealt = sums_of(random.permuted(np.tile(values, (RESAMPLES, 1)), axis=1))
    p_value = (1 + np.sum(share_of_variance(*dealt, np.broadcast_to(copies, dealt[0].shape)) >= value)) / (1 + RESAMPLES)
    return Share(values.mean(), value, low, high, p_value, len(groups), len(values))


def sizes(states):
    """Of the states of which all copies clogged: what each lets pass."""
    return [[passed for passed, _, _ in rows] for rows in states.values() if all(clogged for _, clogged, _ in rows)]


def window(states, first, last):
    """Of the copies that let `first` particles pass: whether they clog before the one after `last`."""
    return [[int(clogged and passed < last) for passed, clogged, _ in rows if passed > first or (passed == first and clogged)]
            for rows in states.values()]


def still_alike(states, lags):
    """Share of the pushed copies that let the same particles pass in the same order as the run itself, of those that
    (or whose run) could tell."""
    shares = []
    for lag in lags:
        same = [alike >= lag for rows in states.values() for passed, _, alike in rows[1:] if rows[0][0] >= lag or passed >= lag]
        shares.append(np.mean(same) if same else np.nan)
    return shares


def branching_gain(share, cost_of_state, cost_of_copy):
    """How many times fewer core-seconds the chance takes if each state gets the best number of copies, and that number.
    Variance per state p (1 - p) (share + (1 - share) / copies), cost per state cost_of_state + copies cost_of_copy."""
    share = max(share, 0)

    def price(copies):
        return (share + (1 - share) / copies) * (cost_of_state + copies * cost_of_copy)

    best = min(range(1, 201), key=price)
    return price(1) / price(best), best
