"""The page of `clog report` in a real browser: it loads without an error, draws, plays, obeys; and does without WebGL.

CLOG_SCREENSHOTS=FOLDER keeps what was seen.
"""

import base64
import csv
import io
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

import clogflow

BACKGROUND = np.array([0xf4, 0xf6, 0xf8]) / 255
FRAME = "+document.getElementById('film').dataset.frame"
# A first burst, a clog of 7 ms (the threshold is tau / 2, 5 ms), a burst of 2 ms, a clog until the end [s].
PASSAGES = np.array([2e-4, 3e-4, *np.linspace(7.4e-3, 9.4e-3, 9)])


def make_run(name, contacts=False, mixed=False):
    """A run of the real program with passages that are made up, so that it holds a burst with snapshots before, in and after it."""
    folder = fixtures.folder() / name
    words = {"unclog.protocol": "none", "time.end": "20 ms", "output.snapshot_interval": "0.25 ms", "output.checkpoint_interval": "60 s"}
    words |= fixtures.TOUCHING if contacts else {}
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
    return folder


def report(folder, *words, **environment):
    return subprocess.run([fixtures.PROGRAM, "report", folder, *words], capture_output=True, text=True, check=False, env={**os.environ, **environment})


def make_page(name, *words, environment=None, **run):
    made = report(make_run(name, **run), *words, **(environment or {}))
    assert made.returncode == 0, made.stdout + made.stderr
    return fixtures.folder() / name / "report" / "report.html"


def film_of(page):
    """What the player reads of the first film, and its rows: one a particle and frame."""
    text = page.read_text(encoding="utf-8")
    film = json.loads(re.search(r'id="film-data">(.*?)</script>', text, re.S).group(1))[0]
    return film, np.frombuffer(base64.b64decode(film["data"]), dtype="<u2").reshape(-1, len(film["columns"]))


