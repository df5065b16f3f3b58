"""Does a step belong to the width of the neck or to its height? Necks of several heights, fitted together."""

import math
from dataclasses import dataclass

import numpy as np
from bursts import log_error, mean_of
from steps import DEGREE, RANGE


@dataclass
class Parted:
    of_width: tuple  # height of the step in ln at D/d = place, and its standard error
    of_height: tuple  # of the step where the neck's height over d is the same number
    chi_squared: float
    degrees_of_freedom: int


def rows_of(necks, ratios=RANGE):
    """Height over width, D/d, ln of the mean and its error. \\param necks  height over width -> D/d -> seed -> sizes"""
    return np.array([(height, ratio, math.log(mean_of(fair)[0]), log_error(fair))
                     for height, sizes in necks.items() for ratio, fair in sizes.items() if ratios[0] <= ratio <= ratios[1]])


def part(rows, place, degree=DEGREE, one_exponent=False):
    """One smooth curve in D/d for all necks, times a power law in their height whose exponent is one number or a line in D/d,
    and two steps: where D/d passes `place`, and where the height over d does. The errors grow by the root of chi squared over
    its degrees of freedom where that is above 1."""
    height, ratio, logs, error = rows.T
    x = ratio - np.mean(RANGE)
    power = [np.log(height)] if one_exponent else [np.log(height), np.log(height) * x]
    columns = [x**k for k in range(degree + 1)] + power + [ratio >= place, height * ratio >= place]
    design = np.column_stack(columns) / error[:, None]
    found = np.linalg.pinv(design) @ (logs / error)
    rest = float(((logs / error - design @ found) ** 2).sum())
    free = len(logs) - len(found)
    spread = np.sqrt(np.diag(np.linalg.inv(design.T @ design)) * max(1, rest / free))
    return Parted((found[-2], spread[-2]), (found[-1], spread[-1]), rest, free)


def say_walls(necks, places):
    print("\n| " + " | ".join(["D/d", *(f"{height:g} D high" for height in sorted(necks))]) + " |\n|" + " --- |" * (1 + len(necks)))
    for ratio in sorted({r for height, sizes in necks.items() if height != 1 for r in sizes}):
        means = {height: [mean_of(fair) for r, fair in sizes.items() if abs(r - ratio) < 0.01] for height, sizes in necks.items()}
        cells = [f"{found[0][0]:.3g} [{found[0][1]:.3g}, {found[0][2]:.3g}]" if found else "-" for _, found in sorted(means.items())]
        print(f"| {ratio:.3g} | " + " | ".join(cells) + " |")
    for place in places:
        say_steps(f"steps at {place:.2f}", part(rows_of(necks), place))
    for low in (RANGE[0], 2.35):
        for degree in (2, 3, 4):
            for one_exponent in (False, True):
                name = f"from D/d = {low:g}, degree {degree}, exponent of the height {'one number' if one_exponent else 'a line'}"
                say_steps(name, part(rows_of(necks, (low, RANGE[1])), places[1], degree, one_exponent))
    for left_out in sorted(necks):
        say_steps(f"without the necks {left_out:g} D high", part(rows_of({h: sizes for h, sizes in necks.items() if h != left_out}), places[1]))


def say_steps(name, found):
    of = [f"{100 * np.expm1(h):+.0f} % [{100 * np.expm1(h - 1.96 * e):+.0f}, {100 * np.expm1(h + 1.96 * e):+.0f}]" for h, e in (found.of_width, found.of_height)]
    print(f"{name}: of the width {of[0]}, of the height {of[1]}; chi squared {found.chi_squared:.1f} with {found.degrees_of_freedom}")
