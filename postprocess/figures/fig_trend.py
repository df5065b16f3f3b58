"""Panels of a sweep: <s> and alpha of every point, bounds as triangles, and the fitted laws (paper, figures 4 and 5)."""

import numpy as np
from matplotlib.markers import CARETDOWNBASE, CARETUPBASE

import style
from lengths import unit_of

CUT = ("cut by releases", "cut by the stop")  # arrests whose exponent is no property of the clogs
UNFITTED = ("mostly empty", *CUT)
DISPLAY = {"rad": ("deg", 180 / np.pi), "s": ("ms", 1e3)}


def shown_in(unit, values):
    """(unit, its number in one of `unit`)"""
    return unit_of(*values) if unit == "m" else DISPLAY.get(unit, (unit, 1.0))


class Variable:
    """What the panels are drawn against: D/d, another swept number, or words in order of appearance."""

    def __init__(self, trend):
        variable = trend["variable"]
        self.is_ratio = variable["name"] == "D/d"
        self.numeric = variable["numeric"]
        unit, self.scale = shown_in(variable["unit"], [p["x"] for p in trend["points"]]) if self.numeric else ("", 1.0)
        self.name = "neck-to-particle ratio $D/d$ [1]" if self.is_ratio else style.plain(f"{variable['name']} [{unit}]".removesuffix(" []"))
        self.words = {p["x"]: style.plain(p["values"].get(variable["key"], "")) for p in trend["points"]}

    def label(self, axes, name=None):
        axes.set_xlabel(name or self.name)
        if not self.numeric:
            axes.set_xticks(list(self.words), list(self.words.values()))
            axes.set_xlim(min(self.words) - 0.5, max(self.words) + 0.5)


def draw_point(axes, x, entry, colour, marker="o"):
    """Value with interval; a bound as a triangle that stands or hangs on it."""
    if entry["status"] == "lower bound":
        axes.plot(x, entry["low"], marker=CARETUPBASE, ms=7, color=colour)
    elif entry["status"] == "upper bound":
        axes.plot(x, entry["high"], marker=CARETDOWNBASE, ms=7, color=colour)
    elif entry["value"] is not None:
        if entry["low"] is not None:
            axes.plot([x, x], [entry["low"], entry["high"]], color=colour, lw=1)
        face = "white" if entry["status"] in UNFITTED else colour
        axes.plot(x, entry["value"], marker, ms=5, color=colour, mfc=face)


def draw_law(axes, series, xs, quantity, scale, line, symbol):
    """The fitted exponential over the range of the points, with the interval of its slope."""
    fit = series[quantity]
    if "refused" in fit or len(xs) < 2:
        return
    x = np.linspace(min(xs), max(xs), 100)
    b = fit["b"]
    misfit = "" if fit["p_value"] > 0.05 else f"\nmisses the points: p = {fit['p_value']:.1g}"
    axes.plot(x * scale, np.exp(fit["ln_A"]["value"] + b["value"] * x), ls=line, color=style.INK, lw=1.1, zorder=1,
              label=f"{symbol}, b = {b['value']:.3g} [{b['low']:.3g}, {b['high']:.3g}]{misfit}")


LINES = ("--", "-.", ":", (0, (6, 1, 1, 1, 1, 1)))  # of the laws, one a series


def right_edge(xs):
    """Beyond it a bound is drawn at the edge, lest one far point squeeze all others together."""
    return max(xs) + 0.35 * (max(xs) - min(xs)) if len(xs) > 1 else np.inf


def point_out(axes, x, point, colour):
    axes.text(x, point["mean_burst"]["low"] * 0.8, f"D/d = {point['x']:.3g} →", ha="right", va="top", fontsize=style.points(7), color=colour)


def draw(axes, statistics, quantity, transform, symbol):
    trend = statistics.data["trend"]
    variable = Variable(trend)
    colours = style.group_colours(len(statistics.groups))  # a colour is a scene, in every panel; a marker is a series
    marker_of = [style.MARKERS[k % len(style.MARKERS)] for k in range(len(trend["series"]))]
    edge = right_edge([transform(p["x"]) for p in trend["points"] if p[quantity]["value"] is not None])
    for point in trend["points"]:
        x, colour = transform(point["x"]), colours[point["group"]]
        if x > edge and point[quantity]["status"] == "lower bound":
            point_out(axes, edge * variable.scale, point, colour)
        draw_point(axes, min(x, edge) * variable.scale, point[quantity], colour, marker_of[point["series"]])
    for index, series in enumerate(trend["series"]):
        mine = [p for p in trend["points"] if p["series"] == index]
        fitted = [transform(p["x"]) for p in mine if p[quantity]["status"] == "measured"]
        if series["label"]:
            axes.plot([], [], marker_of[index], color=style.GREY, label=style.plain(series["label"]))
        draw_law(axes, series, fitted, quantity, variable.scale, LINES[index % len(LINES)], symbol)
    return variable


def draw_mean_burst(axes, statistics):
    variable = draw_against_power(axes, statistics)
    axes.set_yscale("log")
    variable.label(axes, r"$(D/d)^3$ [1]" if variable.is_ratio else None)
    axes.set_ylabel(r"mean burst size $\langle s\rangle$ [1]")
    style.room_for_legend(axes)
    style.label_within_a_decade(axes.yaxis)
    style.legend(axes, loc="upper left")


def draw_against_power(axes, statistics):
    is_ratio = Variable(statistics.data["trend"]).is_ratio
    symbol = r"$A\,e^{b(D/d)^3}$" if is_ratio else r"$A\,e^{bx}$"
    return draw(axes, statistics, "mean_burst", (lambda x: x**3) if is_ratio else (lambda x: x), symbol)


def draw_alpha(axes, statistics):
    is_ratio = Variable(statistics.data["trend"]).is_ratio
    variable = draw(axes, statistics, "alpha", lambda x: x, r"$A\,e^{bD/d}$" if is_ratio else r"$A\,e^{bx}$")
    axes.set_yscale("log")
    low, high = axes.get_ylim()
    if 0.8 * low < 2 < 1.2 * high:  # where it is near: half an axis without a point says nothing
        axes.axhline(2, color=style.GREY, lw=0.8, ls=":")
    for status in CUT:
        if any(point["alpha"]["status"] == status for point in statistics.data["trend"]["points"]):
            axes.plot([], [], "o", color=style.INK, mfc="white", label=f"arrests {status}")
    if all(point["alpha"]["status"] == "no arrest" for point in statistics.data["trend"]["points"]):
        style.say(axes, r"no arrest ($T \geq T_{\min}$) in any run")
    style.label_within_a_decade(axes.yaxis)
    variable.label(axes)
    axes.set_ylabel(r"exponent $\alpha$ ($T \geq T_{\min}$) [1]")
    style.room_for_legend(axes)
    style.legend(axes, loc="upper left")


def exists(statistics):
    """Whether there is a sweep to draw."""
    return len(statistics.groups) > 1 and "trend" in statistics.data
