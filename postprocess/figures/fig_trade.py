"""Cost against error: every setting of a study, the front marked. Called with trade.json and a folder."""

import json
import sys

import matplotlib
import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator

import style


def draw(results):
    judged = [s for s in results["settings"] if "within" in s]
    figure, axes = plt.subplots(figsize=(style.PAGE, 3.6))
    if not judged:
        style.say(axes, "too few settings or clogs to judge any")
        return figure
    for setting in judged:
        cost, within = setting["seconds_per_clog"], 100 * setting["within"]
        seen = 100 * max(abs(d["difference"]) for d in setting["from_paper"].values())
        axes.plot([cost] * 2, [seen, within], color=style.BLUE, lw=0.6)
        axes.plot(cost, within, "o", color=style.BLUE, ms=5, mfc=style.BLUE if setting["front"] else "white")
        if setting["front"]:  # who would take another?
            axes.annotate(setting["name"], (cost, within), xytext=(4, 4), textcoords="offset points", fontsize=style.points(5.5), rotation=25)
    for tolerance in (5, 10):
        axes.axhline(tolerance, color=style.GREY, lw=0.6, ls=":")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.margins(x=0.18, y=0.2)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter("{x:g}")
        axis.set_minor_locator(LogLocator(subs=(2, 5)))
        axis.set_minor_formatter("{x:g}")
    axes.set_xlabel("processor seconds a clog")
    axes.set_ylabel("difference from the paper's particles [%]")
    axes.set_title("marker: proved (95 %); line: to the estimate; filled, named: nothing cheaper is as near")
    return figure


if __name__ == "__main__":
    matplotlib.use("Agg")
    with open(sys.argv[1], encoding="utf-8") as stream:
        figure = draw(json.load(stream))
    for path in style.save(figure, sys.argv[2], "trade"):
        print(f"wrote {path}")
