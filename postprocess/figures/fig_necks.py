"""Several necks side by side: what each lets pass over time, and its mean burst beside that of all together."""

import matplotlib.pyplot as plt
import numpy as np

import run_file
import style
from stats_files import suffix, value

MEANS = (("mean_burst", "o", "until all stand"), ("mean_burst_by_threshold", "s", "until it stands itself"))
NOTHING_TO_SHOW = "no burst that began and ended"


def name_of(neck):
    return f"neck {neck}"


def draw_passages(axes, group, colours):
    """Passages of the first seed, friction on, summed up; grey where a clog was cleared and nothing counts."""
    run = group["runs"][0]
    events = run_file.read_events(run["file"])
    if events.passage_times.size == 0:
        style.say(axes, "nothing passes in the first seed")
    for off, on in zip(events.release_times / group["tau"], events.release_ends / group["tau"]):
        axes.axvspan(off, on, color=style.CLOGGED, lw=0, zorder=0)
    end = run["end"] / group["tau"]
    for neck, colour in enumerate(colours):
        times = events.passage_times[events.passage_necks == neck] / group["tau"]
        axes.step(np.concatenate(([0], times, [end])), np.append(np.arange(times.size + 1), times.size), where="post",
                  color=colour, label=name_of(neck))
    axes.set_xlim(0, end)
    axes.set_ylim(bottom=0)
    axes.set_xlabel(r"time $t/\tau$ [1]")
    axes.set_ylabel("passages so far [1]")
    axes.set_title(f"{style.plain(group['label'])}, seed {run['seed']}")
    if events.release_times.size:
        axes.fill_between([], [], color=style.CLOGGED, lw=0, label="without friction: not counted")
    axes.legend(loc="lower right", frameon=True, framealpha=1, edgecolor="white")


def draw_means(axes, group, colours):
    """<s> of each neck and of all together, with intervals; a missing bound is no bar."""
    parts = [*group["necks"], group]
    shown = False
    for shift, (key, marker, name) in zip((-0.12, 0.12), MEANS):
        for place, (part, colour) in enumerate(zip(parts, [*colours, style.INK])):
            mean, low, high = value(part, key)
            if np.isnan(mean):
                continue
            shown = True
            bars = np.nan_to_num([[mean - low], [high - mean]])
            axes.errorbar([place + shift], [mean], yerr=bars, fmt=marker, ms=4.5, lw=1, capsize=2, color=colour, mec="white", mew=0.3)
        axes.plot([], [], marker, ms=4.5, color=style.GREY, label=name)
    axes.set_xlim(-0.5, len(parts) - 0.5)
    axes.set_xticks(range(len(parts)), [*map(name_of, range(len(parts) - 1)), "together"])
    axes.set_ylabel(r"$\langle s\rangle$: passages per clog [1]")
    if not shown:
        style.say(axes, NOTHING_TO_SHOW)
        return
    axes.set_ylim(0, 1.3 * axes.get_ylim()[1])
    axes.legend(loc="upper left")


def draw(group):
    side_by_side = style.panels_in_row(2, 2.6) == 2
    figure, (passages, means) = plt.subplots(*((1, 2) if side_by_side else (2, 1)), figsize=(style.width(style.PAGE), 2.7 if side_by_side else 5),
                                             **({"width_ratios": (1.7, 1)} if side_by_side else {}))
    colours = [plt.get_cmap("viridis")(0.75 * k / (len(group["necks"]) - 1)) for k in range(len(group["necks"]))]
    draw_passages(passages, group, colours)
    draw_means(means, group, colours)
    return figure


def figures(statistics):
    for index, group in enumerate(statistics.groups):
        if group.get("necks"):
            yield f"necks{suffix(statistics, index)}", draw(group)
