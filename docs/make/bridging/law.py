"""The table of the law: a row for each set of geometry, friction and feed, with its interval or its bound."""

import csv
import math

from bursts import fair_sizes, mean_of, read_sizes
from points import FULL, NECK, POINTS
from whole_file import rewritten

UNITS = {"D/d": "1", "half angle": "deg", "height over width": "1", "size spread": "1", "sliding friction": "1",
         "rolling friction": "1", "torsion friction": "1", "concentration fed": "1", "packing near the neck": "1", "bursts": "1", "particles passed": "1", "mean burst": "1", "mean burst low": "1", "mean burst high": "1",
         "hazard per particle": "1", "hazard low": "1", "hazard high": "1", "share of empty bursts": "1", "rate while flowing": "1/s"}
LONGER = [point.ratio for point in POINTS.values() if point.is_base() and not point.again]
HEAD = [f"{name} [{unit}]" for name, unit in UNITS.items()] + ["status", "from"]


def row(what, ratio, friction=FULL, angle=60, height=NECK, spread=0, concentration=0):
    first = [ratio, angle, height / NECK, spread, *friction, concentration if concentration else "dense"]
    return dict(zip(HEAD, first), **{"from": what})


def fill(line, values):
    for name, value in values.items():
        line[f"{name} [{UNITS[name]}]"] = value
    return line


def measured(line, fair, more):
    mean, low, high = mean_of(fair)
    sizes = [s for seed in fair.values() for s in seed]
    line = fill(line, {"bursts": len(sizes), "particles passed": sum(sizes), "mean burst": mean, "mean burst low": low, "mean burst high": high,
                       **({"hazard per particle": 1 / mean, "hazard low": 1 / high, "hazard high": 1 / low} if low >= 1 else {}),
                       "share of empty bursts": sizes.count(0) / len(sizes), **more})
    line["status"] = "measured" if mean else "stands"
    return line


def bounded(line, bursts, cut):
    """A line of bursts of which some were cut before they clogged: a lower bound."""
    if cut:
        fill(line, {"mean burst": "", "mean burst high": "", "hazard low": "", "hazard per particle": (bursts - cut) / line["particles passed [1]"]})
        line["status"] = f"lower bound: {bursts - cut} of {bursts} clogged"
    return line


def own_rows(folder):
    """Of the runs made for the law."""
    with (folder / "points.csv").open(newline="") as table:
        known = {r["point"]: r for r in csv.DictReader(table)}
    lines = []
    for name, fair in read_sizes(folder / "bursts.csv").items():
        point = POINTS[name]
        if not point.again:
            what = "law, first clogs from an empty channel" if point.empty else "law"
            more = {key: float(known[name][f"{key} [{UNITS[key]}]"]) for key in ("packing near the neck", "rate while flowing")}
            line = measured(row(what, point.ratio, point.friction, point.angle, point.height, point.spread, point.concentration), fair, more)
            lines.append(bounded(line, line["bursts [1]"], int(known[name]["cut [1]"])))
    return lines


def campaign_sizes(folder):
    """D/d -> seed -> sizes, of docs/reports/results; but for sizes that were run for longer."""
    with (folder / "points.csv").open(newline="") as table:
        points = {r["group"]: r for r in csv.DictReader(table)}
    bursts = {}
    with (folder / "bursts.csv").open(newline="") as table:
        for r in csv.DictReader(table):
            bursts.setdefault(r["group"], []).append(r)
    return {float(points[group]["D/d [1]"]): fair_sizes(rows, float(points[group]["simulated time [s]"]) / float(points[group]["runs"]))
            for group, rows in bursts.items() if not any(abs(ratio - float(points[group]["D/d [1]"])) < 1e-3 for ratio in LONGER)}


def kept_sizes(folder):
    """The same as it was when the tables were collected: the campaign may have grown since."""
    return {float(ratio): fair for ratio, fair in read_sizes(folder / "campaign.csv").items()}


def campaign_rows(folder):
    return [measured(row("campaign", ratio), fair, {}) for ratio, fair in kept_sizes(folder).items()]


def friction_rows(file):
    """Of the friction map: one burst a seed, cut at 0.25 s. Not all of them clogged: a lower bound, as the page has it.
    Rows that differ in the walls or in the turning law are left out: the table has no column for them."""
    lines = []
    with file.open(newline="") as table:
        for r in csv.DictReader(table):
            if "_" in r["cell"] and r["cell"] != "6_03":
                continue
            line = row("friction map", float(r["D/d"]), tuple(float(r[k]) for k in ("sliding", "rolling", "torsion")))
            clogs, passed, mean = int(r["clogged"]), int(r["passages"]), float(r["mean"])
            fill(line, {"bursts": int(r["seeds"]), "particles passed": passed, "packing near the neck": float(r["packing_near_neck"])})
            if not math.isnan(float(r["rate_1/s"])):
                fill(line, {"rate while flowing": float(r["rate_1/s"])})
            if clogs == 0:
                # No clog in n particles: a hazard above ln(20) / n is excluded with 95 %.
                fill(line, {"mean burst low": passed / math.log(20), "hazard low": 0, "hazard high": math.log(20) / passed})
                line["status"] = "flows: lower bound"
            else:
                whole = clogs == int(r["seeds"])
                low, high = float(r["low"]), float(r["high"])
                fill(line, {"mean burst": mean if whole else "", "mean burst low": low, "mean burst high": high if whole else "",
                            "hazard per particle": clogs / passed if passed else "", "hazard low": 1 / high if high and whole else "",
                            "hazard high": 1 / low if low else ""})
                line["status"] = ("measured" if mean else "stands") if whole else f"lower bound: {clogs} of {r['seeds']} clogged"
            lines.append(line)
    return lines


def write_law(reports):
    lines = own_rows(reports / "bridging") + campaign_rows(reports / "bridging") + friction_rows(reports / "friction/map.csv")
    lines.sort(key=lambda r: (*(r[h] for h in HEAD[1:4]), [-r[h] for h in HEAD[4:7]], str(r[HEAD[7]]), r[HEAD[0]]))
    with rewritten(reports / "bridging/law.csv") as out:
        writer = csv.DictWriter(out, HEAD, restval="")
        writer.writeheader()
        for line in lines:
            writer.writerow({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in line.items()})
    return lines


def sizes_of_base(reports):
    """D/d -> seed -> sizes at the base (friction 0.6 three times, 60 degrees, dense), campaign and law together."""
    all_sizes = kept_sizes(reports / "bridging")
    own = {POINTS[n].ratio: fair for n, fair in read_sizes(reports / "bridging/bursts.csv").items() if POINTS[n].is_base() and not POINTS[n].again}
    return dict(sorted({**all_sizes, **own}.items()))


def sizes_of_necks(reports):
    """Height over width of the neck -> D/d -> seed -> sizes: the base, and what differs from it in the height alone."""
    necks = {1: sizes_of_base(reports)}
    for name, fair in read_sizes(reports / "bridging/bursts.csv").items():
        point = POINTS[name]
        if point.height != NECK and point.is_base_but_for_height():
            necks.setdefault(point.height / NECK, {})[point.ratio] = fair
    return necks
