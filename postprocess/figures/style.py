"""One look for all figures: sizes, fonts, colours, and saving as PNG and SVG."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

INK = "#1d2733"        # text and axes
GREY = "#8a949e"       # guides and rivals
CLOGGED = "#d3d7db"    # no flow in the spatio-temporal diagram
WALL = "#c2c8ce"       # solid walls
BLUE = "#1f5fa8"       # data of a single group
RELEASE = "#c8432b"    # friction off
COLUMN = 3.4           # width of one column [inch]
PAGE = 7.0             # width of both [inch]

LOOK = {
    "figure.dpi": 100, "savefig.dpi": 220, "figure.constrained_layout.use": True,
    "font.family": "DejaVu Sans", "mathtext.fontset": "dejavusans", "font.size": 8.5,
    "axes.labelsize": 9, "axes.titlesize": 9, "axes.titlelocation": "left", "axes.titleweight": "bold",
    "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK,
    "axes.linewidth": 0.7, "xtick.direction": "in", "ytick.direction": "in", "xtick.top": True, "ytick.right": True,
    "xtick.major.width": 0.7, "ytick.major.width": 0.7, "xtick.minor.width": 0.5, "ytick.minor.width": 0.5,
    "legend.frameon": False, "legend.fontsize": 7.5, "legend.handlelength": 1.6, "lines.linewidth": 1.3,
    "svg.fonttype": "none", "svg.hashsalt": "clogflow", "axes.axisbelow": True,
}
plt.rcParams.update(LOOK)

MARKERS = "osD^vP<>X"


def group_colours(count):
    """Dark to light from large to small particles; one group is the darkest."""
    if count == 1:
        return [BLUE]
    return [plt.get_cmap("viridis")(0.88 * k / (count - 1)) for k in range(count)]


MOST_GROUPS_INSIDE = 3  # the legend of more goes beside the panels, where it covers no data


def legend_entries(axes):
    """Data first and the guides after them (matplotlib puts lines before error bars): handles, labels."""
    handles, labels = axes.get_legend_handles_labels()
    order = sorted(range(len(handles)), key=lambda k: not hasattr(handles[k], "has_yerr"))
    return [handles[k] for k in order], [labels[k] for k in order]


def plain(text):
    """Foreign text for a label: a dollar sign would start mathematics."""
    return str(text).replace("$", r"\$")


def legend(axes, **where):
    handles, labels = legend_entries(axes)
    if handles:
        axes.legend(handles, labels, **where)


def legend_beside(axes):
    """The same to the right of all panels; the figure grows by its width."""
    figure = axes.figure
    handles, labels = legend_entries(axes)
    if handles:
        beside = figure.legend(handles, labels, loc="upper right")
        panels = figure.get_figwidth()
        total = panels + beside.get_window_extent(figure.canvas.get_renderer()).width / figure.dpi
        figure.set_figwidth(total)
        figure.get_layout_engine().set(rect=(0, 0, panels / total, 1))


def room_for_legend(axes):
    """Space above the data of a logarithmic axis for a legend with these entries."""
    lines = sum(1 + label.count("\n") for label in axes.get_legend_handles_labels()[1])
    low, high = np.log(axes.get_ylim())
    axes.set_ylim(top=np.exp(high + (high - low) * (0.04 + 0.075 * lines)))


def say(axes, text):
    """Writes into an empty panel what is missing, instead of failing."""
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", color=GREY, fontsize=9)


def save(figure, folder, name):
    """Both formats, without the date so that equal data give equal files. Returns the paths."""
    paths = [Path(folder) / f"{name}.{kind}" for kind in ("png", "svg")]
    for path in paths:
        metadata = {"Date": None} if path.suffix == ".svg" else {"Software": None}
        figure.savefig(path, metadata=metadata)
    plt.close(figure)
    return paths
