"""Passages until the first clog: the share of seeds that pass more than n, and the hazard per passage against n."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.markers import CARETDOWNBASE

import style


def exists(statistics):
    """Whether the runs of a group end at their first clog: there is nothing else to show of them."""
    return any(group["protocol"] == "stop" for group in statistics.groups)


def label_of(group):
    first = group["first_burst"]
    mean, clogs = first["mean"], f"{first['clogged']} of {first['seeds']} seeds"
    if mean["value"] is None:
        known = f"> {mean['low']:.3g}" if mean["low"] is not None else "unknown"
    else:
        known = f"= {mean['value']:.3g}" + (f" [{mean['low']:.3g}, {mean['high']:.3g}]" if mean["low"] is not None else "")
    law = ", geometric law ruled out" if first["geometric"]["ruled_out"] else ""
    if "tail" in first["geometric"]:
        law += f" before $n$ = {first['geometric']['tail']['from']}"
    return f"{style.plain(group['label'])}: $\\langle s\\rangle$ {known}\n{clogs} clogged{law}"


def steps_of(rows, largest):
    """n, S and its error as steps from (0, 1) on, S(n) from n on, level until the largest count."""
    n = np.array([0] + [row["n [1]"] for row in rows] + [largest])
    survival = np.array([1.0] + [row["S [1]"] for row in rows])
    error = style.TO_95 * np.array([0.0] + [row["error [1]"] for row in rows])
    return n, np.append(survival, survival[-1]), np.append(error, error[-1])


def draw_law(axes, first, n, survival, colour):
    """The geometric law, from where on it is not ruled out."""
    tail = first["geometric"].get("tail", {"from": 0, "hazard": first["hazard"]})
    hazard = tail["hazard"]["value"]
    if not hazard or (first["geometric"]["ruled_out"] and "tail" not in first["geometric"]):
        return
    start = survival[n < tail["from"]][-1] if tail["from"] > 0 else 1.0
    x = np.linspace(tail["from"], n[-1], 200)
    axes.plot(x, start * (1 - hazard) ** (x - tail["from"] + 1), "--", color=colour, lw=0.9, zorder=1)


def draw_survival(axes, rows, group, colour):
    n, survival, error = steps_of(rows, group["first_burst"]["largest"])
    lowest = 0.5 / group["first_burst"]["seeds"]
    # S = 0, where all have clogged, has no place on a log axis: the line ends below what one seed can show.
    shown = np.maximum(survival, lowest)
    axes.step(n, shown, where="post", color=colour, label=label_of(group))
    axes.fill_between(n, np.maximum(survival - error, lowest), np.maximum(np.minimum(survival + error, 1), lowest), step="post",
                      color=colour, alpha=0.2, lw=0)
    draw_law(axes, group["first_burst"], n, survival, colour)
    return lowest


def draw_hazard(axes, rows, colour, marker):
    """A point a bin at the middle of its trials; a bin without a clog is an upper bound."""
    for row in rows:
        middle = 0.5 * (row["n_from [1]"] + row["n_to [1]"] - 1)
        axes.plot([row["n_from [1]"] - 0.5, row["n_to [1]"] - 0.5], 2 * [row["hazard [1]"] or row["high [1]"]], color=colour, lw=0.8)
        if row["clogs"] == 0:
            axes.plot(middle, row["high [1]"], marker=CARETDOWNBASE, ms=7, color=colour)
            continue
        axes.plot([middle, middle], [row["low [1]"], row["high [1]"]], color=colour, lw=1)
        axes.plot(middle, row["hazard [1]"], marker, ms=4, color=colour, mec="white", mew=0.4)


def figures(statistics):
    if not exists(statistics):
        return
    figure, (above, below) = plt.subplots(2, 1, figsize=(style.width(4.6), 5.4), sharex=True, height_ratios=(3, 2))
    colours = style.group_colours(len(statistics.groups))
    lowest, empty = 0.5, True
    for index, group in enumerate(statistics.groups):
        trials = statistics.rows("first_burst_hazard", index)
        if not trials:
            continue
        empty = False
        lowest = min(lowest, draw_survival(above, statistics.rows("first_burst_survival", index), group, colours[index]))
        draw_hazard(below, trials, colours[index], style.MARKERS[index % len(style.MARKERS)])
    if empty:
        for axes in (above, below):
            style.say(axes, "no passage and no clog in these runs")
    else:
        if any(line.get_linestyle() == "--" for line in above.lines):
            above.plot([], [], "--", color=style.GREY, label="geometric law, where it is not ruled out")
        above.set_yscale("log")
        above.set_ylim(lowest, 1.15)
        below.set_yscale("log")
    above.set_ylabel("share of seeds that pass\nmore than $n$ [1]")
    below.set_ylabel("hazard per passage [1]")
    below.set_xlabel("passages so far $n$ [1]")
    if len(statistics.groups) > style.MOST_GROUPS_INSIDE:
        style.legend_beside(above)
    elif not empty:
        style.legend(above, loc="lower left", bbox_to_anchor=(0, 1.01), borderaxespad=0)
    yield "first_burst", figure
