"""Makes all figures and the HTML page. Usage: make_report.py STATISTICS_FOLDER OUT_FOLDER"""

import sys
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
    if len(sys.argv) != 3:
        raise SystemExit("usage: make_report.py STATISTICS_FOLDER OUT_FOLDER")
    matplotlib.use("Agg")  # a screen may be there, and windows are not wanted
    statistics = Statistics(sys.argv[1])
    folder = Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for module in (fig_snapshots, fig_spatiotemporal, fig_necks, fig_first_burst, fig_bursts, fig_lapses, fig_series):
        for name, figure in module.figures(statistics):
            paths += style.save(figure, folder, name)
    paths.append(html_page.write(statistics, paths, folder))
    for path in paths:
        print(f"wrote {path}")


if __name__ == "__main__":
    main()
