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
from stats_files import Statistics


def main():
    if len(sys.argv) != 3:
        raise SystemExit("usage: make_report.py STATISTICS_FOLDER OUT_FOLDER")
    statistics = Statistics(sys.argv[1])
    folder = Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    first_bursts = [fig_first_burst] if fig_first_burst.exists(statistics) else []
    necks = [fig_necks] if fig_necks.exists(statistics) else []
    for figure in (fig_snapshots, fig_spatiotemporal, *necks, *first_bursts, fig_bursts, fig_lapses, fig_series):
        paths += figure.make(statistics, folder)
    paths.append(html_page.write(statistics, paths, folder))
    for path in paths:
        print(f"wrote {path}")


if __name__ == "__main__":
    main()
