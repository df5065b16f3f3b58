"""Distribution of the burst sizes, P(s/<s>) (paper, figure 4)."""

import numpy as np

import fig_trend
import style
from stats_files import value


def draw_geometric(axes, rows, mean, verdict):
    """Share of each bin under P(s) = p (1 - p)^(s-1), p = 1/<s>: the law of a memoryless stopping."""
    go_on = 1 - 1 / mean
    low = np.array([row["s_from [1]"] for row in rows])
    high = np.array([row["s_to [1]"] for row in rows])
    x = np.array([row["s/<s> [1]"] for row in rows])
    density = (go_on ** (low - 0.5) - go_on ** (high - 0.5)) / (high - low) * mean
    axes.plot(x, density, color=style.GREY, ls="--", zorder=1, label=f"geometric law: {verdict}")


def label_of(group, verdict):
    mean, low, high = value(group, "mean_burst")
    spread = f" [{low:.3g}, {high:.3g}]" if np.isfinite(low) else ""
    return f"{style.plain(group['label'])}: $\\langle s\\rangle$ = {mean:.3g}{spread}, {group['bursts']['counted']} bursts{verdict}"


def draw_distribution(axes, statistics):
    colours = style.group_colours(len(statistics.groups))
    largest, smallest, top, empty = 0.0, np.inf, 0.0, True
    single = len(statistics.groups) == 1
    for index, group in enumerate(statistics.groups):
        rows = [row for row in statistics.rows("burst_distribution", index) if row["count"] > 0]
        if not rows:
            continue
        empty = False
        x = np.array([row["s/<s> [1]"] for row in rows])
        p = np.array([row["P [1]"] for row in rows])
        error = style.TO_95 * np.array([row["error [1]"] for row in rows])
        # The interval of a few counts reaches zero: on a log axis its bar ends not far below.
        below = np.minimum(error, 0.7 * p)
        law = group["bursts"]["geometric"]
        if single:
            draw_geometric(axes, statistics.rows("burst_distribution", index), value(group, "mean_burst")[0], law["verdict"])
        axes.errorbar(x, p, yerr=[below, error], fmt=style.MARKERS[index % len(style.MARKERS)], ms=4, lw=0.8, capsize=0,
                      color=colours[index], mec="white", mew=0.4,
                      label=label_of(group, "\ngeometric law ruled out" if law["ruled_out"] and not single else ""))
        largest, smallest, top = max(largest, x.max() * 1.08), min(smallest, (p - below).min()), max(top, (p + error).max())
    if not single:
        x = np.linspace(0, largest or 4, 100)
        axes.plot(x, np.exp(-x), color=style.GREY, ls="--", zorder=1,
                  label=r"$e^{-s/\langle s\rangle}$: geometric law at large $\langle s\rangle$")
    axes.set_yscale("log")
    if empty:
        style.say(axes, "no burst that began and ended\nwithin the runs")
        largest, smallest, top = 4.0, 0.05, 1.0
    axes.set_xlim(0, largest)
    axes.set_ylim(max(0.7 * smallest, 1e-5), 1.3 * top)
    axes.set_xlabel(r"burst size $s/\langle s\rangle$ [1]")
    axes.set_ylabel(r"probability density $P(s/\langle s\rangle)$ [1]")
    if len(statistics.groups) > style.MOST_GROUPS_INSIDE:
        style.legend_beside(axes)
    else:
        style.room_for_legend(axes)
        style.legend(axes, loc="upper right")


def figures(statistics):
    sweep = fig_trend.exists(statistics)
    figure, panels = style.row_of_panels(2 if sweep else 1, style.PAGE / 2 if sweep else 4.6, 3.3)
    draw_distribution(panels[0], statistics)
    if sweep:
        fig_trend.draw_mean_burst(panels[1], statistics)
    yield "bursts", figure
