"""Makes all figures and the HTML page. Usage: make_report.py STATISTICS_FOLDER OUT_FOLDER [--figure-width METRES] [--font-size POINTS]
[--flow FLOW.h5] [--command TEXT]"""

import argparse
from pathlib import Path

import fig_bursts
import fig_first_burst
import fig_lapses
import fig_necks
import fig_series
import fig_snapshots
import fig_spatiotemporal
import html_page
import matplotlib
import style
from stats_files import Statistics


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("statistics")
    parser.add_argument("out")
    parser.add_argument("--figure-width", type=float, default=0)  # [m]
    parser.add_argument("--font-size", type=float, default=0)     # [pt]
    parser.add_argument("--flow", default="")
    parser.add_argument("--command", default="")
    words = parser.parse_args()
    matplotlib.use("Agg")  # a screen may be there, and windows are not wanted
    style.choose(words.figure_width, words.font_size)
    statistics = Statistics(words.statistics)
    folder = Path(words.out)
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for module in (fig_snapshots, fig_spatiotemporal, fig_necks, fig_first_burst, fig_bursts, fig_lapses, fig_series):
        for name, figure in module.figures(statistics):
            paths += style.save(figure, folder, name)
    paths.append(html_page.write(statistics, paths, folder, words.flow, words.command))
    for path in paths:
        print(f"wrote {path}")


if __name__ == "__main__":
    main()
