"""Spatio-temporal diagram at the neck: when does anything pass? (paper, figure 3)"""

import matplotlib.pyplot as plt
import numpy as np

import run_file
import style

MOST_ROWS = 40


def merged_bars(times, width):
    """Bars of the given width centred on each time, overlapping ones joined: (start, length)."""
    bars = []
    for t in np.sort(times):
        start, end = t - width / 2, t + width / 2
        if bars and start <= bars[-1][1]:
            bars[-1][1] = end
        else:
            bars.append([start, end])
    return [(a, b - a) for a, b in bars]


def draw_row(axes, run, row, tau, end):
    """One seed: grey from start to end, black while particles pass, red ticks at releases."""
    axes.broken_barh([(0, end)], (row - 0.4, 0.8), facecolors=style.CLOGGED, linewidth=0)
    bars = [(max(a, 0), min(a + w, end) - max(a, 0)) for a, w in merged_bars(run.passage_times / tau, 1.0)]
    if bars:
        axes.broken_barh(bars, (row - 0.4, 0.8), facecolors="black", linewidth=0)
    if len(run.release_times):
        axes.plot(run.release_times / tau, np.full(len(run.release_times), row + 0.46), ls="none", marker="|",
                  ms=3.2, mew=0.9, color=style.RELEASE, zorder=4)


def draw_group(axes, group, title):
    runs = group["runs"][:MOST_ROWS]
    longest = 0.0
    released = False
    for row, entry in enumerate(runs):
        run = run_file.read_events(entry["file"])
        end = entry["end"] / group["tau"]
        longest = max(longest, end)
        released |= len(run.release_times) > 0
        draw_row(axes, run, row, group["tau"], end)
    axes.set_yticks(range(len(runs)), [str(entry["seed"]) for entry in runs])
    axes.tick_params(axis="y", length=0, labelsize=style.points(7))
    axes.set_ylim(len(runs) - 0.28, -0.6)
    axes.set_xlim(0, longest or 1)
    axes.set_ylabel("seed")
    more = len(group["runs"]) - len(runs)
    axes.set_title(title + (f"  (first {len(runs)} of {len(group['runs'])} seeds)" if more > 0 else ""))
    return released


def key(axes, released):
    """What black, grey and red mean, above the axes."""
    handles = [plt.Rectangle((0, 0), 1, 1, color="black"), plt.Rectangle((0, 0), 1, 1, color=style.CLOGGED)]
    names = [r"particles pass (bar of width $\tau$)", "no passage"]
    if released:
        handles.append(plt.Line2D([], [], ls="none", marker="|", ms=6, mew=1, color=style.RELEASE))
        names.append("clog cleared")
    axes.legend(handles, names, loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.3, ncols=3)


def draw_sweep(statistics):
    """The first seed of every ensemble, over the median of their lengths: small particles have longer runs in tau."""
    groups = statistics.groups
    figure, axes = plt.subplots(figsize=(style.width(style.PAGE), 0.24 * len(groups) + 0.75))
    released = False
    for row, group in enumerate(groups):
        run = run_file.read_events(group["runs"][0]["file"])
        released |= len(run.release_times) > 0
        draw_row(axes, run, row, group["tau"], group["runs"][0]["end"] / group["tau"])
    axes.set_xlim(0, np.median([group["runs"][0]["end"] / group["tau"] for group in groups]))
    axes.set_ylim(len(groups) - 0.4, -0.6)
    axes.set_yticks(range(len(groups)), [style.plain(group["label"]) for group in groups])
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel(r"time $t/\tau$ [1]")
    key(axes, released)
    return figure


def draw(statistics):
    groups = statistics.groups
    rows = [min(len(group["runs"]), MOST_ROWS) for group in groups]
    height = sum(0.16 * n + 0.42 for n in rows) + 0.55
    figure, panels = plt.subplots(len(groups), 1, figsize=(style.width(style.PAGE), height), squeeze=False, sharex=True,
                                  gridspec_kw={"height_ratios": [n + 1 for n in rows]})
    released = False
    for axes, group in zip(panels[:, 0], groups):
        released |= draw_group(axes, group, style.plain(group["label"]))
    panels[-1, 0].set_xlabel(r"time $t/\tau$ [1]")
    key(panels[0, 0], released)
    return figure


def figures(statistics):
    if len(statistics.groups) > 1:
        yield "spatiotemporal_sweep", draw_sweep(statistics)
    yield "spatiotemporal", draw(statistics)
