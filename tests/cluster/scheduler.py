"""The order in which `clog run` hands out seeds, simulated: dearest first, to whichever rank is free."""

import heapq

import numpy as np


def simulate(expected, seconds, ranks, hand_out=0.0):
    """Time until the last rank is done [s].

    expected  what the cost model says of each run; only comparisons count
    seconds   what each run takes [s]
    hand_out  time in which one rank gets its next run while the others that ask wait for their turn [s]
    """
    free = [0.0] * ranks
    counter_free = 0.0
    for run in np.argsort(-np.asarray(expected), kind="stable"):
        asked = free[0]
        counter_free = max(asked, counter_free) + hand_out
        heapq.heapreplace(free, counter_free + seconds[run])
    return max(free)


def efficiency(expected, seconds, ranks, hand_out=0.0):
    """Share of the ranks' time that goes into runs, until the last one is done."""
    return float(np.sum(seconds)) / (ranks * simulate(expected, seconds, ranks, hand_out))
