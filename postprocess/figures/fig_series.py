"""How the channel fills and stays full: number of particles, packing fraction, porosity of the strips; and how the flow
is driven, where it is not steady."""

import matplotlib.pyplot as plt
import numpy as np

import run_file
import style
from stats_files import suffix


DRIVE = (("flow_factor", "flow $q$ [1]"), ("pressure_drop", "pressure drop [Pa]"))


def draw_lines(axes, runs, column, colour):
    """Every seed thin, their mean thick where all have data."""
    for time, values in ((run["time"], run[column]) for run in runs):
        axes.plot(time, values, color=colour, lw=0.5, alpha=0.35)
    end = min(run["time"][-1] for run in runs)
    start = max(run["time"][0] for run in runs)
    grid = np.linspace(start, end, 400)
    mean = np.mean([np.interp(grid, run["time"], run[column]) for run in runs], axis=0)
    axes.plot(grid, mean, color=colour, lw=1.6)


def draw_porosity(axes, runs):
    strips = min(run["porosity"].shape[1] for run in runs) if runs else 0
    if strips == 0:
        style.say(axes, "no porosity strips in this scene")
        return
    colours = [plt.get_cmap("cividis")(0.85 * k / max(strips - 1, 1)) for k in range(strips)]
    places = {0: "inlet", strips - 1: "neck"} if strips > 1 else {}
    for k in range(strips):
        with_strip = [{"time": run["time"], "eps": run["porosity"][:, k]} for run in runs]
        draw_lines(axes, with_strip, "eps", colours[k])
        name = f"strip {k + 1}" + (f" ({places[k]})" if k in places else "")
        axes.plot([], [], color=colours[k], lw=1.6, label=name)
    axes.legend(loc="upper right", ncols=min(strips, 4))
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.3 * (high - low))


def draw(group):
    runs = [run_file.read_series(entry["file"]) for entry in group["runs"]]
    runs = [run for run in runs if len(run["time"]) > 1]
    for run in runs:
        run["time"] = run["time"] / group["tau"]
    driven = [(column, label) for column, label in DRIVE if runs and all(column in run for run in runs)]
    rows = 3 + len(driven)
    figure, panels = plt.subplots(rows, 1, figsize=(style.width(style.PAGE), 5.2 / 3 * rows), sharex=True)
    for axes, column, label in ((panels[0], "count", "particles [1]"), (panels[1], "packing_fraction", "packing fraction [1]")):
        if runs:
            draw_lines(axes, runs, column, style.BLUE)
        else:
            style.say(axes, "no time series in these runs")
        axes.set_ylabel(label)
    draw_porosity(panels[2], runs)
    panels[2].set_ylabel(r"porosity $\epsilon$ [1]")
    for axes, (column, label) in zip(panels[3:], driven):
        draw_lines(axes, runs, column, style.BLUE)
        axes.set_ylabel(label)
    panels[-1].set_xlabel(r"time $t/\tau$ [1]")
    panels[-1].margins(x=0)
    seeds = "1 seed" if len(runs) == 1 else f"{len(runs)} seeds"
    panels[0].set_title(f"{style.plain(group['label'])}   (thin: {seeds}, thick: mean)")
    figure.align_ylabels()
    return figure


def figures(statistics):
    for index, group in enumerate(statistics.groups):
        yield f"series{suffix(statistics, index)}", draw(group)
