"""The figures of docs/reports/bridging.md."""

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from bursts import log_error, mean_of  # noqa: E402
from layers import BINS, at_half_height  # noqa: E402
from steps import NAMED, RANGE  # noqa: E402
from whole_file import rewritten  # noqa: E402


def save(figure, file):
    with rewritten(file, binary=True) as out:
        figure.savefig(out, dpi=130, format="png")
    plt.close(figure)


def draw_law(lines, curve, file):
    """Left: all of the table. Right: what a smooth curve leaves, and where steps were looked for."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    styles = {}
    for line in lines:
        low, high, mean = (line.get(f"mean burst{end} [1]", "") for end in (" low", " high", ""))
        if low in ("", 0) or line["D/d [1]"] < 1.7:
            continue
        friction = tuple(line[f"{k} friction [1]"] for k in ("sliding", "rolling", "torsion"))
        label = ", ".join(f"{f:g}" for f in friction) + ("" if line["half angle [deg]"] == 60 else f"; {line['half angle [deg]']:g} deg")
        label += "" if line["height over width [1]"] == 1 else f"; {line['height over width [1]']:g} D high"
        label += f"; spread {line['size spread [1]']:g}" if line["size spread [1]"] else ""
        label += "" if line["concentration fed [1]"] == "dense" else f"; fed {line['concentration fed [1]']:g}"
        style = styles.setdefault(label, {"color": f"C{len(styles) % 10}", "marker": "osD^v<>pPX"[len(styles) // 10 % 10]})
        first = label if label not in left.get_legend_handles_labels()[1] else None
        if mean == "":
            left.plot(line["D/d [1]"], low, "^", color=style["color"], mfc="none", ms=7, label=first)
            continue
        left.errorbar(line["D/d [1]"], mean, [[mean - low], [high - mean]], **style, ms=4, ls="", lw=1, label=first)
    left.set(yscale="log", xlabel="D/d", ylabel="particles until the clog")
    left.set_ylim(bottom=0.2)  # room below for the legend
    left.legend(fontsize=5.5, title="friction", title_fontsize=6, ncols=2, loc="lower right")
    rest = 100 * (np.exp(curve.logs - curve.smooth()) - 1)
    right.errorbar(curve.ratios, rest, 196 * curve.errors, fmt="o", color="k", ms=4, capsize=2)
    right.axhline(0, color="0.6", lw=0.8)
    for k, (name, places) in enumerate(NAMED.items()):
        for place in places:
            if RANGE[0] < place < RANGE[1]:
                right.axvline(place, color=f"C{k}", ls=(":", "--", "-.", "-")[k], lw=1, label=name if place == places[0] else None)
    right.set(xlabel="D/d", ylabel="mean burst over the smooth curve - 1 (%)")
    right.legend(fontsize=6)
    save(figure, file)


def draw_arches(counts, file):
    """\\param counts  name of the count -> D/d -> sizes of the clogs"""
    figure, axes = plt.subplots(figsize=(5.5, 4), constrained_layout=True)
    for k, (name, by_ratio) in enumerate(counts.items()):
        ratios = np.array(sorted(by_ratio))
        means = [np.mean(by_ratio[r]) for r in ratios]
        spread = [np.std(by_ratio[r]) for r in ratios]
        axes.errorbar(ratios + 0.012 * (k - 1), means, spread, fmt="osD^"[k], color=f"C{k}", ms=4, lw=0.8, label=name)
    x = np.linspace(*axes.get_xlim())
    axes.plot(x, x**2 + 1, "k-", lw=1, label="(D/d)$^2$ + 1")
    axes.plot(x, x + 1, "k--", lw=1, label="D/d + 1")
    axes.set(xlabel="D/d", ylabel="particles of a clog (mean, standard deviation)")
    axes.legend(fontsize=7)
    save(figure, file)


def draw_layers(profiles, necks, file):
    """Left: where the centres are, floor to ceiling, of square necks. Middle: at half height. Right: the law for each height.
    \param profiles  height over d -> (height over width, its two rows); \param necks  height over width -> D/d -> sizes"""
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(10, 4.2), constrained_layout=True)
    square = [(tall, pair.mean(axis=0)) for tall, (height, pair) in sorted(profiles.items()) if height == 1]
    places = (np.arange(BINS) + 0.5) / BINS
    for k, (tall, densities) in enumerate(square):
        left.plot(places, 0.8 * k + np.minimum(densities, 3.5) / 4, drawstyle="steps-mid", color="k", lw=0.9)
        left.text(1.02, 0.8 * k + 0.1, f"{tall:.3g}", fontsize=7)
    left.set(xlabel="height of the centre (0: on the floor)", yticks=[], xlim=(0, 1.13), title="density of centres; at right: D/d")
    for k, height in enumerate(sorted(necks)):
        style = {"color": f"C{k}", "marker": "osD^"[k], "ms": 4}
        seen = sorted((tall, at_half_height(pair).mean()) for tall, (h, pair) in profiles.items() if h == height)
        middle.plot(*np.array(seen).T, **style, lw=0.8, label=f"{height:g} D high")
        law = sorted((ratio, mean_of(fair)[0], log_error(fair)) for ratio, fair in necks[height].items() if 2.35 < ratio < 3.6)
        ratios, means, errors = np.array(law).T
        right.errorbar(ratios, means, 1.96 * errors * means, **style, lw=0.8, capsize=2, label=f"{height:g} D high")
        right.axvline(3.15 / height, color=f"C{k}", ls=":", lw=1)
    middle.set(xlabel="height over d", ylabel="density at half height over the mean")
    middle.axvline(3.15, color="0.6", ls=":", lw=1)
    right.set(xlabel="D/d (D: the width)", ylabel="particles until the clog", yscale="log", yticks=[10, 20, 30, 50], yticklabels=[10, 20, 30, 50])
    right.minorticks_off()
    for axes in (middle, right):
        axes.legend(fontsize=7)
    save(figure, file)


def draw_copies(curves, file):
    """\\param curves  label -> (lags, share of the copies that are still like the run)"""
    figure, axes = plt.subplots(figsize=(5.5, 3.6), constrained_layout=True)
    for label, (lags, shares) in curves.items():
        axes.plot(lags, shares, "o-", ms=3, lw=1, label=label)
    axes.set(xlabel="particles passed since the push", ylabel="share of copies still like the run", ylim=(-0.02, 1.04))
    axes.legend(fontsize=7)
    save(figure, file)
