"""Are there steps in D/d? ln of the mean burst as a smooth curve, and with steps, between D/d = 2 and 3.6."""

import math
from dataclasses import dataclass

import numpy as np
from bursts import log_error, mean_of

RANGE = 2, 3.6
DEGREE = 3  # of the smooth curve that steps are added to
REPLICATES = 4000


@dataclass
class Curve:
    ratios: np.ndarray
    logs: np.ndarray
    errors: np.ndarray
    degree: int = DEGREE

    def columns(self, *more):
        """Of the polynomial and of what is fitted beside it, over the errors."""
        x = self.ratios - np.mean(RANGE)
        return np.column_stack([x**k for k in range(self.degree + 1)] + list(more)) / self.errors[:, None]

    def fit(self, *more, logs=None):
        """Coefficients, the last of them those of `more`; logs are ours, or rows of others."""
        return np.linalg.pinv(self.columns(*more)) @ ((self.logs if logs is None else logs) / self.errors).T

    def misfit(self, *more, logs=None):
        """Chi squared, of each row of logs."""
        columns = self.columns(*more)
        values = ((self.logs if logs is None else logs) / self.errors).T
        return ((values - columns @ (np.linalg.pinv(columns) @ values)) ** 2).sum(axis=0)

    def smooth(self):
        return self.columns() @ self.fit() * self.errors

    def replicates(self):
        """Rows of logs as a smooth law would give them, with our errors."""
        random = np.random.default_rng(1)
        return self.smooth() + self.errors * random.standard_normal((REPLICATES, len(self.logs)))


def curve_of(sizes, degree=DEGREE):
    rows = [(ratio, math.log(mean_of(fair)[0]), log_error(fair)) for ratio, fair in sizes.items() if RANGE[0] <= ratio <= RANGE[1]]
    return Curve(*np.array(sorted(rows)).T, degree)


def slopes(curve):
    """Of ln of the mean between neighbours: from, to, slope and its standard error."""
    x, y, e = curve.ratios, curve.logs, curve.errors
    gap = np.diff(x)
    return zip(x, x[1:], np.diff(y) / gap, np.hypot(e[1:], e[:-1]) / gap)


def degrees_of_freedom(curve):
    return len(curve.logs) - curve.degree - 1


def p_of_misfit(curve):
    """Of the smooth curve alone: chi squared, and the share of replicates that are worse."""
    return curve.misfit(), np.mean(curve.misfit(logs=curve.replicates()) >= curve.misfit())


def step_at(curve, place):
    return (curve.ratios >= place).astype(float)


def places_between(curve):
    """Between neighbouring points, two at least on either side."""
    return (curve.ratios[1:-2] + curve.ratios[2:-1]) / 2


def best_step(curve):
    """The step anywhere that helps most: place, height in ln, gain in chi squared, its p among as many tries, and these."""
    places = places_between(curve)

    def gains(logs):
        return curve.misfit(logs=logs) - np.array([curve.misfit(step_at(curve, place), logs=logs) for place in places])

    found = gains(curve.logs)
    place = places[np.argmax(found)]
    p = np.mean(gains(curve.replicates()).max(axis=0) >= found.max())
    return place, curve.fit(step_at(curve, place))[-1], found.max(), p, len(places)


def named_steps(curve, places):
    """One height for all steps at these places: height in ln, its standard error, p of its gain. One trial."""
    stairs, others = sum(step_at(curve, place) for place in places), curve.replicates()
    gain = curve.misfit() - curve.misfit(stairs)
    p = np.mean(curve.misfit(logs=others) - curve.misfit(stairs, logs=others) >= gain)
    return curve.fit(stairs)[-1], np.std(curve.fit(stairs, logs=others)[-1]), p


# Where a whole number of particles more is needed by (D/d)^2 + 1; where a whole number fits side by side; and where one
# more layer fits the height of the neck, squares upon squares or hexagons upon hexagons.
NAMED = {
    "(D/d)^2 whole": [math.sqrt(k) for k in range(5, 11)],
    "D/d whole": [3.0],
    "layers of squares, 1 + k / sqrt(2)": [1 + k / math.sqrt(2) for k in (2, 3)],
    "layers of hexagons, 1 + k sqrt(2/3)": [1 + 2 * math.sqrt(2 / 3)],
}
