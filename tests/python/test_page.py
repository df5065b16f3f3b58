"""The page of `clog report` in a real browser: it loads without an error, draws, plays, obeys; and does without WebGL.

CLOG_SCREENSHOTS=FOLDER keeps what was seen.
"""

import base64
import json
import os
import pathlib
import re
import subprocess
import unittest

import browser
import fixtures
import h5py
import numpy as np

BACKGROUND = np.array([0xf4, 0xf6, 0xf8]) / 255
FRAME = "+document.getElementById('film').dataset.frame"
# A first burst, a clog of 7 ms (the threshold is tau / 2, 5 ms), a burst of 2 ms, a clog until the end [s].
PASSAGES = np.array([2e-4, 3e-4, *np.linspace(7.4e-3, 9.4e-3, 9)])


def make_page(name, *more, mixed=False):
    """A run of the real program with passages that are made up, so that it holds a burst with snapshots before, in and after it."""
    folder = fixtures.folder() / name
    words = {"unclog.protocol": "none", "time.end": "20 ms", "output.snapshot_interval": "0.25 ms", "output.checkpoint_interval": "60 s"}
    subprocess.run([fixtures.PROGRAM, "run", "scene.toml", "--flow", "flow.h5", "--out", folder, "--seeds", "3",
                    *[word for key, value in words.items() for word in ("--set", f"{key}={value}")]],
                   cwd=fixtures.folder(), check=True, capture_output=True)
    columns = {"time": (PASSAGES, "s"), "id": (np.arange(len(PASSAGES)), "1"), "y": (0 * PASSAGES, "m"), "z": (0 * PASSAGES + 5e-5, "m"),
               "friction_off": (np.zeros(len(PASSAGES), np.uint8), "1")}
    with h5py.File(folder / "run_0003.h5", "r+") as file:
        for column in list(file["passages"]):
            del file[f"passages/{column}"]
        for column, (values, unit) in columns.items():
            file.create_dataset(f"passages/{column}", data=values).attrs["unit"] = np.bytes_(unit)
        if mixed:
            file["snapshots/radius"][:] *= np.where(file["snapshots/id"][:] % 2, 0.5, 1)
    made = subprocess.run([fixtures.PROGRAM, "report", folder], capture_output=True, text=True, check=False, env={**os.environ, **dict(more)})
    assert made.returncode == 0, made.stdout + made.stderr
    return folder / "report" / "report.html"


def film_of(page):
    """What the player reads, and its rows: one a particle and frame."""
    text = page.read_text(encoding="utf-8")
    film = json.loads(re.search(r'id="film-data">(.*?)</script>', text, re.S).group(1))
    return film, np.frombuffer(base64.b64decode(film["data"]), dtype="<u2").reshape(-1, len(film["columns"]))


