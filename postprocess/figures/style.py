"""One look for all figures: sizes, fonts, colours, and saving as PNG, SVG and PDF."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

INK = "#1d2733"        # text and axes
GREY = "#8a949e"       # guides and rivals
CLOGGED = "#d3d7db"    # no flow in the spatio-temporal diagram
WALL = "#c2c8ce"       # solid walls
BLUE = "#1f5fa8"       # data of a single group
RELEASE = "#c8432b"    # friction off
PAGE = 7.0             # width of a figure that fills a page [inch]
FONT = 8.5             # [pt]
INCH = 0.0254          # [m]
TO_95 = 1.96           # of a standard error: half of a 95 % interval, where the estimate is close to normal

chosen = {"width": None, "font": FONT}  # by the user: inches, points

LOOK = {
    "figure.dpi": 100, "savefig.dpi": 220, "figure.constrained_layout.use": True,
    "font.family": "DejaVu Sans", "mathtext.fontset": "dejavusans", "font.size": 8.5,
    "axes.labelsize": 9, "axes.titlesize": 9, "axes.titlelocation": "left", "axes.titleweight": "bold",
    "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK,
    "axes.linewidth": 0.7, "xtick.direction": "in", "ytick.direction": "in", "xtick.top": True, "ytick.right": True,
    "xtick.major.width": 0.7, "ytick.major.width": 0.7, "xtick.minor.width": 0.5, "ytick.minor.width": 0.5,
    "legend.frameon": False, "legend.fontsize": 7.5, "legend.handlelength": 1.6, "lines.linewidth": 1.3,
    "pdf.fonttype": 42, "ps.fonttype": 42, "svg.fonttype": "none", "svg.hashsalt": "clogflow", "axes.axisbelow": True,
}
plt.rcParams.update(LOOK)
SIZES = [key for key in LOOK if key.endswith("size") and isinstance(LOOK[key], (int, float))]


def choose(width=0, font=0):
    """Every figure this wide [m], its text this large [pt]; 0: as it likes to be."""
    chosen.update(width=width / INCH if width else None, font=font or FONT)
    LOOK.update({key: LOOK[key] * chosen["font"] / FONT for key in SIZES})
    plt.rcParams.update(LOOK)


def points(size):
    """A font size that is right beside 8.5 points, beside the chosen ones [pt]."""
    return size * chosen["font"] / FONT


def width(natural):
    """Of a figure that likes to be this wide [inch]."""
    return chosen["width"] or natural


def panels_in_row(count, narrowest):
    """How many of the panels stand side by side, each at least this wide [inch]; the others go below."""
    fitting = max(1, min(count, int(width(1e3) / (narrowest * chosen["font"] / FONT))))
    return -(-count // -(-count // fitting))


def row_of_panels(count, each, height, narrowest=2.6):
    """(figure, panels) that like to be `each` wide and `height` high [inch], side by side as far as the chosen width allows."""
    columns = panels_in_row(count, narrowest)
    rows = -(-count // columns)
    total = width(each * count)
    figure, grid = plt.subplots(rows, columns, figsize=(total, rows * min(height, max(0.8 * total / columns, 0.7 * height))), squeeze=False)
    for axes in grid.flat[count:]:
        axes.set_axis_off()
    return figure, list(grid.flat[:count])

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


INTERVALS = "bars, bands and [ ]: 95 % intervals"


def title_of(handles, labels):
    """Of a legend: which kind of interval is drawn, where one is."""
    return INTERVALS if any(hasattr(handle, "has_yerr") for handle in handles) or any("[" in label for label in labels) else None


def titled(legend):
    legend.set_alignment("left")
    legend.get_title().set(fontsize=points(6.8), color=GREY)
    return legend


def legend(axes, **where):
    handles, labels = legend_entries(axes)
    if handles:
        titled(axes.legend(handles, labels, title=title_of(handles, labels), **where))


def legend_beside(axes):
    """The same to the right of all panels; the figure grows by its width, or by its height below where the width is chosen."""
    figure = axes.figure
    handles, labels = legend_entries(axes)
    if handles and chosen["width"]:
        below = titled(figure.legend(handles, labels, title=title_of(handles, labels), loc="lower left"))
        panels = figure.get_figheight()
        total = panels + below.get_window_extent(figure.canvas.get_renderer()).height / figure.dpi
        figure.set_figheight(total)
        figure.get_layout_engine().set(rect=(0, 1 - panels / total, 1, panels / total))
    elif handles:
        beside = titled(figure.legend(handles, labels, title=title_of(handles, labels), loc="upper right"))
        panels = figure.get_figwidth()
        total = panels + beside.get_window_extent(figure.canvas.get_renderer()).width / figure.dpi
        figure.set_figwidth(total)
        figure.get_layout_engine().set(rect=(0, 0, panels / total, 1))


def label_within_a_decade(axis):
    """Minor marks of a logarithmic axis that spans less than a decade have labels: one power of ten alone tells no scale."""
    low, high = axis.get_view_interval()
    if high < 10 * low:
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter("{x:g}")
        axis.set_tick_params(which="minor", labelsize=points(7))


def room_for_legend(axes):
    """Space above the data of a logarithmic axis for a legend with these entries."""
    handles, labels = axes.get_legend_handles_labels()
    lines = sum(1 + label.count("\n") for label in labels) + (title_of(handles, labels) is not None)
    low, high = np.log(axes.get_ylim())
    share = 0.04 + 0.075 * lines  # of the height, once there is room
    axes.set_ylim(top=np.exp(high + (high - low) * share / (1 - share)))


def say(axes, text):
    """Writes into an empty panel what is missing, instead of failing."""
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", color=GREY, fontsize=points(9))


def save(figure, folder, name):
    """All formats, without the date so that equal data give equal files; PDF holds its fonts. Returns the paths."""
    metadata = {"png": {"Software": None}, "svg": {"Date": None}, "pdf": {"CreationDate": None, "Creator": None, "Producer": None}}
    paths = [Path(folder) / f"{name}.{kind}" for kind in metadata]
    for path, words in zip(paths, metadata.values()):
        figure.savefig(path, metadata=words)
        figure.set_layout_engine("none")  # where things stand is settled
    plt.close(figure)
    return paths
