"""From run files to the small tables that are committed."""

import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np
from arches import counts_of
from bursts import fair_sizes, write_sizes
from law import campaign_sizes
from layers import BINS, profile_of
from points import NECK, POINTS
from stats_files import Statistics
from whole_file import rewritten


def statistics_of(program, folder):
    with tempfile.TemporaryDirectory() as work:
        subprocess.run([program, "stats", folder, "--out", work, "--p-value", "0", "--quiet"], check=True, capture_output=True)
        statistics = Statistics(work)
        return statistics.groups[0], statistics.rows("bursts", 0)


def first_clogs(folder):
    """Of runs from an empty channel, which `clog stats` leaves out until the channel is full: passages until the clog by
    seed, packing of the last strip and rate from the first passage to the last, and how many seeds were cut before they clogged."""
    sizes, packings, rates, cut = {}, [], [], 0
    for path in sorted(folder.glob("run_*.h5")):
        with h5py.File(path) as file:
            passages, series = file["passages/time"][:], file["series"]
            cut += "clogged_at_s" not in json.loads(file["provenance/record"][()])
            sizes[int(path.stem.split("_")[1])] = [len(passages)]
            if len(passages) > 1:
                flows = (series["time"][:] >= passages[0]) & (series["time"][:] <= passages[-1])
                packings += list(1 - series["porosity"][:][flows, -1])
                rates.append((len(passages) - 1) / (passages[-1] - passages[0]))
    return sizes, np.mean(packings), np.mean(rates), cut


def put(file, head, lines):
    with rewritten(file) as out:
        writer = csv.writer(out)
        writer.writerow(head)
        writer.writerows(lines)


def collect(program, folder, reports):
    missing = [name for name in POINTS if not any((folder / name).glob("run_*.h5"))]
    if missing:  # the tables would lose what they have of these points
        sys.exit(f"{folder / missing[0]}: no run_*.h5 (nor of {len(missing) - 1} more points); bridging_law run makes them, and the tables stay as they are")
    sizes, more, arches, layers = {}, [], [], []
    for name in POINTS:
        if POINTS[name].empty:
            sizes[name], packing, rate, cut = first_clogs(folder / name)
            more.append([name, f"{packing:.4g}", f"{rate:.4g}", cut])
            continue
        group, bursts = statistics_of(program, folder / name)
        sizes[name] = fair_sizes(bursts, group["runs"][0]["end"])
        rate, packing = group["quantities"]["flow_rate_flowing"]["value"], group["first_burst"]["packing_near_neck"]["flowing"]["value"]
        more.append([name, f"{packing or np.nan:.4g}", f"{rate or np.nan:.4g}", 0])
        paths = sorted((folder / name).glob("run_*.h5"))
        for half, densities in zip(("first", "second"), profile_of(paths, group["geometry"])):
            layers.append([name, half, *(f"{density:.4g}" for density in densities)])
        for path in paths:
            for counts in counts_of(path, group["geometry"]):
                arches.append([name, f"{NECK / 1e6 / group['geometry']['diameter']:.4g}", *counts])
    write_sizes(reports / "bursts.csv", sizes)
    write_sizes(reports / "campaign.csv", campaign_sizes(reports.parent / "results"))
    put(reports / "points.csv", ["point", "packing near the neck [1]", "rate while flowing [1/s]", "cut [1]"], more)
    put(reports / "arches.csv", ["point", "D/d [1]", "seen from the outlet [1]", "centred before the opening [1]", "foremost layer [1]", "shortest chain [1]"], arches)
    put(reports / "layers.csv", ["point", "half of the runs", *(f"density over its mean, bin {k} of {BINS} [1]" for k in range(1, BINS + 1))], layers)
