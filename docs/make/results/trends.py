"""What experiments found, beside ours: rows as those of claims.py, from the campaign and from what other pages measured."""

import csv
import sys

from campaign import FIGURES, number
from claims import ABSENT, AGREES, DIFFERS, OPEN, PARTLY, clogs_above_three, exponential_mean, longer_flow

REPORTS = FIGURES.parents[1] / "docs" / "reports"
sys.path.insert(0, str(REPORTS.parent / "make" / "experiment"))

from first_clog_law import points as thin_suspensions  # noqa: E402  (found through the line above)


def read(file):
    path = REPORTS / file
    if not path.exists():
        return []
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def base_rows(from_empty, **fixed):
    """Measured rows of the bridging law with friction 0.6 three times, at 60 degrees, of equal spheres in a square neck and densely fed unless `fixed` says else; first clogs from an
    empty channel, or bursts of a channel in full flow."""
    wanted = {"sliding friction [1]": "0.6", "rolling friction [1]": "0.6", "torsion friction [1]": "0.6", "half angle [deg]": "60", "height over width [1]": "1",
              "size spread [1]": "0", "concentration fed [1]": "dense"}
    wanted.update(fixed)
    return [r for r in read("bridging/law.csv")
            if r["status"] == "measured" and r["from"] != "friction map" and ("empty" in r["from"]) == from_empty
            and all(v is None or r[k] == v for k, v in wanted.items())]


def mean(row):
    return f"{number(float(row['mean burst [1]']))} [{number(float(row['mean burst low [1]']))}, {number(float(row['mean burst high [1]']))}]"


def along(key, order, name, falls, from_empty=False):
    """<s> along one axis of the bridging law at each size that has two rows and more; agrees if it falls (or rises) from end to end at all of them."""
    by_size = {}
    for row in base_rows(from_empty, **{key: None}):
        by_size.setdefault(row["D/d [1]"], []).append(row)
    said, holds = [], []
    for size, rows in sorted(by_size.items(), key=lambda item: float(item[0])):
        rows.sort(key=lambda r: order(r[key]))
        if len({r[key] for r in rows}) < 2:
            continue
        said.append(f"{number(float(size))}: " + ", ".join(f"{name(r[key])} {mean(r)}" for r in rows))
        first, last = rows[0], rows[-1]
        low, high = (last, first) if falls else (first, last)
        holds.append(float(low["mean burst high [1]"]) < float(high["mean burst low [1]"]))
    if not said:
        return "-", ABSENT
    return "<s> at D/d = " + "; ".join(said) + " ([bridging.md](bridging.md))", AGREES if all(holds) else PARTLY if any(holds) else DIFFERS


def angle(_):
    return along("half angle [deg]", float, lambda v: f"{v} degrees", falls=True)


def concentration(_):
    def solids(value):
        return 1.0 if value == "dense" else float(value)
    return along("concentration fed [1]", solids, str, falls=True, from_empty=True)


def pulsation(_):
    rows = [r for r in read("arches/arrests.csv") if r["drive"].startswith("oscillation")]
    if not rows:
        return "-", ABSENT
    by_amplitude = {}
    for r in rows:
        by_amplitude.setdefault(float(r["drive"].split()[1]), []).append(r)
    said = "; ".join(f"{a:g}: " + ", ".join(f"{number(float(r['passages_per_s']), 2)} ({number(float(r['drive_time [tau]']), 2)})"
                                          for r in sorted(rows, key=lambda r: -float(r["drive_time [tau]"])))
                     for a, rows in sorted(by_amplitude.items()))
    steady = "".join(f"steady: {number(float(r['passages_per_s']), 2)}; " for r in read("arches/arrests.csv") if r["drive"] == "steady")
    resumes = [float(r["arrests_ended"]) > float(r["arrests_cut"]) for r in rows]
    return (f"passages per second at D/d = 2.13, by amplitude over the mean (period in tau): {steady}{said}. Up to an amplitude of 1 the flow never goes back; the first clog stands at 0.25, and at 1, "
            "where the flow stands still for moments, six of ten runs let a few particles more pass ([arches.md](arches.md#a-flow-that-goes-back))"), AGREES if all(resumes) else PARTLY if any(resumes) else DIFFERS


def rate(_):
    return ("alpha exists under noise only; <s> at D/d = 2.13 is 1.02 [0.91, 1.14] times as large at a tenth of the rate, 1.09 [0.97, 1.23] times at a hundredth; at ten times the rate softness and inertia show, "
            "0.86 [0.77, 0.96] ([friction.md](friction.md#does-the-drag-matter-does-the-rate))"), OPEN


def bridges(_):
    sizes = {}
    for r in read("bridging/arches.csv"):
        if not r["point"].startswith(("size_", "again_")):  # the base: other angles and frictions make other arches
            continue
        sizes.setdefault(float(r["D/d [1]"]), []).append(float(r["centred before the opening [1]"]))
    if not sizes:
        return "-", ABSENT
    said, means, leasts = [], [], []
    for ratio, counts in sorted(sizes.items()):
        law, middle = ratio ** 2 + 1, sum(counts) / len(counts)
        said.append(f"{number(ratio)}: {number(middle)}, least {min(counts):.0f} (law {number(law)})")
        means.append(abs(middle / law - 1) < 0.15)
        leasts.append(min(counts) > law - 1)
    return ("particles centred before the opening of a clog, mean: " + "; ".join(said) + ". It is nearer to the mean than to the least, and depends on what is counted ([bridging.md](bridging.md))",
            AGREES if all(leasts) else PARTLY if all(means) else DIFFERS)


def poisson(_):
    """Beads until the first clog of a thin suspension: without a memory if the interval of Weibull's exponent holds 1."""
    points = [p for p in thin_suspensions() if p.mass == 1 and p.shape()]
    if not points:
        return "-", ABSENT
    said = "; ".join(f"{number(p.ratio)} at {100 * p.concentration:g} %: {p.shape()[0]:.2f} [{p.shape()[1]:.2f}, {p.shape()[2]:.2f}]" for p in points)
    holds = [p.shape()[1] <= 1 <= p.shape()[2] for p in points]
    return f"exponent of Weibull's law, 1 without memory: {said} ([experiment.md](experiment.md))", AGREES if all(holds) else PARTLY if any(holds) else DIFFERS


TRENDS = [
    ("<s> grows with D/d (Souzy & Marin 2022)", longer_flow),
    ("no clog for D/d > 3 even at a packing of 60 % (Marin et al. 2018)", clogs_above_three),
    ("a thin suspension clogs as a Poisson process (Marin et al. 2018)", poisson),
    ("the share of clogging states falls exponentially in (width)^dimension, without a sharp end (Thomas & Durian 2015)", exponential_mean),
    ("alpha does not depend on the flow rate (Souzy & Marin 2022)", rate),
    ("alpha grows with D/d (Souzy & Marin 2022)", lambda c: ("under a random drag of one strength it does, under a pulsation of the flow it does not ([arches.md](arches.md))", OPEN)),
    ("fewer clogs at a smaller angle (Vani et al. 2024)", angle),
    ("fewer particles pass at a higher concentration (Vani et al. 2024)", concentration),
    ("a pulsation of 0.25 to 1.25 of the mean raises the throughput at every amplitude (Dincau et al.)", pulsation),
    ("the smallest bridge has (D/d)^2 + 1 particles (Marin & Souzy 2025)", bridges),
]


def rows(campaign):
    return [(claim, *judge(campaign)) for claim, judge in TRENDS]
