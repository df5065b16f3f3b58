"""From run files to the small tables that are committed."""

import csv
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from arches import counts_of
from bursts import fair_sizes, write_sizes
from points import NECK, POINTS
from stats_files import Statistics


def statistics_of(program, folder):
    with tempfile.TemporaryDirectory() as work:
        subprocess.run([program, "stats", folder, "--out", work, "--p-value", "0", "--quiet"], check=True, capture_output=True)
        statistics = Statistics(work)
        return statistics.groups[0], statistics.rows("bursts", 0)


def put(file, head, lines):
    with file.open("w", newline="") as out:
        writer = csv.writer(out)
        writer.writerow(head)
        writer.writerows(lines)


def collect(program, folder, reports):
    sizes, more, arches = {}, [], []
    for name in POINTS:
        if not (folder / name).exists():
            print(f"{name}: not run")
            continue
        group, bursts = statistics_of(program, folder / name)
        sizes[name] = fair_sizes(bursts, group["runs"][0]["end"])
        rate, packing = group["quantities"]["flow_rate_flowing"]["value"], group["first_burst"]["packing_near_neck"]["flowing"]["value"]
        more.append([name, f"{packing or np.nan:.4g}", f"{rate or np.nan:.4g}"])
        for path in sorted(Path(folder / name).glob("run_*.h5")):
            for counts in counts_of(path, group["geometry"]):
                arches.append([name, f"{NECK / 1e6 / group['geometry']['diameter']:.4g}", *counts])
    write_sizes(reports / "bursts.csv", sizes)
    put(reports / "points.csv", ["point", "packing near the neck [1]", "rate while flowing [1/s]"], more)
    put(reports / "arches.csv", ["point", "D/d [1]", "seen from the outlet [1]", "centred before the opening [1]", "foremost layer [1]", "shortest chain [1]"], arches)
