"""The figures of the page: captions, and what a reader who does not see them is told."""

import base64
import struct

from page_cells import number

CAPTIONS = {
    "snapshots": "A burst: the arch before it, the burst, and the arch that ends it. Circles are particles seen along z, "
                 "those in front on top, coloured by speed; ringed: the arch, particles that bear load (two contacts or more) and close the neck as seen from the outlet.",
    "spatiotemporal": "Passages through the neck, one row a seed. Each passage is a black bar of width τ = d/v; grey: nothing passes.",
    "spatiotemporal_sweep": "The first seed of every point, as in the paper's figure 3: passages through the neck over the median length of these runs.",
    "necks": "Necks side by side. Left: passages of each with friction on, first seed; grey: a clog of all is cleared without friction, where nothing counts. Right: passages per clog "
             "with 95 % interval over seeds; circles: per clog of all necks at once; squares: per lapse of T_min and more of the neck itself.",
    "bursts": "Burst sizes over their mean, with 95 % intervals of the counts. Dashed: geometric law of a memoryless clogging. In a sweep, "
              "right: the mean, first bursts and those cut off by the end included, with its 95 % interval; a triangle stands on the lower bound "
              "of a point without a clog; dashed: fitted law.",
    "first_burst": "Passages until the first clog of a seed. Above: share of the seeds that more than n particles pass (Kaplan-Meier "
                   "with 95 % interval; seeds that the end of the run cut are censored); dashed: geometric law, from "
                   "where on it is not ruled out. Below: chance that the neck clogs before the next passage, ten clogs or more a bin, exact 95 % interval; a "
                   "triangle hangs on an upper bound.",
    "lapses": "a: lapses between passages, with 95 % intervals of the counts, and the power laws fitted to them (Clauset, Shalizi & Newman); dotted: clog threshold; "
              "lapses below 0.001 τ are not shown. "
              "b: arrests that survive a time (Kaplan-Meier with 95 % interval; arrests cut by a release or by the end of the run are censored). "
              "In a sweep, c: exponent of the arrests with its 95 % interval; open: releases cut the arrests, not fitted; a triangle hangs "
              "on an upper bound; dotted: α = 2, where it is near; dashed: fitted law.",
    "series": "Number of particles in the domain, packing fraction of the channel and porosity of the strips; the factor q on the flow, and the pressure that drives it, where it is not steady.",
}
OF_A_POINT = ("snapshots", "series", "necks")  # one a group in a sweep


def kind_of(stem):
    return stem if stem in CAPTIONS else stem.rsplit("_", 1)[0]


def group_of(stem, statistics):
    number_ = stem.rsplit("_", 1)[-1]
    return statistics.groups[int(number_)] if number_.isdigit() and int(number_) < len(statistics.groups) else statistics.groups[0]


def told(entry):
    if entry["value"] is None:
        return "unknown"
    return number(entry["value"]) + (f" (95 % interval {number(entry['low'])} to {number(entry['high'])})" if entry["low"] is not None else "")


def alternative(stem, statistics):
    """The figure in words: what is drawn, and the numbers that it shows."""
    kind, groups = kind_of(stem), statistics.groups
    group = group_of(stem, statistics)
    whose = group["label"] if kind in OF_A_POINT or len(groups) == 1 else f"{len(groups)} scenes, {groups[0]['label']} to {groups[-1]['label']}"
    runs = sum(len(g["runs"]) for g in groups)
    if kind == "snapshots":
        return f"Snapshots of the particles at the neck, {whose}: arch, burst and new arch one below the other where they were recorded."
    if kind in ("spatiotemporal", "spatiotemporal_sweep"):
        return f"Times at which anything passes the neck as black bars in rows, {whose}, {runs} runs; " + "; ".join(
            f"{g['label']}: {told(g['quantities']['flow_rate'])} passages per second" for g in groups) + "."
    if kind == "bursts":
        return f"Distribution of the burst sizes over their mean on a logarithmic axis, {whose}; " + "; ".join(
            f"{g['label']}: mean {told(g['quantities']['mean_burst'])}, {g['bursts']['counted']} bursts" for g in groups) + "."
    if kind == "first_burst":
        return f"Share of the seeds that pass more than n particles, and hazard per passage, {whose}; " + "; ".join(
            f"{g['label']}: mean {told(g['first_burst']['mean'])}, {g['first_burst']['clogged']} of {g['first_burst']['seeds']} seeds clogged" for g in groups) + "."
    if kind == "lapses":
        return f"Distribution of the lapses between passages and survival of the arrests, both axes logarithmic, {whose}; " + "; ".join(
            f"{g['label']}: exponent {told(g['quantities']['alpha_fixed'])}" for g in groups) + "."
    if kind == "series":
        return (f"Time series of {whose}: number of particles, {told(group['steady']['particles'])} when steady, packing fraction, "
                f"{told(group['steady']['packing_fraction'])} when steady, and porosity of the strips.")
    return f"{CAPTIONS.get(kind, stem)} {whose}."


SHOWN = 0.56  # of the pixels of a picture: text in figures is as large as that of captions


def shown_width(png):
    """[px] from the head of a PNG."""
    return round(SHOWN * struct.unpack(">I", png[16:20])[0]) if png[:4] == b"\x89PNG" else 0


def entry(path, statistics):
    png = path.read_bytes()
    return {"name": path.stem, "alt": alternative(path.stem, statistics), "caption": CAPTIONS.get(kind_of(path.stem), ""),
            "label": group_of(path.stem, statistics)["label"] if kind_of(path.stem) in OF_A_POINT and len(statistics.groups) > 1 else "",
            "width": shown_width(png), "data": base64.b64encode(png).decode()}


def entries(paths, statistics):
    """(figures of all, figures of single points of a sweep)"""
    several = len(statistics.groups) > 1
    of_all, of_points = [], []
    for path in paths:
        (of_points if several and kind_of(path.stem) in OF_A_POINT else of_all).append(entry(path, statistics))
    return of_all, of_points
