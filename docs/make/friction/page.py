"""Table and figure of the friction map, from the run files."""

import csv
import json

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from cells import CELLS, words  # noqa: E402
from whole_file import rewritten  # noqa: E402

NECK = 100  # um


def read_run(path):
    """\\return passages, whether a clog ended them, their rate while they lasted [1/s], packing of the last strip, contacts
    of a particle with others, both over the flow"""
    with h5py.File(path) as file:
        record = json.loads(file["provenance/record"][()])
        times, end = file["passages/time"][:], file["end_time"][0]
        series = file["series"]
        clogged = "clogged_at_s" in record
        flows = series["time"][:] <= (times[-1] if clogged and len(times) else end)
        packing = 1 - series["porosity"][:][flows, -1].mean()
        coordination = (2 * series["contacts"][:] / np.maximum(1, series["count"][:]))[flows].mean()
        last = times[-1] if clogged and len(times) else end
    return len(times), clogged, len(times) / last if last > 0 and len(times) else np.nan, packing, coordination, \
        record.get("start_flowed", True)


def restricted_mean(number, clogged):
    """Area under the Kaplan-Meier survival of the passages, up to the largest seen."""
    order = np.lexsort((~clogged, number))
    survival, area, last = 1.0, 0.0, 0
    for rank, k in enumerate(order):
        area += survival * (number[k] - last)
        last = number[k]
        if clogged[k]:
            survival *= 1 - 1 / (len(order) - rank)
    return area


def row_of(name, diameter, folder):
    runs = [read_run(path) for path in sorted(folder.glob("run_*.h5"))]
    if not runs:
        return None
    number = np.array([r[0] for r in runs])
    clogged = np.array([r[1] for r in runs])
    random = np.random.default_rng(1)
    drawn = random.integers(0, len(runs), (2000, len(runs)))
    low, high = np.quantile([restricted_mean(number[k], clogged[k]) for k in drawn], [0.025, 0.975])
    (sliding, rolling, torsion), _ = CELLS[name]
    # No clog in n passages: the hazard is below ln(20) / n with 95 %.
    bound = np.log(20) / number.sum() if not clogged.any() and number.sum() else np.nan
    return {"cell": name, "D/d": round(NECK / diameter, 3), "sliding": sliding, "rolling": rolling, "torsion": torsion,
            "seeds": len(runs), "clogged": int(clogged.sum()), "passages": int(number.sum()),
            "mean": restricted_mean(number, clogged), "low": low, "high": high, "hazard_below": bound,
            "rate_1/s": np.nanmean([r[2] for r in runs]) if number.any() else np.nan,
            "packing_near_neck": np.mean([r[3] for r in runs]), "coordination": np.mean([r[4] for r in runs]),
            "flowed_without_friction": sum(r[5] for r in runs)}


def collect(folder):
    rows = []
    for name in CELLS:
        for part in ("small", "large"):
            for point in (folder / f"{name}_{part}").glob("particles.diameter=*um"):
                diameter = float(point.name.split("=")[1].removesuffix("um"))
                rows.append(row_of(name, diameter, point))
    return sorted(filter(None, rows), key=lambda r: (list(CELLS).index(r["cell"]), r["D/d"]))


def text_of(row):
    if row["clogged"] == 0:
        return f"flows (> {row['passages']})"
    if row["clogged"] < row["seeds"]:
        return f"> {row['mean']:.3g} [{row['low']:.3g}, {row['high']:.3g}], {row['clogged']} of {row['seeds']} clogged"
    return f"{row['mean']:.3g} [{row['low']:.3g}, {row['high']:.3g}]"


def print_table(rows):
    ratios = sorted({row["D/d"] for row in rows})
    print("| sliding, rolling, torsion | " + " | ".join(f"D/d = {ratio:.3g}" for ratio in ratios) + " |")
    print("| --- |" + " --- |" * len(ratios))
    for name in CELLS:
        cells = {row["D/d"]: text_of(row) for row in rows if row["cell"] == name}
        if cells:
            print(f"| {words(name)} | " + " | ".join(cells.get(ratio, "") for ratio in ratios) + " |")


def draw(rows, file):
    names = [name for name in CELLS if any(row["cell"] == name for row in rows)]
    figure, axes = plt.subplots(figsize=(8, 0.42 * len(names) + 1.4), constrained_layout=True)
    colours = plt.get_cmap("viridis")
    for row in rows:
        y, flows = len(names) - names.index(row["cell"]), row["clogged"] == 0
        share = min(1.0, np.log10(1 + row["mean"]) / 3.5)
        marker = "o" if not flows else ">"
        face = colours(share) if row["clogged"] in (0, row["seeds"]) else "white"
        axes.plot(row["D/d"], y, marker, ms=13, mfc=face, mec=colours(share), mew=2)
        label = "flows" if flows else f"{row['mean']:.2g}" if row["mean"] < 10 else f"{row['mean']:.0f}"
        axes.annotate(label, (row["D/d"], y), xytext=(0, 9), textcoords="offset points", ha="center", fontsize=7)
    axes.set_yticks([len(names) - k for k in range(len(names))], [words(name) for name in names], fontsize=8)
    axes.set(xlabel="D/d", xlim=(1.1, 4.5), ylim=(0.4, len(names) + 0.8))
    figure.suptitle("passages until the first clog; triangle: no seed clogged; open: not all did", fontsize=10)
    with rewritten(file, binary=True) as out:
        figure.savefig(out, dpi=130, format="png")


def write_page(folder, out):
    rows = collect(folder)
    out.mkdir(parents=True, exist_ok=True)
    with rewritten(out / "map.csv") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{v:.5g}" if isinstance(v, float) else v for key, v in row.items()})
    draw(rows, out / "map.png")
    print_table(rows)
