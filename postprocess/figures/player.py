"""The player of the page: frames of a burst of each group, walls and three.js, all within the page, so that it works offline.

Of a burst come some frames of the arch before it, many of the burst and some of the new arch; of a run without one, frames of all of it.
The data of all films take at most MOST_BYTES, of one FILM_BYTES: places, speeds and radii in 16 bits (a step is 1/65535 of the picture), of a
contact its two particles and its force likewise, where they were recorded; fewer frames where there are many particles, and of a long channel
the part that the figures show.
"""

import base64
import json
import os
from pathlib import Path

import fig_snapshots
import matplotlib.pyplot as plt
import numpy as np
import run_file
from lengths import MICRO

MOST_FRAMES = 60
MOST_BYTES = 4_500_000  # in the page
FILM_BYTES = 2_800_000
FEWEST_FRAMES = 3
FRAMES = {"before": 8, "cleared": 10, "burst": 27, "after": 12}  # of a burst, beside its three moments
RATE = 12               # frames a second
LEVELS = 65535          # of a number of 16 bits
IN_TEXT = 4 / 3         # base64
FAINT = 0.02            # of the strongest force: a tube that nobody sees
A_WALL = LEVELS         # in place of a particle
UM = MICRO.per_metre      # whatever the page writes: a film has no axes
THREE = "/usr/share/javascript/three/three.min.js"  # Debian's libjs-three


def spread(times, count):
    """At most so many of the times, evenly, with the first and the last."""
    picked = np.unique(np.linspace(0, len(times) - 1, count).round().astype(int)) if len(times) else []
    return [times[k] for k in picked]


def moments_of(burst, times):
    """[(time, stage)] of the frames."""
    (_, clog_ends), (_, next_ends) = burst.quiet
    start, end = burst.inside[0], burst.inside[-1]
    lead = max((end - start) / 2, burst.tau)
    within = {"before": (max(burst.quiet[0][0], clog_ends - lead), clog_ends), "cleared": (clog_ends, start),
              "burst": (start, end), "after": (end, min(next_ends, end + lead))}
    names = dict(zip(("before", "burst", "after"), burst.titles), cleared="clog cleared")
    stage_of = {moment: name for moment, name in zip(burst.moments, ("before", "burst", "after"))}
    for name, (low, high) in within.items():
        open_left = name in ("burst", "before")
        inside = times[((times >= low) if open_left else (times > low)) & (times < high if name in ("before", "cleared") else times <= high)]
        stage_of.update((time, name) for time in spread(inside, FRAMES[name]))
    return [(time, names[stage_of[time]]) for time in sorted(stage_of)]


def choose(statistics, group):
    """(run file, [(time, stage)]) of the burst of a group that is best shown, or of its first run with snapshots; or None."""
    found = fig_snapshots.candidates(statistics, statistics.groups.index(group))
    if found:
        burst = max(found, key=fig_snapshots.worth)
        return burst.file, moments_of(burst, np.array(run_file.snapshot_times(burst.file)))
    for entry in group["runs"]:
        times = run_file.snapshot_times(entry["file"])
        if len(times) >= FEWEST_FRAMES:
            return entry["file"], [(time, "") for time in spread(times, MOST_FRAMES)]
    return None


def in_order(chosen):
    """Those with a whole burst come first: what the page opens with is worth a look."""
    return sorted(chosen, key=lambda each: not any(stage for _, stage in each[2]))


def seen_from(geometry):
    """x where the picture begins [m], as in the figures."""
    return -7 * geometry["neck_width"] if geometry["present"] else -np.inf


def walls_of(geometry):
    """In micrometres; None where there are none to draw."""
    def text(numbers):
        return base64.b64encode(np.asarray(numbers, dtype="<f4").tobytes()).decode()
    if not geometry["present"]:
        return None
    if "walls" in geometry:
        return {"triangles": text(np.array(geometry["walls"]) * UM)}
    if "upper" not in geometry:
        return None
    sides = {side: (np.array(geometry[side]) * UM).round(4) for side in ("upper", "lower")}
    left = seen_from(geometry) * UM
    for points in sides.values():
        points[:, 0] = np.maximum(points[:, 0], left)
    return {side: points.tolist() for side, points in sides.items()} | {"height": geometry["neck_height"] * UM}


def bytes_of(snapshot, row):
    return (len(snapshot.speed) * row + (8 * len(snapshot.contacts.force) if snapshot.contacts else 0)) * IN_TEXT


def thinned(moments, snapshots, row, most):
    """As many frames as there is room for."""
    size = sum(bytes_of(each, row) for each in snapshots)
    if size <= most:
        return moments, snapshots
    chosen = spread(range(len(moments)), max(int(len(moments) * most / size * 0.95), FEWEST_FRAMES))
    moments, snapshots = [moments[k] for k in chosen], [snapshots[k] for k in chosen]
    if sum(bytes_of(each, row) for each in snapshots) > most:
        return [], []
    return moments, snapshots


def in_two_bytes(normal):
    """A direction: its height in the upper byte, its turn about z in the lower."""
    height = np.round((normal[:, 2] + 1) * 127.5).clip(0, 255)
    turn = np.round(np.arctan2(normal[:, 1], normal[:, 0]) * 128 / np.pi) % 256
    return 256 * height + turn


