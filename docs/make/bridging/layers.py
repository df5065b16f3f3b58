"""Layers between floor and ceiling: where in the height of the channel the particles' centres are."""

import csv

import h5py
import numpy as np

REACH = 2  # neck widths of straight channel before the narrowing
BINS = 25  # over the height that centres can have
MIDDLE = slice(11, 14)  # three of them: the middle eighth


def near_the_narrowing(x, geometry):
    begins = -(geometry["channel_width"] - geometry["neck_width"]) / 2 / np.tan(geometry["half_angle"])
    return (x < begins) & (x > begins - REACH * geometry["neck_width"])


def counts_of_heights(z, geometry):
    """Centres at heights z [m] in bins from floor to ceiling. Soft particles press into the walls: these count at the walls."""
    least, most = geometry["diameter"] / 2, geometry["neck_height"] - geometry["diameter"] / 2
    return np.histogram(np.clip(z, least, most), BINS, (least, most))[0]


def profile_of(paths, geometry):
    """Density of centres over its mean: a row for the first half of the snapshots of each run, one for the second.
    \\param paths  runs of one point"""
    counts = np.zeros((2, BINS))
    for path in paths:
        with h5py.File(path) as file:
            first, position = file["snapshots/first"][:], file["snapshots/position"][:]
        half = first[len(first) // 2]
        for row, part in zip(counts, (position[:half], position[half:])):
            row += counts_of_heights(part[near_the_narrowing(part[:, 0], geometry), 2], geometry)
    return counts * BINS / counts.sum(axis=1, keepdims=True)


def read_profiles(file):
    """Point -> its two rows."""
    with file.open(newline="") as table:
        rows = list(csv.reader(table))[1:]
    profiles = {}
    for name, _, *densities in rows:
        profiles.setdefault(name, []).append([float(d) for d in densities])
    return {name: np.array(pair) for name, pair in profiles.items()}


def at_half_height(densities):
    return np.asarray(densities)[..., MIDDLE].mean(axis=-1)


def say_layers(profiles):
    print("\n| height over d | height over width | density at half height, first half of the runs | second |\n| --- | --- | --- | --- |")
    for tall, (height, pair) in sorted(profiles.items()):
        first, second = at_half_height(pair)
        print(f"| {tall:.3g} | {height:g} | {first:.2f} | {second:.2f} |")
