"""law.csv, figures and numbers of docs/reports/bridging.md, from committed tables."""

import csv

import numpy as np
import steps
from bursts import log_error, mean_of
from figures import draw_arches, draw_copies, draw_law, draw_layers
from foreseen import WITHIN, branching_gain, foreseen, read_copies, sizes, still_alike, window
from law import sizes_of_base, sizes_of_necks, write_law
from layers import read_profiles, say_layers
from points import COST, NECK, POINTS
from walls import say_walls

COUNTS = ("seen from the outlet", "centred before the opening", "foremost layer", "shortest chain")


def say_steps(sizes):
    for degree in (1, 2, 3, 4):
        curve = steps.curve_of(sizes, degree)
        misfit, p = steps.p_of_misfit(curve)
        print(f"smooth curve of degree {degree} through {len(curve.logs)} points: chi squared {misfit:.1f} with "
              f"{steps.degrees_of_freedom(curve)} degrees of freedom, p = {p:.4f}")
    for degree in (steps.DEGREE, steps.DEGREE + 1):
        curve = steps.curve_of(sizes, degree)
        place, height, gain, p, tries = steps.best_step(curve)
        print(f"degree {degree}, best of {tries} single steps: at D/d = {place:.2f}, {100 * np.expm1(height):+.0f} %, chi squared better by {gain:.1f}, "
              f"p = {p:.4f} among {tries}")
        for name, places in steps.NAMED.items():
            height, error, p = steps.named_steps(curve, places)
            low, high = np.expm1(height - 1.96 * error), np.expm1(height + 1.96 * error)
            print(f"  steps where {name}: {100 * np.expm1(height):+.0f} % [{100 * low:+.0f}, {100 * high:+.0f}] each, p = {p:.4f} (one of {len(steps.NAMED)})")
    print("\n| from D/d | to | slope of ln of the mean |\n| --- | --- | --- |")
    for low, high, slope, error in steps.slopes(curve):
        print(f"| {low:.3g} | {high:.3g} | {slope:.2f} [{slope - 1.96 * error:.2f}, {slope + 1.96 * error:.2f}] |")


def base_profiles(file):
    """Height over d -> (height over width, profiles of the two halves of the runs)."""
    return {POINTS[name].height / NECK * POINTS[name].ratio: (POINTS[name].height / NECK, pair)
            for name, pair in read_profiles(file).items() if POINTS[name].is_base_but_for_height()}


def say_interpolation(sizes):
    """How well ln of the mean, as a line between the two neighbours, foretells each point in between."""
    ratios = np.array([r for r in sizes if r >= 1.99])
    logs = np.array([np.log(mean_of(sizes[r])[0]) for r in ratios])
    errors = np.array([log_error(sizes[r]) for r in ratios])
    share = (ratios[1:-1] - ratios[:-2]) / (ratios[2:] - ratios[:-2])
    missed = logs[1:-1] - (1 - share) * logs[:-2] - share * logs[2:]
    own = np.sqrt(errors[1:-1] ** 2 + ((1 - share) * errors[:-2]) ** 2 + (share * errors[2:]) ** 2)
    print(f"interpolation of each point from its neighbours: off by {100 * np.sqrt(np.mean(missed**2)):.1f} % (rms), of which the errors explain "
          f"{100 * np.sqrt(np.mean(own**2)):.1f} %; worst at D/d = {ratios[1:-1][np.argmax(np.abs(missed))]:.3g}: {100 * missed[np.argmax(np.abs(missed))]:+.0f} %")


def say_base(sizes):
    print("\n| D/d | bursts | mean | share empty |\n| --- | --- | --- | --- |")
    for ratio, fair in sizes.items():
        counts = [s for seed in fair.values() for s in seed]
        mean, low, high = mean_of(fair)
        print(f"| {ratio:.3g} | {len(counts)} | {mean:.3g} [{low:.3g}, {high:.3g}] | {counts.count(0) / len(counts):.2g} |")


def arch_counts(file):
    counts = {name: {} for name in COUNTS}
    with file.open(newline="") as table:
        for row in csv.DictReader(table):
            if POINTS[row["point"]].is_base():
                for name in COUNTS:
                    counts[name].setdefault(float(row["D/d [1]"]), []).append(int(row[f"{name} [1]"]))
    return counts


