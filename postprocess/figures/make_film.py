"""Draws the snapshots of a run one by one, for `clog film`. Usage: make_film.py JOB.json OUT_FOLDER

The job: run (file), geometry and tau of its scene, frames (numbers of snapshots), rate (frames a second), film (name of the
film; empty: the frames are what is wanted).
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import fig_snapshots
import matplotlib
import matplotlib.pyplot as plt
import run_file
import style
from lengths import unit_of_scene
from matplotlib.colors import Normalize

DPI = 150
EVEN = "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white"  # both codecs want an even number of pixels
CODECS = {".mp4": ["-c:v", "libx264", "-crf", "18", "-movflags", "+faststart"],
          ".webm": ["-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0", "-row-mt", "1"]}


def draw_frames(job, folder):
    """One look and one scale for all of them. Returns the paths."""
    snapshots = run_file.read_snapshots(job["run"], job["frames"])
    group = {"geometry": job["geometry"], "tau": job["tau"]}
    norm = Normalize(0, fig_snapshots.fastest(snapshots) * fig_snapshots.MM)
    figure, axes = plt.subplots(figsize=(style.PAGE, style.PAGE), layout="constrained")
    fig_snapshots.frame(axes, group, snapshots)
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    figure.set_figheight(max(2.2, 0.78 * style.PAGE * (high - low) / (right - left) + 0.7))
    unit = unit_of_scene(group["geometry"])
    axes.set_xlabel(f"$x$ [{unit.name}]")
    axes.set_ylabel(f"$y$ [{unit.name}]")
    fig_snapshots.speed_bar(figure, fig_snapshots.draw_particles(axes, snapshots[0], norm, group), axes)
    paths = []
    for k, snapshot in enumerate(snapshots):
        axes.collections[-1].remove()
        fig_snapshots.draw_particles(axes, snapshot, norm, group)
        fig_snapshots.say_time(axes, snapshot, group)
        paths.append(folder / f"frame_{k + 1:04d}.png")
        figure.savefig(paths[-1], dpi=DPI, metadata={"Software": None})
        if k == 0:
            figure.set_layout_engine("none")  # where things stand is settled: nothing jumps
    return paths


def encode(job, frames, film):
    words = ["ffmpeg", "-v", "error", "-y", "-framerate", str(job["rate"]), "-i", str(frames / "frame_%04d.png"), "-vf", EVEN,
             "-pix_fmt", "yuv420p", *CODECS[film.suffix], str(film)]
    made = subprocess.run(words, capture_output=True, text=True, check=False)
    if made.returncode != 0:
        said = made.stderr.strip().splitlines() or ["no word"]
        raise SystemExit(f"ffmpeg ended with status {made.returncode}: {said[-1]}")


def main():
    if len(sys.argv) != 3:
        raise SystemExit("usage: make_film.py JOB.json OUT_FOLDER")
    matplotlib.use("Agg")
    job = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    folder = Path(sys.argv[2])
    if not job["film"]:
        paths = draw_frames(job, folder)
    else:
        paths = [folder / job["film"]]
        with tempfile.TemporaryDirectory(dir=folder) as frames:
            draw_frames(job, Path(frames))
            encode(job, Path(frames), paths[0])
    for path in paths:
        print(f"wrote {path}")


if __name__ == "__main__":
    main()
