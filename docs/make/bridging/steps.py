"""Are there steps in D/d? ln of the mean burst as a smooth curve, and with steps, between D/d = 2 and 3.2."""

import math
from dataclasses import dataclass

import numpy as np

RANGE = 2, 3.2
DEGREE = 2  # of the smooth curve
REPLICATES = 4000


@dataclass
class Curve:
    ratios: np.ndarray
    logs: np.ndarray
    errors: np.ndarray

    def misfit(self, *more, logs=None):
        """Chi squared of the polynomial and further columns, \\return it and the coefficients."""
        x = self.ratios - np.mean(RANGE)
        columns = np.column_stack([x**k for k in range(DEGREE + 1)] + list(more)) / self.errors[:, None]
        values = (self.logs if logs is None else logs) / self.errors
        solution = np.linalg.lstsq(columns, values, rcond=None)[0]
        return float(((values - columns @ solution) ** 2).sum()), solution

    def smooth(self):
        x = self.ratios - np.mean(RANGE)
        return sum(c * x**k for k, c in enumerate(self.misfit()[1]))

    def replicates(self):
        """Logs as a smooth law would give them, with our errors."""
        random = np.random.default_rng(1)
        return self.smooth() + self.errors * random.standard_normal((REPLICATES, len(self.logs)))


def curve_of(sizes, log_error, mean_of):
    rows = [(ratio, math.log(mean_of(fair)[0]), log_error(fair)) for ratio, fair in sizes.items() if RANGE[0] <= ratio <= RANGE[1]]
    return Curve(*np.array(sorted(rows)).T)


def degrees_of_freedom(curve):
    return len(curve.logs) - DEGREE - 1


def p_of_misfit(curve):
    """Of the smooth curve alone: chi squared, and the share of replicates that are worse."""
    found = curve.misfit()[0]
    return found, np.mean([curve.misfit(logs=logs)[0] >= found for logs in curve.replicates()])


def step_at(curve, place):
    return (curve.ratios >= place).astype(float)


def places_between(curve):
    """Between neighbouring points, two at least on either side."""
    return (curve.ratios[1:-2] + curve.ratios[2:-1]) / 2


def best_step(curve):
    """The step anywhere that helps most: place, height in ln, gain in chi squared, and its p among as many tries."""

    def gains(logs):
        flat = curve.misfit(logs=logs)[0]
        return [flat - curve.misfit(step_at(curve, place), logs=logs)[0] for place in places_between(curve)]

    found = gains(curve.logs)
    best = int(np.argmax(found))
    place = places_between(curve)[best]
    p = np.mean([max(gains(logs)) >= found[best] for logs in curve.replicates()])
    return place, curve.misfit(step_at(curve, place))[1][-1], found[best], p, len(found)


def named_steps(curve, places):
    """One height for all steps at these places: height in ln, its standard error, p of its gain. One trial."""
    stairs = sum(step_at(curve, place) for place in places)
    flat, (with_steps, solution) = curve.misfit()[0], curve.misfit(stairs)
    heights = [curve.misfit(stairs, logs=logs)[1][-1] for logs in curve.replicates()]
    p = np.mean([curve.misfit(logs=logs)[0] - curve.misfit(stairs, logs=logs)[0] >= flat - with_steps for logs in curve.replicates()])
    return solution[-1], np.std(heights), p


# Where a whole number of particles more is needed by (D/d)^2 + 1; where a whole number fits side by side; and where one
# more layer fits the height of the neck, squares upon squares or hexagons upon hexagons.
NAMED = {
    "(D/d)^2 whole": [math.sqrt(k) for k in range(5, 11)],
    "D/d whole": [3.0],
    "layers of squares, 1 + k / sqrt(2)": [1 + k / math.sqrt(2) for k in (2, 3)],
    "layers of hexagons, 1 + k sqrt(2/3)": [1 + 2 * math.sqrt(2 / 3)],
}