def keep(name, png):
    if "CLOG_SCREENSHOTS" in os.environ:
        folder = pathlib.Path(os.environ["CLOG_SCREENSHOTS"])
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{name}.png").write_bytes(png)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = make_page("filmed")
        cls.browser = browser.Browser(fixtures.scratch())
        cls.addClassCleanup(cls.browser.close)

    def seen(self, name):
        pixels, png = self.browser.picture(".stage canvas")
        keep(name, png)
        return pixels

    def pause_at(self, key):
        self.browser.value("document.querySelector('.stage').focus({preventScroll: true})")
        self.browser.key(key)
        self.browser.wait_for("document.querySelector('.play').textContent === 'Play'")

    def test_plays_at_both_widths(self):
        for width in (1280, 400):
            with self.subTest(width=width):
                self.browser.open(self.page, width)
                self.browser.wait_for("document.querySelector('.play').textContent === 'Pause'")
                begin = self.browser.value(FRAME)
                self.browser.wait_for(f"{FRAME} > {begin + 2}")
                keep(f"page_{width}", self.browser.picture()[1])
                self.pause_at("End")
                last = self.seen(f"last_{width}")
                self.pause_at("Home")
                first = self.seen(f"first_{width}")
                drawn = np.abs(first - BACKGROUND).max(axis=2) > 0.1
                self.assertGreater(drawn.mean(), 0.15)
                self.assertLess(drawn.mean(), 0.95)
                self.assertGreater((np.abs(first - last).max(axis=2) > 0.1).mean(), 0.005)
                self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
                self.assertFalse(self.browser.value("document.querySelector('details.still').open"))
                self.assertEqual(self.browser.complaints(), [])

    def test_stages_of_the_burst(self):
        self.browser.open(self.page, 1280)
        names = "[...document.querySelectorAll('.stages button')].map(each => each.textContent)"
        self.assertEqual(self.browser.value(names), ["arch", "burst", "new arch"])
        self.browser.value("document.querySelectorAll('.stages button')[1].click()")
        moment = self.browser.value("document.querySelector('.moment').textContent")
        self.assertTrue(moment.endswith(" ms, burst"), moment)
        self.assertAlmostEqual(float(moment.split()[2]), 7.5, delta=0.26)
        self.assertLessEqual(self.browser.value("+document.querySelector('.controls input').max"), 59)

    def test_keys_turn_and_step(self):
        self.browser.open(self.page, 1280)
        self.pause_at("Home")
        before = self.seen("before_turn")
        self.browser.key(".")
        self.assertEqual(self.browser.value(FRAME), 1)
        self.browser.key(",")
        for _ in range(5):
            self.browser.key("ArrowLeft")
        turned = self.seen("turned")
        self.assertEqual(self.browser.value(FRAME), 0)
        self.assertGreater((np.abs(before - turned).max(axis=2) > 0.1).mean(), 0.05)
        self.browser.key("0")
        self.assertLess((np.abs(before - self.seen("reset")).max(axis=2) > 0.1).mean(), 0.001)
        self.browser.key(" ")
        self.assertEqual(self.browser.value("document.querySelector('.play').textContent"), "Pause")

    def test_the_wheel_scrolls_the_page_until_the_film_has_the_focus(self):
        self.browser.open(self.page, 1280)
        self.browser.wheel(".stage", 120)
        self.browser.wait_for("scrollY > 0")
        self.browser.value("scrollTo(0, 0)")
        self.pause_at("Home")
        before = self.seen("before_zoom")
        self.browser.wheel(".stage", -240)
        after = self.seen("zoomed")
        self.assertEqual(self.browser.value("scrollY"), 0)
        self.assertGreater((np.abs(before - after).max(axis=2) > 0.1).mean(), 0.05)

    def test_without_webgl_the_still_stands_in_its_place(self):
        script = self.browser.ask("Page.addScriptToEvaluateOnNewDocument", source="HTMLCanvasElement.prototype.getContext = () => null")
        self.addCleanup(lambda: self.browser.ask("Page.removeScriptToEvaluateOnNewDocument", **script))
        self.browser.open(self.page, 1280)
        self.assertTrue(self.browser.value("document.getElementById('film').hidden && document.querySelector('details.still').open"))
        self.assertGreater(self.browser.value("document.querySelector('details.still img').naturalWidth"), 300)
        self.assertEqual(self.browser.complaints(), [])

    def test_frames_are_snapshots_of_the_run(self):
        for page, mixed in ((self.page, False), (make_page("mixed", mixed=True), True)):
            film, rows = film_of(page)
            with h5py.File(page.parents[1] / "run_0003.h5") as file:
                times, first = file["snapshots/time"][:], file["snapshots/first"][:]
                position, velocity, radius = (file[f"snapshots/{name}"][:] for name in ("position", "velocity", "radius"))
            ends = np.cumsum(film["counts"])
            self.assertEqual(film["columns"], ["x", "y", "z", "speed"] + ["radius"] * mixed)
            for frame in (0, len(ends) // 2, len(ends) - 1):
                k = int(np.argmin(np.abs(times * 1e3 - float(film["times"][frame]))))
                mine, theirs = rows[ends[frame] - film["counts"][frame]: ends[frame]], slice(first[k], first[k + 1])
                np.testing.assert_allclose(mine[:, :3] * film["step"] + film["low"], 1e6 * position[theirs], atol=0.01)  # [um]
                speed = 1e3 * np.linalg.norm(velocity[theirs], axis=1)
                np.testing.assert_allclose(mine[:, 3] / 65535 * film["fastest"], np.minimum(speed, film["fastest"]), atol=1e-3)
                drawn = mine[:, 4] * film["radius"] if mixed else np.full(len(mine), film["radius"])
                np.testing.assert_allclose(drawn, 1e6 * radius[theirs], atol=0.01)

    def test_size_and_what_is_loaded(self):
        text = self.page.read_text(encoding="utf-8")
        film = text[text.index('id="film-data">'):]
        self.assertLess(film.index("</script>"), 3_000_000)
        self.assertNotIn("<script src", text)

    def test_without_three_the_page_says_so(self):
        page = make_page("unfilmed", ("CLOG_THREE", "/nonexistent/three.min.js")).read_text(encoding="utf-8")
        self.assertIn("No film in this page: /nonexistent/three.min.js is missing (apt-get install libjs-three).", page)
        self.assertNotIn("film-data", page)
        self.assertIn('<img alt="snapshots"', page)


if __name__ == "__main__":
    unittest.main()
