"""A burst in three pictures: the arch before it, the burst, the arch after it (paper, figure 2)."""

from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PatchCollection
from matplotlib.colors import Normalize
from matplotlib.patches import Circle

import arch
import channel
import run_file
import style
from lengths import unit_of_scene
from stats_files import suffix

MM = 1e3
SPEED_COLOURS = "viridis"   # dark at rest, light fast
PANEL = 4.3                 # width of a panel [inch]
STANDING = ("start", "arch", "new arch")  # moments of a clog


@dataclass
class Burst:
    """One whose three moments were recorded."""
    file: str
    moments: list       # in the clog before, at the height, in the clog after [s]
    titles: tuple       # of the three
    inside: np.ndarray  # its passages [s]
    quiet: tuple        # (start, end) of the clog before and of the one after [s]
    tau: float          # [s]


def candidates(statistics, index):
    """Every burst whose three moments were recorded."""
    group = statistics.groups[index]
    tau = group["geometry"]["diameter"] / (group["geometry"]["mean_velocity"] or np.inf)
    files = {entry["seed"]: entry for entry in group["runs"]}
    bursts = {}
    for row in statistics.rows("bursts", index):
        bursts.setdefault(row["seed"], []).append(row)
    found = []
    for seed, rows in bursts.items():
        times = np.array(run_file.snapshot_times(files[seed]["file"]))
        events = run_file.read_events(files[seed]["file"])
        for row in rows:
            if row["kind"] == "cut off" or row["s [1]"] < 2 or len(times) == 0:
                continue
            inside = events.passage_times[events.passage_times >= row["start [s]"] - 1e-12][: int(row["s [1]"])]
            if len(inside) < 2:
                continue
            quiet = quiet_span(events, inside, files[seed]["end"])
            moments = pick(times, inside, quiet, tau)
            if moments:
                titles = ("start" if row["kind"] == "first" else "arch", "burst", "new arch")
                found.append(Burst(files[seed]["file"], moments, titles, inside, quiet, tau))
    return found


def worth(burst):
    """What is best shown: an arch before it, and then where it is densest."""
    return burst.titles[0] == "arch", passing(burst.inside, burst.moments[1], burst.tau)


def quiet_span(events, inside, end):
    """(start, end) of the clog before a burst and of the one after it; a release ends the clog."""
    passages, releases = events.passage_times, events.release_times
    earlier, later = passages[passages < inside[0]], passages[passages > inside[-1]]
    before = [earlier[-1] if len(earlier) else 0.0, inside[0]]
    after = [inside[-1], later[0] if len(later) else end]
    for span in (before, after):
        within = releases[(releases > span[0]) & (releases < span[1])]
        if len(within):
            span[1] = within[0]
    return before, after


def passing(passages, moment, tau):
    """How many particles pass within half a tau of a moment: a burst is best seen where it is densest."""
    return int(np.sum(np.abs(passages - moment) <= tau / 2))


def pick(times, inside, quiet, tau):
    """Recorded moments in the middle of the clog before, at the height of the burst, and in the middle of
    the clog after, or None."""
    within = times[(times >= inside[0]) & (times <= inside[-1])]
    if len(within) == 0:
        return None
    burst = max(within, key=lambda moment: passing(inside, moment, tau))
    moments = [burst]
    for (start, end), place in ((quiet[0], 0), (quiet[1], 2)):
        still = times[(times >= start) & (times <= end)]
        if len(still) == 0:
            return None
        moments.insert(place, still[np.argmin(np.abs(still - 0.5 * (start + end)))])
    return moments