def contacts_of(snapshots):
    """A row a contact and frame: its particles in the frame, its force, and towards which wall. None where no run recorded them."""
    if any(each.contacts is None for each in snapshots):
        return None
    force = np.abs(np.concatenate([each.contacts.force for each in snapshots]))
    strongest = float(np.quantile(force, 0.99)) if len(force) else 0.0
    if strongest == 0:
        return None
    counts, rows = [], []
    for each in snapshots:
        c = each.contacts
        seen = np.abs(c.force) > FAINT * strongest
        counts.append(int(seen.sum()))
        rows.append(np.stack([c.a[seen], np.where(c.b[seen] < 0, A_WALL, c.b[seen]),
                              np.round((c.force[seen] / strongest).clip(-1, 1) * 32767) + 32768, in_two_bytes(c.normal[seen])], axis=1))
    return {"counts": counts, "strongest": f"{strongest * 1e6:.3g}", "data": base64.b64encode(np.vstack(rows).astype("<u2").tobytes()).decode()}


def film(group, file, moments, most):
    """What player.js reads; None when a few frames alone are too large."""
    geometry = group["geometry"]
    snapshots = [run_file.read_snapshot(file, time).beyond(seen_from(geometry)) for time, _ in moments]
    radii = np.concatenate([each.radius for each in snapshots])
    if not len(radii):
        return None
    largest = float(radii.max()) * UM
    columns = ["x", "y", "z", "speed"] + (["radius"] if np.ptp(radii) > 0 else [])
    moments, snapshots = thinned(moments, snapshots, 2 * len(columns), most)
    if not moments:
        return None
    position = np.concatenate([each.position for each in snapshots]) * UM
    speed = np.concatenate([each.speed for each in snapshots])
    fastest = fig_snapshots.fastest(snapshots)
    low, high = position.min(axis=0), position.max(axis=0)
    step = np.maximum(high - low, 1e-6) / LEVELS
    rows = [np.round((position - low) / step), np.round(np.minimum(speed / fastest, 1) * LEVELS)[:, None]]
    if "radius" in columns:
        rows.append(np.round(np.concatenate([each.radius for each in snapshots]) * UM / largest * LEVELS)[:, None])
    walls = walls_of(geometry)
    box = np.array([low - largest, high + largest])
    if walls:
        corners = np.frombuffer(base64.b64decode(walls["triangles"]), dtype="<f4").reshape(-1, 3) if "triangles" in walls else np.array(
            [[*corner, z] for side in ("upper", "lower") for corner in walls[side] for z in (0, walls["height"])])
        box = np.array([np.minimum(box[0], corners.min(axis=0)), np.maximum(box[1], corners.max(axis=0))])
        box[0, 0] = max(box[0, 0], min(seen_from(geometry) * UM, low[0]))
    digits = max(1, int(np.ceil(-np.log10(max(1e3 * np.diff([time for time, _ in moments]).min(initial=1), 1e-6)))) + 1)
    stages = [stage for _, stage in moments]
    data = {"label": group["label"], "columns": columns, "counts": [len(each.speed) for each in snapshots], "low": low.tolist(), "step": step.tolist(),
            "radius": largest / LEVELS if "radius" in columns else largest, "fastest": fastest * fig_snapshots.MM,
            "times": [f"{1e3 * time:.{digits}f}" for time, _ in moments], "stages": stages, "rate": RATE,
            "begin": stages.index("burst") if "burst" in stages else 0, "box": box.round(3).tolist(), "walls": walls, "contacts": contacts_of(snapshots),
            "colours": (plt.get_cmap(fig_snapshots.SPEED_COLOURS)(np.linspace(0, 1, 64))[:, :3] * 255).round().astype(int).ravel().tolist(),
            "data": base64.b64encode(np.hstack(rows).astype("<u2").tobytes()).decode()}
    return data | {"caption": caption(group, data)}


def caption(group, data):
    walls = "" if data["walls"] or not group["geometry"]["present"] else " The walls, of too many triangles for a page, are left out."
    chains = " f shows the forces between particles and walls." if data["contacts"] else ""
    return (f"{group['label']}: {len(data['counts'])} snapshots of one run; the time between two of them may differ. Drag turns, Shift and drag moves; after a click "
            f"the wheel zooms and keys work: arrows turn, + and − zoom, space plays, comma and full stop step, 0 resets, Esc lets go.{chains}{walls}")


def films(statistics):
    """(what player.js reads, a film a group that has one; labels of groups whose frames do not fit)."""
    chosen = [(group, *found) for group in statistics.groups if (found := choose(statistics, group))]
    made, left_out = [], []
    for group, file, moments in in_order(chosen):
        data = film(group, file, moments, min(FILM_BYTES, MOST_BYTES / len(chosen)))
        if data:
            made.append(data)
        else:
            left_out.append(group["label"])
    return made, left_out, bool(chosen)


def section(statistics):
    """What the page needs of the player, or {"why": why there is none}."""
    three = Path(os.environ.get("CLOG_THREE") or THREE)
    if not three.exists():
        return {"why": f"No film in this page: {three} is missing (apt-get install libjs-three)."}
    made, left_out, chosen = films(statistics)
    if not chosen:
        return {"why": "No film in this page: it needs snapshots of a run (output.snapshot_interval)."}
    if not made:
        return {"why": f"No film in this page: its frames do not fit into {MOST_BYTES / 1e6:.0f} MB."}
    here = Path(__file__).parent
    return {"frame": (here / "player.html").read_text(encoding="utf-8"), "style": (here / "player.css").read_text(encoding="utf-8"),
            "scripts": [three.read_text(encoding="utf-8").replace("</script", "<\\/script"), (here / "player.js").read_text(encoding="utf-8")],
            "data": json.dumps(made).replace("<", "\\u003c"), "left_out": left_out}
