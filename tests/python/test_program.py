"""Running and planning through the program: what it is given, what it refuses, when it is ended."""

import os
import pathlib
import subprocess
import sys
import time
import unittest
import unittest.mock

import fixtures
import matplotlib
import matplotlib.pyplot as plt

import clogflow
from clogflow.program import overrides, written

matplotlib.use("Agg")


class Runs(unittest.TestCase):
    def setUp(self):
        self.folder = fixtures.folder()
        self.scene, self.flow = self.folder / "scene.toml", self.folder / "flow.h5"

    def test_a_run_is_what_the_program_writes(self):
        ensemble = clogflow.run(self.scene, self.folder / "again", seeds=[3, 4], flow=self.flow)
        self.assertEqual([run.seed for run in ensemble], [3, 4])
        for mine, its in zip(ensemble, clogflow.Ensemble(self.folder / "runs")):
            self.assertTrue(mine.series.equals(its.series))

    def test_overrides_reach_the_scene(self):
        ensemble = clogflow.run(self.scene, self.folder / "set", seeds=3, flow=clogflow.Flow(self.flow),
                                set={"time.end": "1 ms", "contact.friction.sliding": 0.25, "lubrication.enabled": True})
        scene = ensemble.runs[0].scene
        self.assertEqual((scene["time.end"], scene["contact.friction.sliding"], scene["lubrication.enabled"]), (1e-3, 0.25, True))

    def test_a_sweep_is_a_folder_for_every_value(self):
        sweep = clogflow.run(self.scene, self.folder / "sweep", seeds=3, flow=self.flow, set={"time.end": "1 ms"},
                             sweep={"particles.diameter": ["45 um", "50 um"]})
        diameters = {sweep.point_of(run): run.scene["particles.diameter"] for run in sweep}
        self.assertEqual(sorted(diameters.values()), [45e-6, 50e-6])
        self.assertEqual(set(sweep.series["point"]), set(diameters))
        self.assertEqual(len(sweep.statistics.groups), 2)
        figure = clogflow.figures.spatiotemporal_sweep(sweep)
        self.assertEqual(len(figure.axes[0].get_yticks()), 2)
        plt.close(figure)

    def test_a_plan_is_what_the_program_says(self):
        said = clogflow.plan(self.scene, set={"particles.diameter": "40 um"})
        straight = subprocess.run([fixtures.PROGRAM, "plan", self.scene, "--set", "particles.diameter=40 um"],
                                  capture_output=True, text=True, check=True).stdout
        # Speed and time are measured anew each time.
        self.assertEqual(said.splitlines()[:5], straight.splitlines()[:5])
        self.assertIn("2.5", said)  # D/d

    def test_refusals_are_the_programs_line(self):
        for set_, pattern in (({"particles.diameter": "3 s"}, r'particles\.diameter = "3 s" \(a time, but a length is needed'),
                              ({"particles.colour": "red"}, "particles.colour")):
            with self.assertRaisesRegex(clogflow.ProgramError, pattern) as caught:
                clogflow.plan(self.scene, set=set_)
            self.assertEqual(caught.exception.status, 1)
            self.assertNotIn("\n", str(caught.exception))
            self.assertFalse(str(caught.exception).startswith("clog: "))
        with self.assertRaisesRegex(clogflow.ProgramError, "give --flow flow.h5"):
            clogflow.run(self.scene, self.folder / "refused")
        with self.assertRaisesRegex(clogflow.ProgramError, "no verb"):
            clogflow.program.call(["frobnicate"])

    def test_what_takes_too_long_is_ended_and_goes_on(self):
        begin = time.monotonic()
        with self.assertRaisesRegex(clogflow.ProgramError, r"stopped after 1 s \(timeout\).*the same call goes on") as caught:
            clogflow.run(self.scene, self.folder / "long", seeds=3, flow=self.flow, timeout=1,
                         set={"time.end": "100 s", "output.checkpoint_interval": "60 s"})
        self.assertIsNone(caught.exception.status)
        self.assertLess(time.monotonic() - begin, 30)
        self.assertTrue(list((self.folder / "long").iterdir()))
        with self.assertRaisesRegex(clogflow.ProgramError, "no run has ended yet"):
            clogflow.run(self.scene, self.folder / "long", seeds=3, flow=self.flow, time_limit="0.5 s",
                         set={"time.end": "100 s", "output.checkpoint_interval": "60 s"})

    def test_a_program_that_does_not_stop_is_killed(self):
        deaf = self.folder / "deaf"
        deaf.write_text("#!/bin/sh\ntrap '' TERM\nwhile :; do sleep 0.1; done\n")
        deaf.chmod(0o755)
        with unittest.mock.patch("clogflow.program.TIME_TO_SAVE", 0.5), self.assertRaises(clogflow.ProgramError):
            clogflow.program.call([], program=deaf, timeout=0.5)


