"""The statistics of the campaign, by size of the neck, and how its numbers are written."""

import json
import math
import sys
import tomllib
from pathlib import Path

FIGURES = Path(__file__).resolve().parents[3] / "postprocess" / "figures"
MAKE = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(FIGURES), str(MAKE), str(MAKE / "bridging")]

from stats_files import Statistics  # noqa: E402  (found through the line above)

PAPER_DIAMETERS_UM = (80, 70, 50, 40, 33, 28, 25, 22, 10)
NECK_UM = 100
SIZES = ("D/d", "")  # what a sweep of the sizes is called, and one size alone


class Point:
    """One size: its group of the statistics and its place in the trend."""

    def __init__(self, statistics, trend_point):
        self.index = trend_point["group"]
        self.group = statistics.groups[self.index]
        self.trend = trend_point
        self.ratio = self.group["geometry"]["neck_ratio"]
        self.first_sizes = [row["s [1]"] for row in statistics.rows("bursts", self.index) if row["kind"] == "first"]

    @property
    def bursts(self):
        return self.group["bursts"]

    def quantity(self, key):
        return self.group["quantities"][key]

    def core_hours(self):
        return sum(run["wall_time"] or math.nan for run in self.group["runs"]) / 3600


def numerics(group):
    """What a group was computed with, in words."""
    scene = tomllib.loads(group["scene"])
    time = scene["time"]
    return (f"{scene['contact']['youngs_modulus']}, mass x {time['mass_scale']:g}, moment of inertia x {time['rotational_inertia_scale']:g}, a step of "
            f"{time['contact_limit_share']:g} of what the contacts allow")


class Sweep:
    """<s> along another key, at one size."""

    def __init__(self, folder):
        self.statistics = Statistics(folder)
        self.trend = self.statistics.data["trend"]
        self.key = self.trend["variable"]["name"]
        self.points = sorted(self.trend["points"], key=lambda p: p["x"])
        self.groups = [self.statistics.groups[p["group"]] for p in self.points]
        self.ratio = self.groups[0]["geometry"]["neck_ratio"]

    def values(self):
        return [p["values"][self.key] for p in self.points]

    def chi_squared(self):
        """Of a <s> that does not depend on the key, and its degrees of freedom: ln<s> about its weighted mean."""
        logs = [math.log(p["mean_burst"]["value"]) for p in self.points]
        weights = [(math.log(p["mean_burst"]["high"] / p["mean_burst"]["low"]) / (2 * 1.96)) ** -2 for p in self.points]
        mean = sum(w * y for w, y in zip(weights, logs)) / sum(weights)
        return sum(w * (y - mean) ** 2 for w, y in zip(weights, logs)), len(logs) - 1


class Campaign:
    """All sizes at one set of numerics; beside it others of the same sizes, and sweeps of other keys."""

    def __init__(self, folder, beside=()):
        others = [Sweep(other) for other in beside]
        self.others = [Campaign(sweep.statistics.folder) for sweep in others if sweep.key in SIZES]
        self.sweeps = {sweep.key: sweep for sweep in others if sweep.key not in SIZES}
        self.statistics = Statistics(folder)
        self.trend = self.statistics.data["trend"]
        self.points = sorted((Point(self.statistics, p) for p in self.trend["points"]), key=lambda p: p.ratio)
        self.fit = self.trend["series"][0]

    def at(self, diameter_um):
        """The point of a diameter, or None when it was not run."""
        ratio = NECK_UM / diameter_um
        return next((p for p in self.points if abs(p.ratio - ratio) < 0.01 * ratio), None)

    def missing(self):
        return [d for d in PAPER_DIAMETERS_UM if all(c.at(d) is None for c in (self, *self.others))]

    @staticmethod
    def channel_of(point):
        """Straight channel before the narrowing, in neck widths."""
        geometry = point.group["geometry"]
        return geometry["channel_length"] / geometry["neck_width"]

    def with_clogs(self):
        return [p for p in self.points if p.trend["mean_burst"]["stops"] > 0]


def number(value, digits=3):
    """Three digits, without an exponent where a reader expects none."""
    if value is None or not math.isfinite(value):
        return "-"
    text = f"{value:.{digits}g}"
    return f"{value:.0f}" if "e+" in text and abs(value) < 1e7 else text


def estimate(entry, digits=3):
    """Value with its interval, or the bound it has."""
    if entry.get("status") == "lower bound":
        return f"> {number(entry['low'], digits)}"
    if entry.get("status") == "upper bound":
        return f"< {number(entry['high'], digits)}"
    if entry["value"] is None and entry["high"] is not None:
        return f"< {number(entry['high'], digits)}"
    if entry["value"] is None:
        return "-" if entry["low"] is None else f"> {number(entry['low'], digits)}"
    if entry["low"] is None or entry["high"] is None:
        return number(entry["value"], digits)
    return f"{number(entry['value'], digits)} [{number(entry['low'], digits)}, {number(entry['high'], digits)}]"


def over(a, b):
    """Value, low and high of a / b, two positive estimates with intervals; errors of both in the logarithm."""
    ratio = a["value"] / b["value"]
    spread = math.hypot(*(0.5 * math.log(m["high"] / m["low"]) for m in (a, b)))
    return {"value": ratio, "low": ratio * math.exp(-spread), "high": ratio * math.exp(spread)}


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def softness(ratio):
    """What 10 MPa, mass x 30 and the step do to <s>, by the response of docs/reports/trade.md at this D/d; None where it was not studied."""
    for file in sorted((FIGURES.parents[1] / "docs" / "reports" / "trade").glob("d??.json")):
        study = json.loads(file.read_text(encoding="utf-8"))
        if abs(study["neck_ratio"] / ratio - 1) < 0.01:
            setting = next(s for s in study["settings"] if s["name"] == "10MPa_m30_limit70")
            return setting["from_paper"]["mean_burst"]
    return None
