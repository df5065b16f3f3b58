"""Cost against error: every setting of a study, the front marked. Called with trade.json and a folder."""

import json
import sys

import matplotlib
import matplotlib.pyplot as plt

import style


def draw(results):
    measured = [s for s in results["settings"] if "error" in s]
    figure, axes = plt.subplots(figsize=(style.PAGE, 3.6))
    if not measured:
        style.say(axes, "too few bursts to judge any setting")
    for setting in measured:
        numerics = setting["kind"] == "numerics"
        colour = style.BLUE if numerics else style.GREY
        axes.plot([setting["cost"]] * 2, [100 * setting["error"], 100 * setting["hidden"]], color=colour, lw=0.6)
        axes.plot(setting["cost"], 100 * setting["error"], "o" if numerics else "x", color=colour, ms=5,
                  mfc=colour if setting.get("front") else "white")
        axes.annotate(setting["name"], (setting["cost"], 100 * setting["error"]), xytext=(3, 4),
                      textcoords="offset points", fontsize=style.points(5.5), rotation=35)
    if measured:
        axes.set_xscale("log")
        axes.set_yscale("symlog", linthresh=5)
        axes.set_ylim(bottom=-1)
    axes.set_xlabel("particle-steps per simulated second")
    axes.set_ylabel("largest difference [%]")
    axes.set_title("marker: seen beyond its interval; line: what could hide; filled: front")
    return figure


if __name__ == "__main__":
    matplotlib.use("Agg")
    with open(sys.argv[1], encoding="utf-8") as stream:
        figure = draw(json.load(stream))
    for path in style.save(figure, sys.argv[2], "trade"):
        print(f"wrote {path}")