class Finding(unittest.TestCase):
    def test_the_argument_before_the_environment(self):
        with unittest.mock.patch.dict(os.environ, {"CLOG": "/nowhere/clog"}):
            self.assertEqual(clogflow.find_program(fixtures.PROGRAM), pathlib.Path(fixtures.PROGRAM))
            with self.assertRaisesRegex(clogflow.ProgramError, "/nowhere/clog: no program there .the environment's CLOG."):
                clogflow.find_program()

    def test_another_program_of_that_name_is_passed_over(self):
        """As Debian's log viewer."""
        other = fixtures.folder() / "other_bin"
        other.mkdir()
        (other / "clog").write_text("#!/bin/sh\necho 'colorized log tail'\n")
        (other / "clog").chmod(0o755)
        nothing = fixtures.folder() / "nothing/share"
        with unittest.mock.patch.dict(os.environ, {"PATH": str(other), "CLOG": ""}), \
             unittest.mock.patch("clogflow.program.TOP", nothing):
            with self.assertRaisesRegex(clogflow.ProgramError, "the program clog was not found: build it"):
                clogflow.find_program()
            (other / "clogflow").symlink_to(fixtures.PROGRAM)
            self.assertEqual(clogflow.find_program(), other / "clogflow")

    def test_values_as_the_program_reads_them(self):
        self.assertEqual(overrides("--set", {"a.b": True, "c": 0.1, "d": "3 um", "e": []}),
                         ["--set", "a.b=true", "--set", "c=0.1", "--set", "d=3 um", "--set", "e=[]"])
        self.assertEqual(written(["x = 1 m", 2]), '["x = 1 m", 2]')


class Figures(unittest.TestCase):
    def test_each_is_drawn_and_the_settings_stay(self):
        ensemble = clogflow.Ensemble(fixtures.known())
        plt.figure()  # so that the backend is chosen
        plt.close("all")
        before = dict(matplotlib.rcParams)
        for draw, panels in ((clogflow.figures.bursts, 1), (clogflow.figures.lapses, 2), (clogflow.figures.spatiotemporal, 1),
                             (clogflow.figures.series, 3)):
            figure = draw(ensemble)
            self.assertEqual(len(figure.axes), panels, draw.__name__)
            self.assertEqual(plt.get_fignums(), [figure.number])
            plt.close(figure)
        self.assertGreater(len(clogflow.figures.snapshots(ensemble.runs[0]).axes), 1)
        plt.close("all")
        self.assertEqual(before, dict(matplotlib.rcParams))
        self.assertFalse({"style", "channel", "run_file"} & set(sys.modules))

    def test_they_are_those_of_the_report(self):
        """Drawn here and saved as the report does, they have its bytes."""
        statistics = clogflow.Statistics(fixtures.folder() / "stats")
        report = fixtures.folder() / "report"
        subprocess.run(["/usr/bin/python3", "-B", fixtures.ROOT / "postprocess/figures/make_report.py", statistics.folder, report],
                       check=True, capture_output=True, cwd=fixtures.folder())
        out = fixtures.folder() / "mine"
        out.mkdir()
        here = os.getcwd()
        os.chdir(fixtures.folder())  # stats.json names run files as they were given
        try:
            for name in ("series", "spatiotemporal"):
                for path in clogflow.figures.save(getattr(clogflow.figures, name)(statistics), out, name):
                    self.assertEqual(path.read_bytes(), (report / path.name).read_bytes(), path.name)
        finally:
            os.chdir(here)

    def test_what_there_is_none_of(self):
        with self.assertRaisesRegex(clogflow.ClogflowError, r"no figure 'first_burst' of these runs \(drawn are: none\)"):
            clogflow.figures.first_burst(clogflow.Ensemble(fixtures.known()))

    def test_scripts_that_are_not_there(self):
        clogflow.figures.scripts.cache_clear()
        with unittest.mock.patch.dict(os.environ, {"CLOG_FIGURES": "/nowhere"}), \
             self.assertRaisesRegex(clogflow.FileError, "/nowhere: no figure scripts there"):
            clogflow.figures.scripts()


if __name__ == "__main__":
    unittest.main()
