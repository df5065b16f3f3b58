"""Layers between floor and ceiling: where in the height of the channel the particles' centres are."""

import csv

import h5py
import numpy as np

REACH = 2  # neck widths of straight channel before the narrowing
BINS = 25  # over the height that centres can have
MIDDLE = slice(11, 14)  # three of them: the middle eighth


def profile_of(paths, geometry):
    """Density of centres over its mean, in bins from floor to ceiling: a row for the first half of the runs' snapshots, one
    for the second. \\param paths  runs of one point"""
    narrowing = (geometry["channel_width"] - geometry["neck_width"]) / 2 / np.tan(geometry["half_angle"])
    radius, height = geometry["diameter"] / 2, geometry["neck_height"]
    counts = np.zeros((2, BINS))
    for path in paths:
        with h5py.File(path) as file:
            first, position = file["snapshots/first"][:], file["snapshots/position"][:]
        half = first[len(first) // 2]
        for row, part in zip(counts, (position[:half], position[half:])):
            near = (part[:, 0] < -narrowing) & (part[:, 0] > -narrowing - REACH * geometry["neck_width"])
            z = np.clip(part[near, 2], radius, height - radius)  # soft particles press into the walls
            row += np.histogram(z, BINS, (radius, height - radius))[0]
    return counts * BINS / counts.sum(axis=1, keepdims=True)


def read_profiles(file):
    """Point -> its two rows."""
    with file.open(newline="") as table:
        rows = list(csv.reader(table))[1:]
    profiles = {}
    for name, _, *densities in rows:
        profiles.setdefault(name, []).append([float(d) for d in densities])
    return {name: np.array(pair) for name, pair in profiles.items()}


def middle_of(pair):
    """Density at half height over the mean, in the first and the second half of the runs."""
    return pair[:, MIDDLE].mean(axis=1)