def keep(name, png):
    if "CLOG_SCREENSHOTS" in os.environ:
        folder = pathlib.Path(os.environ["CLOG_SCREENSHOTS"])
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{name}.png").write_bytes(png)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = make_page("filmed", contacts=True)
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

    def test_force_chains(self):
        film, _ = film_of(self.page)
        frame = int(np.argmax(film["contacts"]["counts"]))
        self.browser.open(self.page, 1280)
        self.pause_at("End")
        self.browser.value(f"(() => {{ const slider = document.querySelector('.controls input'); slider.value = {frame}; slider.oninput(); }})()")
        without = self.seen("without_chains")
        self.browser.value("document.querySelector('.chains').click()")
        with_chains = self.seen("chains")
        self.assertEqual(self.browser.value("document.querySelector('.chains').getAttribute('aria-pressed')"), "true")
        self.assertEqual(self.browser.value("+document.getElementById('film').dataset.links"), film["contacts"]["counts"][frame])
        self.assertGreater((np.abs(without - with_chains).max(axis=2) > 0.1).mean(), 0.05)  # the spheres are pale
        self.assertGreater((with_chains.max(axis=2) < 0.3).mean(), 5e-4)                    # and the tubes are ink
        self.browser.key("f")
        self.assertLess((np.abs(without - self.seen("chains_off")).max(axis=2) > 0.1).mean(), 0.001)
        self.assertEqual(self.browser.complaints(), [])

    def test_force_chains_are_the_contacts_of_the_run(self):
        film, _ = film_of(self.page)
        links = np.frombuffer(base64.b64decode(film["contacts"]["data"]), dtype="<u2").reshape(-1, 4)
        frame = int(np.argmax(film["contacts"]["counts"]))
        end = sum(film["contacts"]["counts"][:frame + 1])
        shown = links[end - film["contacts"]["counts"][frame]: end]
        snapshot = clogflow.Run(self.page.parents[1] / "run_0003.h5").snapshots.at(1e-3 * float(film["times"][frame]))
        contacts, strongest = snapshot.contacts, 1e-6 * float(film["contacts"]["strongest"])
        strong = np.abs(contacts.normal_force) > 0.05 * strongest
        drawn = {(int(a), int(b)): f for a, b, f, _ in shown if b != 65535}
        for a, b, force in zip(contacts.a[strong], contacts.b[strong], contacts.normal_force[strong]):
            if b >= 0:
                pair = tuple(int(np.searchsorted(snapshot.id, each)) for each in (a, b))
                self.assertAlmostEqual((drawn[pair] - 32768) / 32767, min(1, force / strongest), delta=0.01)
        self.assertTrue(np.all(shown[:, 0] < len(snapshot)))
        self.assertEqual(film["counts"][frame], len(snapshot))
        # Walls: the end of the tube is where the contact is.
        walls = shown[shown[:, 1] == 65535]
        self.assertGreater(len(walls), 0)
        height, turn = (walls[:, 3] >> 8) / 127.5 - 1, (walls[:, 3] & 255) * np.pi / 128
        flat = np.sqrt(np.maximum(0, 1 - height**2))
        normals = np.stack([flat * np.cos(turn), flat * np.sin(turn), height], axis=1)
        of_walls = contacts.b < 0
        for row, normal in zip(walls[:, 0], normals):
            mine = contacts.normal[of_walls & (np.searchsorted(snapshot.id, contacts.a) == row)]
            self.assertGreater((mine @ normal).max(), 0.995)

    def test_dark_and_light(self):
        ground = "getComputedStyle(document.body).backgroundColor"
        for scheme, other in (("light", "dark"), ("dark", "light")):
            self.browser.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            for width in (1280, 400):
                self.browser.open(self.page, width)
                self.browser.wait_for("document.querySelector('.play').textContent === 'Pause'")
                keep(f"{scheme}_{width}", self.browser.picture()[1])
                self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
            before = self.browser.value(ground)
            self.assertEqual(before, "rgb(255, 255, 255)" if scheme == "light" else "rgb(20, 24, 29)")
            self.browser.value("document.querySelector('.theme').click()")
            self.assertEqual(self.browser.value("document.documentElement.dataset.theme"), other)
            self.assertNotEqual(self.browser.value(ground), before)
            self.browser.value("localStorage.clear()")
            self.assertEqual(self.browser.complaints(), [])
        self.browser.ask("Emulation.setEmulatedMedia", features=[])

    def test_the_first_screen_has_sentence_film_and_three_numbers(self):
        self.browser.open(self.page, 1280)
        said = self.browser.value("document.querySelector('.lead').textContent")
        self.assertEqual(said, "Spheres of 50 µm (D/d = 2) driven by a flow of 5 mm/s through a neck of 100 µm × 100 µm: 1 run, 0.02 s simulated; a clog is left to itself.")
        self.assertEqual(self.browser.value("document.querySelectorAll('.card .value').length"), 3)
        below = "Math.max(...[...document.querySelectorAll('.lead, .stage, .card')].map(each => each.getBoundingClientRect().bottom))"
        self.assertLess(self.browser.value(below), 900)
        self.assertTrue(self.browser.value("[...document.images].every(each => each.alt.length > 30)"))

    def test_tables_sort_and_are_saved(self):
        self.browser.open(self.page, 1280)
        column = "[...document.querySelectorAll('table[data-name=numbers] tbody tr')].map(row => row.cells[{}].textContent.trim())"
        unsorted = self.browser.value(column.format(0))
        self.browser.value("document.querySelector('table[data-name=numbers] th button').click()")
        names = self.browser.value(column.format(0))
        self.assertNotEqual(names, unsorted)
        self.assertEqual(sorted(names), sorted(unsorted))
        self.browser.value("document.querySelectorAll('table[data-name=numbers] th button')[1].click()")
        values = self.browser.value("[...document.querySelectorAll('table[data-name=numbers] tbody tr')].map(row => row.cells[1].dataset.value).filter(each => each !== undefined).map(Number)")
        self.assertGreater(len(values), 5)
        self.assertEqual(values, sorted(values))
        rows = list(csv.DictReader(io.StringIO(self.browser.value("clogflowCsv('numbers')"))))
        (flow,) = [row for row in rows if row["name"] == "passages per time, clogs included [1/s]"]
        self.assertAlmostEqual(float(flow["D/d = 2"]), len(PASSAGES) / 0.02, delta=0.1)
        self.assertEqual(len(rows), len(names))

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
        page = make_page("unfilmed", environment={"CLOG_THREE": "/nonexistent/three.min.js"}).read_text(encoding="utf-8")
        self.assertIn("No film in this page: /nonexistent/three.min.js is missing (apt-get install libjs-three).", page)
        self.assertNotIn("film-data", page)
        self.assertIn('<img alt="Snapshots of the particles at the neck, D/d = 2:', page)


