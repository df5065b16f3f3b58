"""The stability map as a picture and as counts: plot_stability.py stability.csv picture.png."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)

COLOURS = {"accurate": "#1f5fa8", "inaccurate": "#6fa8dc", "refused": "#8a949e", "unstable": "#c8432b"}


def main(table, picture):
    with open(table, newline="") as lines:
        rows = list(csv.DictReader(lines))
    for verdict in COLOURS:
        print(verdict, sum(row["verdict"] == verdict for row in rows))
    measured = [row for row in rows if row["at_rest"] == "1"]
    ratio = {row["number"]: float(row["measured"]) / float(row["predicted"]) for row in measured}
    values = sorted(ratio.values())
    print(len(values), "measured; ratio least", values[0], "median", values[len(values) // 2],
          "within 3:", sum(v <= 3 for v in values), "none shook at 8:", sum(row["capped"] == "1" for row in measured))
    for name, low, high in (("restitution < 0.1", 0, 0.1), ("0.1 to 0.3", 0.1, 0.3), ("above 0.3", 0.3, 2)):
        part = sorted(ratio[row["number"]] for row in measured if low <= float(row["restitution"]) < high)
        print(name, len(part), "least", part[0], "median", part[len(part) // 2], "within 3:", sum(v <= 3 for v in part))
    for row in sorted(measured, key=lambda row: ratio[row["number"]])[:5]:
        print("worst", {k: row[k] for k in list(row)[:12]}, ratio[row["number"]])

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), constrained_layout=True)
    points = left.scatter([float(row["predicted"]) for row in measured], [ratio[row["number"]] for row in measured], s=14,
                          c=[float(row["restitution"]) for row in measured], cmap="viridis", vmin=0, vmax=1)
    left.axhline(1, color="#c8432b", lw=1)
    left.axhline(3, color="#8a949e", lw=1, ls="--")
    left.set(xscale="log", yscale="log", xlabel="predicted limit [s]", ylabel="measured / predicted")
    figure.colorbar(points, ax=left, label="restitution")
    for verdict, colour in COLOURS.items():
        some = [row for row in rows if row["verdict"] == verdict]
        right.scatter([float(row["diameter"]) for row in some], [float(row["youngs_modulus"]) for row in some], s=14,
                      color=colour, label=f"{verdict} ({len(some)})")
    right.set(xscale="log", yscale="log", xlabel="diameter [m]", ylabel="Young's modulus [Pa]")
    right.legend(frameon=True, fontsize=7)
    figure.savefig(picture, dpi=130)


if __name__ == "__main__":
    main(*sys.argv[1:])
