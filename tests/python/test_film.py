"""`clog film`: frames and films of a run, and what it refuses."""

import json
import os
import shutil
import subprocess
import unittest

import fixtures
import h5py
import matplotlib.image
import numpy as np


def film(*words, **environment):
    return subprocess.run([fixtures.PROGRAM, "film", *words], cwd=fixtures.folder(), capture_output=True, text=True, check=False,
                          env={**os.environ, **environment})


class Film(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_file = fixtures.folder() / "runs" / "run_0003.h5"  # snapshots at 0, 4 and 6 ms

    def refused(self, message, *words, **environment):
        made = film(*words, **environment)
        self.assertEqual((made.returncode, made.stdout), (1, ""), made.stderr)
        self.assertIn(message, made.stderr)
        self.assertEqual(made.stderr.count("\n"), 1)

    def test_frames(self):
        made = film(self.run_file, "--from", "3 ms", "--out", "frames")
        self.assertEqual((made.returncode, made.stdout), (0, "frames/frame_0001.png\nframes/frame_0002.png\n"), made.stderr)
        first, second = (matplotlib.image.imread(fixtures.folder() / f"frames/frame_{k:04}.png") for k in (1, 2))
        self.assertEqual(first.shape, second.shape)
        self.assertGreater(np.abs(first - second).max(), 0.3)  # particles have moved
        self.assertEqual(sorted(each.name for each in (fixtures.folder() / "frames").iterdir() if not each.name.startswith(".")),
                         ["frame_0001.png", "frame_0002.png"])
        self.refused("frames: holds frames already (frame_000", self.run_file, "--out", "frames")

    @unittest.skipUnless(shutil.which("ffprobe"), "no ffmpeg (apt-get install ffmpeg)")
    def test_films(self):
        for name, codec in (("burst.mp4", "h264"), ("burst.webm", "vp9")):
            made = film(self.run_file, "--out", name, "--rate", "5")
            self.assertEqual((made.returncode, made.stdout), (0, f"./{name}\n"), made.stderr)
            told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of", "json", name], cwd=fixtures.folder(),
                                  capture_output=True, check=True)
            stream = json.loads(told.stdout)["streams"][0]
            self.assertEqual((stream["codec_name"], stream["nb_read_frames"], stream["r_frame_rate"]), (codec, "3", "5/1"))

    def test_refusals(self):
        run = self.run_file
        self.refused("film.gif: a film ends with .mp4 or .webm; without an ending it is a folder for PNG frames", run, "--out", "film.gif")
        self.refused("film.mp4: needs ffmpeg (apt-get install ffmpeg)", run, "--out", "film.mp4", PATH="/nonexistent")
        self.refused("--from 3 um (must be a time, such as '120 ms')", run, "--from", "3 um", "--out", "none")
        self.refused("no snapshot between --from and --to (it has 3 from 0 s to 0.006", run, "--from", "1 s", "--out", "none")
        self.refused("--from 0.002 s is later than --to 0.001 s", run, "--from", "2 ms", "--to", "1 ms", "--out", "none")
        self.refused("--every 0: at least 1", run, "--every", "0", "--out", "none")
        self.refused("--rate 1000: frames a second, from 1 to 120", run, "--rate", "1000", "--out", "none")
        self.refused("nothing.h5 (no such file)", "nothing.h5", "--out", "none")
        self.refused("flow.h5", "flow.h5", "--out", "none")
        self.assertFalse((fixtures.folder() / "none").exists())

    def test_bursts_have_snapshots_of_their_own(self):
        subprocess.run([fixtures.PROGRAM, "run", "scene.toml", "--flow", "flow.h5", "--out", "bursts", "--seeds", "3", "--set", "time.end=8 ms", "--set", "particles.diameter=40 um",
                        "--set", "output.burst_snapshots=50 us", "--set", "output.snapshot_interval=0 s", "--set", "output.checkpoint_interval=60 s"],
                       cwd=fixtures.folder(), check=True, capture_output=True)
        with h5py.File(fixtures.folder() / "bursts" / "run_0003.h5") as file:
            snapshots, off, on = (file[name][:] for name in ("snapshots/time", "releases/off", "releases/on"))
        self.assertEqual((snapshots[1], off[0] > 3e-3), (off[0], True))  # nothing between the start and the release
        for begin, end in ((off[0], on[0]), (on[0], on[0] + 1.5e-3)):  # friction off, and on again
            within = snapshots[(snapshots >= begin) & (snapshots < end)]
            self.assertLess(len(within), 50)
            self.assertAlmostEqual(len(within), (end - begin) / 50e-6, delta=1.5)
            self.assertEqual(within[0], begin)
            np.testing.assert_allclose(np.diff(within), 50e-6, atol=5e-6)

    def test_too_many_frames(self):
        subprocess.run([fixtures.PROGRAM, "run", "scene.toml", "--flow", "flow.h5", "--out", "often", "--seeds", "3", "--set", "time.end=6 ms",
                        "--set", "output.snapshot_interval=6 us", "--set", "output.checkpoint_interval=60 s"],
                       cwd=fixtures.folder(), check=True, capture_output=True)
        made = film("often/run_0003.h5", "--out", "none")
        self.assertEqual(made.returncode, 1)
        self.assertRegex(made.stderr, r"^clog: often/run_0003.h5: \d{3,4} snapshots, at most 600 in a film: narrow --from and --to, "
                                      r"or take fewer with --every 2\n$")


if __name__ == "__main__":
    unittest.main()
