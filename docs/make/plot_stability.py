"""The stability map as a picture and as counts: plot_stability.py stability.csv picture.png."""

import csv
import statistics
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
from whole_file import rewritten  # noqa: E402

COLOURS = {"accurate": "#1f5fa8", "inaccurate": "#6fa8dc", "refused": "#8a949e", "unstable": "#c8432b"}
# The measurement resolves 1 % of the prediction and 1 % of the bisection.
SAFE, TIGHT = 0.98, 1.5


def ratio(row):
    return float(row["measured"]) / float(row["predicted"])


def counts(name, rows):
    """One line of the report's tables."""
    values = sorted(ratio(row) for row in rows if row["at_rest"] == "1")
    verdicts = " / ".join(str(sum(row["verdict"] == verdict for row in rows)) for verdict in COLOURS)
    if not values:
        print(f"| {name} | {len(rows)} | 0 | | | | | | {verdicts} |")
        return
    safe, tight = sum(v >= SAFE for v in values), sum(v <= TIGHT for v in values)
    print(f"| {name} | {len(rows)} | {len(values)} | {safe} | {values[0]:.3f} | {statistics.median(values):.2f} "
          f"| {values[-1]:.2f} | {tight} | {verdicts} |")


def print_counts(rows, terms):
    print("| term | points | at rest | safe | least | median | largest | within 1.5 | " + " / ".join(COLOURS) + " |")
    for term in terms:
        counts(term, [row for row in rows if row["term"] == term])
    equal = [row for row in rows if row["term"] == "equal"]
    for name, part in (("with friction", lambda row: float(row["friction"]) > 0),
                       ("without", lambda row: float(row["friction"]) == 0),
                       ("explicit", lambda row: row["integrator"] == "verlet"),
                       ("implicit drag", lambda row: row["integrator"] == "implicit_drag"),
                       ("implicit films", lambda row: row["integrator"] == "implicit_fluid"),
                       ("restitution above 0.3", lambda row: float(row["restitution"]) > 0.3),
                       ("restitution below 0.1", lambda row: float(row["restitution"]) < 0.1)):
        counts("equal, " + name, [row for row in equal if part(row)])
    measured = sorted((row for row in rows if row["at_rest"] == "1"), key=ratio)
    for row in measured[:3] + measured[-8:]:
        print("extreme", row["number"], row["term"], f"{ratio(row):.3f}", "films" if row["films"] == "1" else "no films",
              row["integrator"], "friction", row["friction"], "restitution", row["restitution"])
    shares = [(float(row["expected"]) / float(row["measured"]), row) for row in measured]
    print("expected from the scene above the measured limit:",
          [(row["number"], round(share, 2)) for share, row in shares if share > 1],
          "median", statistics.median(share for share, _ in shares))
    for reason in sorted({row["reason"].split(",")[0].split(" of ")[0][:60] for row in rows}):
        print(sum(row["reason"].startswith(reason) for row in rows) if reason else "", reason)


def main(table, picture):
    with open(table, newline="") as lines:
        rows = list(csv.DictReader(lines))
    terms = list(dict.fromkeys(row["term"] for row in rows))
    print_counts(rows, terms)

    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    measured = [row for row in rows if row["at_rest"] == "1"]
    points = left.scatter([float(row["predicted"]) for row in measured], [ratio(row) for row in measured], s=10,
                          c=[float(row["restitution"]) for row in measured], cmap="viridis", vmin=0, vmax=1)
    left.set(xscale="log", xlabel="predicted limit [s]", ylabel="measured / predicted")
    figure.colorbar(points, ax=left, label="restitution")
    for place, term in enumerate(terms):
        values = [ratio(row) for row in measured if row["term"] == term]
        # Side by side, so that equal ratios do not hide each other.
        middle.scatter([place + 0.6 * (k / max(len(values), 2) - 0.5) for k in range(len(values))], values, s=8,
                       color="#1f5fa8")
    middle.set_xticks(range(len(terms)), terms, rotation=60, ha="right", fontsize=8)
    middle.set(ylabel="measured / predicted")
    for axes in (left, middle):
        axes.axhline(1, color="#c8432b", lw=1)
        axes.axhline(TIGHT, color="#8a949e", lw=1, ls="--")
    for verdict, colour in COLOURS.items():
        some = [row for row in rows if row["verdict"] == verdict]
        right.scatter([float(row["diameter"]) for row in some], [float(row["youngs_modulus"]) for row in some], s=10,
                      color=colour, label=f"{verdict} ({len(some)})")
    right.set(xscale="log", yscale="log", xlabel="diameter [m]", ylabel="Young's modulus [Pa]")
    right.legend(frameon=True, fontsize=7)
    with rewritten(Path(picture), binary=True) as out:
        figure.savefig(out, dpi=130, format="png")


if __name__ == "__main__":
    main(*sys.argv[1:])