def say_arches(counts):
    print("\n| D/d | clogs | " + " | ".join(COUNTS) + " | (D/d)^2 + 1 |\n| --- |" + " --- |" * 6)
    for ratio in sorted(counts[COUNTS[0]]):
        cells = []
        for name in COUNTS:
            sizes = np.array(counts[name][ratio])
            cells.append(f"{sizes.mean():.2f} +- {sizes.std(ddof=1) / np.sqrt(len(sizes)):.2f} (from {sizes.min()})")
        print(f"| {ratio:.3g} | {len(counts[COUNTS[0]][ratio])} | " + " | ".join(cells) + f" | {ratio**2 + 1:.1f} |")


def say_line(counts):
    """Each count over all clogs as a line in (D/d)^2; clogs resampled."""
    random = np.random.default_rng(1)
    for name in COUNTS:
        x = np.concatenate([np.full(len(sizes), ratio**2) for ratio, sizes in counts[name].items()])
        y = np.concatenate(list(counts[name].values()))
        fits = [np.polyfit(x[k], y[k], 1) for k in random.integers(0, len(x), (1000, len(x)))]
        (slope, offset), (low, high) = np.polyfit(x, y, 1), np.quantile(fits, (0.025, 0.975), axis=0)
        print(f"{name}: {slope:.2f} [{low[0]:.2f}, {high[0]:.2f}] (D/d)^2 {offset:+.1f} [{low[1]:+.1f}, {high[1]:+.1f}]")


def say_copies(sets):
    curves = {}
    for (ratio, push, age), states in sorted(sets.items()):
        lags = range(max(r[0] for rows in states.values() for r in rows) + 1)
        shares = still_alike(states, lags)
        curves[f"D/d = {ratio:.4g}, push {push:g} d, age {age}"] = list(lags), shares
        apart = next((lag for lag, share in zip(lags, shares) if share < 0.5), None)
        print(f"\nD/d = {ratio:.4g}, push {push:g} d, age {age}, {len(states)} states: half of the copies are no longer alike after {apart} passages")
        split = sum(len({clogged for _, clogged, _ in rows}) > 1 for rows in states.values())
        print(f"  states of which not all copies agree whether they clog within {WITHIN}: {split} of {len(states)}")
        left = sizes(states)
        if len(left) > 1:
            share = foreseen(left)
            print(f"  particles until the clog, {share.states} states: mean {share.mean:.1f}, share of the variance between states {share.value:.3f} "
                  f"[{share.low:.3f}, {share.high:.3f}]; standard deviation within a state {np.sqrt(np.mean([np.var(s, ddof=1) for s in left])):.2f}")
        mean = np.mean([r[0] for rows in states.values() for r in rows])
        for last in sorted({min(WITHIN, max(1, round(mean * f))) for f in (0.5, 1, 2)}):
            groups = window(states, 0, last)
            if not 0 < np.mean(np.concatenate(groups)) < 1:
                continue
            share = foreseen(groups)
            gain, best = branching_gain(share.value, *COST[ratio])
            print(f"  clogs within {last}: chance {share.mean:.2f}, share of the variance between states {share.value:.2f} [{share.low:.2f}, {share.high:.2f}], "
                  f"p = {share.p_value:.3f}; gain of branching {gain:.2f} with {best} copies")
    return curves


def write_page(reports):
    folder = reports / "bridging"
    lines = write_law(reports)
    print(f"law.csv: {len(lines)} rows, {sum(line['status'] == 'measured' for line in lines)} of them measured")
    sizes_by_ratio = sizes_of_base(reports)
    draw_law(lines, steps.curve_of(sizes_by_ratio), folder / "law.png")
    say_base(sizes_by_ratio)
    say_interpolation(sizes_by_ratio)
    say_steps(sizes_by_ratio)
    necks, profiles = sizes_of_necks(reports), base_profiles(folder / "layers.csv")
    say_walls(necks, (3.05, steps.best_step(steps.curve_of(necks[1]))[0], 3.25))
    say_layers(profiles)
    draw_layers(profiles, necks, folder / "layers.png")
    counts = arch_counts(folder / "arches.csv")
    draw_arches(counts, folder / "arches.png")
    say_arches(counts)
    say_line(counts)
    if (folder / "committor.csv").exists():
        draw_copies(say_copies(read_copies(folder / "committor.csv")), folder / "copies.png")