def choose(statistics, index):
    """The densest burst that was recorded; failing that three moments of the first run with snapshots."""
    found = candidates(statistics, index)
    if found:
        burst = max(found, key=worth)
        return burst.file, burst.moments, burst.titles
    for entry in statistics.groups[index]["runs"]:
        times = run_file.snapshot_times(entry["file"])
        if len(times):
            picked = [times[0], times[len(times) // 2], times[-1]][: len(times)]
            return entry["file"], picked, [""] * len(picked)
    return None, [], []


def fastest(snapshots):
    """End of the colours [m/s]: few particles are faster."""
    return max([float(np.quantile(s.speed, 0.99)) for s in snapshots if len(s.speed)] + [1e-12])


def draw_particles(axes, snapshot, norm, group):
    """Spheres as circles, those in front (large z) on top, coloured by speed."""
    order = np.argsort(snapshot.position[:, 2])
    scale = unit_of_scene(group["geometry"]).per_metre
    xy, radius = snapshot.position[order, :2] * scale, snapshot.radius[order] * scale
    circles = PatchCollection([Circle(p, r) for p, r in zip(xy, radius)], cmap=SPEED_COLOURS, norm=norm,
                              edgecolor="#dfe5ea", linewidth=0.35, zorder=2)
    circles.set_array(snapshot.speed[order] * MM)
    axes.add_collection(circles)
    return circles


def mark_arch(axes, snapshot, group):
    """Rings around the particles that bear the load. Returns whether there is an arch."""
    rows = arch.arch_of(snapshot, group["geometry"]) if group["geometry"]["present"] else []
    scale = unit_of_scene(group["geometry"]).per_metre
    rings = [Circle(snapshot.position[k, :2] * scale, 0.93 * snapshot.radius[k] * scale) for k in rows]
    axes.add_collection(PatchCollection(rings, facecolor="none", edgecolor=style.RELEASE, linewidth=1.3, zorder=4))
    return len(rows) > 0


def say_time(axes, snapshot, group):
    axes.set_title(f"$t$ = {snapshot.time / group['tau']:.2f} $\\tau$ = {snapshot.time * MM:.1f} ms", loc="right",
                   fontweight="normal", fontsize=style.points(8.5))


def speed_bar(figure, circles, beside):
    bar = figure.colorbar(circles, ax=beside, fraction=0.035, pad=0.02, aspect=40)
    bar.set_label("particle speed [mm/s]")
    bar.outline.set_linewidth(0.6)


def frame(axes, group, snapshots):
    """Walls of the scene, or the extent of the particles when the scene has no channel."""
    if group["geometry"]["present"]:
        channel.draw(axes, group["geometry"])
        return
    scale = unit_of_scene(group["geometry"]).per_metre
    xy = np.concatenate([s.position[:, :2] for s in snapshots]) * scale
    margin = group["geometry"]["diameter"] * scale
    axes.set_xlim(xy[:, 0].min() - margin, xy[:, 0].max() + margin)
    axes.set_ylim(xy[:, 1].min() - margin, xy[:, 1].max() + margin)
    axes.set_aspect("equal")


def draw(statistics, index):
    group = statistics.groups[index]
    file, moments, titles = choose(statistics, index)
    if file is None:
        figure, axes = plt.subplots(figsize=(style.width(style.PAGE), 1.6))
        style.say(axes, "no snapshots in these runs (output.snapshot_interval)")
        axes.set_axis_off()
        return figure
    snapshots = [run_file.read_snapshot(file, t) for t in moments]
    unit = unit_of_scene(group["geometry"])
    norm = Normalize(0, fastest(snapshots) * MM)
    figure, panels = plt.subplots(len(moments), 1, sharex=True, squeeze=False, layout="compressed")
    for axes, snapshot, title, letter in zip(panels[:, 0], snapshots, titles, "abc"):
        frame(axes, group, snapshots)
        circles = draw_particles(axes, snapshot, norm, group)
        axes.set_ylabel(f"$y$ [{unit.name}]")
        rings = title in STANDING and mark_arch(axes, snapshot, group)
        axes.set_title(f"{letter}  {title}".rstrip() + (" (ringed)" if rings else ""))
        say_time(axes, snapshot, group)
    # Panels of equal scale on both axes fill the page only if its height follows from their shape.
    (left, right), (low, high) = panels[0, 0].get_xlim(), panels[0, 0].get_ylim()
    panel = style.width(PANEL + 1.5) - 1.5
    figure.set_size_inches(panel + 1.5, len(moments) * (panel * (high - low) / (right - left) + 0.27) + 0.35)
    panels[-1, 0].set_xlabel(f"$x$ [{unit.name}]")
    speed_bar(figure, circles, panels[:, 0])
    return figure


def figures(statistics):
    for index in range(len(statistics.groups)):
        yield f"snapshots{suffix(statistics, index)}", draw(statistics, index)