class Sweep(unittest.TestCase):
    def test_every_point_has_its_film(self):
        folder = fixtures.folder() / "points"
        made = subprocess.run([fixtures.PROGRAM, "run", "scene.toml", "--flow", "flow.h5", "--out", "points", "--seeds", "3", "--set", "time.end=4 ms", "--set",
                               "output.snapshot_interval=0.5 ms", "--set", "output.checkpoint_interval=60 s",
                               "--set", 'ensemble.sweep=["particles.diameter = 50 um, 45 um"]'], cwd=fixtures.folder(), capture_output=True, text=True, check=False)
        self.assertEqual(made.returncode, 0, made.stderr)
        made = report(folder)
        self.assertEqual(made.returncode, 0, made.stderr)
        seen = browser.Browser(fixtures.scratch())
        self.addCleanup(seen.close)
        seen.open(folder / "report" / "report.html", 1280)
        seen.wait_for("document.querySelector('.play').textContent === 'Pause'")
        self.assertEqual(seen.value("[...document.querySelector('.which').options].map(each => each.textContent)"), ["D/d = 2", "D/d = 2.22"])
        first = seen.picture(".stage canvas")[0]
        seen.value("(() => { const which = document.querySelector('.which'); which.value = 1; which.onchange(); document.querySelector('.play').click(); })()")
        self.assertEqual(seen.value("document.getElementById('film').dataset.film"), "1")
        self.assertTrue(seen.value("document.querySelector('.caption').textContent").startswith("D/d = 2.22: "))
        self.assertTrue(seen.value("document.querySelector('.chains').hidden"))  # these runs recorded none
        pixels, png = seen.picture(".stage canvas")
        keep("second_film", png)
        self.assertGreater((np.abs(first - pixels).max(axis=2) > 0.1).mean(), 0.01)
        self.assertEqual(seen.complaints(), [])


class Look(unittest.TestCase):
    def test_width_font_and_flow_by_option(self):
        page = make_page("narrow", "--figure-width", "85 mm", "--font-size", "7", "--flow", fixtures.folder() / "flow.h5")
        for name in ("bursts", "lapses", "series"):
            pdf = (page.parent / f"{name}.pdf").read_bytes()
            width = float(re.search(rb"/MediaBox \[ 0 0 ([\d.]+) ", pdf).group(1))
            self.assertAlmostEqual(width, 85 / 25.4 * 72, delta=0.1)
            self.assertIn(b"/FontFile2", pdf)
        text = page.read_text(encoding="utf-8")
        self.assertIn("what reading the grid adds in the neck", text)
        self.assertIn("--figure-width &#39;85 mm&#39; --font-size 7", text)

    def test_refusals(self):
        folder = fixtures.folder() / "runs"
        for words, message in ((("--figure-width", "5 mm"), "--figure-width 5 mm: from 60 to 400 mm"),
                               (("--figure-width", "5 s"), "--figure-width 5 s (must be a length, such as '85 mm')"),
                               (("--figure-width", "-85 mm"), "--figure-width -85 mm: from 60 to 400 mm"),
                               (("--font-size", "30"), "--font-size 30: from 4 to 24 points"),
                               (("--flow", folder / "run_0003.h5"), 'run_0003.h5: a "clogflow run" file (must be a flow.h5)')):
            made = report(folder, *words)
            self.assertEqual(made.returncode, 1, words)
            self.assertIn(message, made.stderr)
            self.assertEqual(made.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
